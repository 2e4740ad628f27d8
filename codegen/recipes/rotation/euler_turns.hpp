// Cosines and sines of the multiples of the Euler angles of a rotation, R = Rz(alpha) Ry(beta) Rz(gamma), no angle
// formed and no hole at beta = 0 or pi (symbolic/rotation/rotation_input.hpp proves the formula).
//
// The error of a multiple comes from the distance of (cos, sin) from the unit circle: 1 - 2 s^2 multiplies it by up to
// 4, c^2 - s^2 by 2, and a double angle that does not go through a square root has none to multiply. So alpha's
// double angle comes from 2 / (r02^2 + r12^2), beta's from sin^2 = r02^2 + r12^2, and gamma's is balanced.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "codegen/recipes/signed_sum.hpp"

namespace sh::codegen::recipes {

/// Cosine and sine of k = 1, 2, ... times an angle about z.
struct Turn {
  std::map<int, NodeId> cosine;
  std::map<int, NodeId> sine;
};

/// factor * node. The product is left to a recipe that has another constant to multiply.
struct Multiple {
  symbolic::Surd factor{1};
  NodeId node = -1;
};

/// The same of beta, with the versines 1 - cos of even k. The cosine of the highest k, if even, is left out: where it
/// is used once, the versine serves as well.
struct Tilt {
  std::map<int, NodeId> cosine;
  std::map<int, Multiple> sine;
  std::map<int, Multiple> versine;
};

struct EulerTurns {
  Turn alpha;
  Tilt beta;
  Turn gamma;
};

/// Multiples 1 .. most (at least 2) of the angles of r (3x3, row-major).
EulerTurns euler_turns(Builder& build, const std::array<NodeId, 9>& r, int most);

/// Multiples 1 .. most (at least 1) of the angles of a unit quaternion (w, x, y, z): with a = w + iz and b = y - ix,
/// e^(i alpha) = ab / |ab|, e^(i gamma) = a conj(b) / |ab|, cos beta = |a|^2 - |b|^2, sin beta = 2 |ab|; a or b counts
/// as 1 where it is 0.
EulerTurns euler_turns(Builder& build, const std::array<NodeId, 4>& q, int most);

/// Multiples 1 .. most of an angle about z from its cosine and sine, most of them by e_k = 2 cos a e_(k-1) - e_(k-2) or
/// all of them as products of two others, which costs more and errs less.
Turn turn_by_steps(Builder& build, NodeId cosine, NodeId sine, int most);
Turn turn_by_products(Builder& build, NodeId cosine, NodeId sine, int most);

/// A band (element l + m) turned about z: for m > 0, (v_m, v_-m) -> (cos v_m - sin v_-m, sin v_m + cos v_-m).
/// name: of the results, v_2_1c and v_2_1s.
void turn_about_z(Builder& build, const Turn& turn, int degree, std::vector<Signed>& band, const std::string& name);

}  // namespace sh::codegen::recipes
