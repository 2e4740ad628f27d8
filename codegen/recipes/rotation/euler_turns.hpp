// Computes cosines and sines of the multiples of the Euler angles of a rotation, R = Rz(alpha) Ry(beta) Rz(gamma). It
// computes no angle and works at beta = 0 and pi too (symbolic/rotation/rotation_input.hpp proves the formula).
//
// The error of a multiple comes from the distance of (cos, sin) from the unit circle. The form 1 - 2 s^2 multiplies
// this distance by up to 4, the form c^2 - s^2 by 2. A double angle that needs no square root starts without this
// error. Therefore the double angle of gamma comes from 2 / (r20^2 + r21^2), the double angle of beta from
// sin^2 = r20^2 + r21^2, and the double angle of alpha has the balanced form c^2 - s^2. Of the two ways to write R, this is
// the one with beta = -b, b from 0 to pi.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "codegen/recipes/signed_builder.hpp"

namespace sh::codegen::recipes {

/// Cosine and sine of k = 1, 2, ... times an angle about z.
struct Turn {
  std::map<int, NodeId> cosine;
  std::map<int, NodeId> sine;
  bool backwards = false;  ///< by minus this angle
};

/// factor * node. The recipe combines the factor with its own constants.
struct Multiple {
  symbolic::Surd factor{1};
  NodeId node = -1;
};

/// Cosine and sine of k beta, and the versines 1 - cos for even k. The cosine of the highest k is missing if this k is
/// even: a recipe that uses it once can use the versine.
struct Tilt {
  std::map<int, NodeId> cosine;
  std::map<int, Multiple> sine;
  std::map<int, Multiple> versine;
};

/// The multiples of all three angles.
struct EulerTurns {
  Turn alpha;
  Tilt beta;
  Turn gamma;
};

/// Multiples 1 .. most (at least 2) of the angles of r (3x3, row-major).
EulerTurns euler_turns(SignedBuilder& build, const std::array<NodeId, 9>& r, int most);

/// Multiples 1 .. most (at least 1) of the angles of a unit quaternion (w, x, y, z). With a = w + iz and b = y - ix:
/// e^(i alpha) = ab / |ab|, e^(i gamma) = a conj(b) / |ab|, cos beta = |a|^2 - |b|^2, sin beta = 2 |ab|. If a or b is
/// 0, it counts as 1.
EulerTurns euler_turns(SignedBuilder& build, const std::array<NodeId, 4>& q, int most);

/// Multiples 1 .. most of an angle about z from its cosine and sine, mostly by e_k = 2 cos a e_(k-1) - e_(k-2).
Turn turn_by_steps(SignedBuilder& build, NodeId cosine, NodeId sine, int most);
/// The same with every multiple as a product of two others. It needs more operations and has a smaller error.
Turn turn_by_products(SignedBuilder& build, NodeId cosine, NodeId sine, int most);

/// Turns a band (element l + m) about z: for m > 0, (v_m, v_-m) -> (cos v_m - sin v_-m, sin v_m + cos v_-m).
/// name: the first letters of the results, as in v_2_1c and v_2_1s.
void turn_about_z(SignedBuilder& build, const Turn& turn, int degree, std::vector<Value>& band,
                  const std::string& name);

}  // namespace sh::codegen::recipes
