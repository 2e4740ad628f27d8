// A quadrature on rings of constant z, symmetric about the equator, with exactly defined constants.
//
// The rings are n pairs at heights +-z_1 > +-z_2 > ..., optionally with the two poles and the equator. With t = z^2,
// the heights of the pairs are the zeros of the Jacobi polynomial P_n^(pole, equator - 1/2)(2t - 1). The weights
// integrate every even polynomial of z of degree 2 (2n + pole + equator - 1) exactly over -1 .. 1 (Gauss, Radau and
// Lobatto rules without their odd half, [AbramowitzStegun64] 25.4.29 to 25.4.32).
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "codegen/ir/exact_real.hpp"

namespace sh::codegen::recipes {

/// The rings of a quadrature.
struct Rings {
  int pairs = 0;
  bool pole = false;
  bool equator = false;
};

/// The constants of a quadrature.
class RingQuadrature {
 public:
  explicit RingQuadrature(const Rings& rings) : rings_(rings) {}

  [[nodiscard]] const Rings& rings() const { return rings_; }
  /// The number of rings. Their order: pairs 0 .. pairs-1, then the poles, then the equator.
  [[nodiscard]] int count() const { return rings_.pairs + (rings_.pole ? 1 : 0) + (rings_.equator ? 1 : 0); }
  [[nodiscard]] bool is_pole(int ring) const { return rings_.pole && ring == rings_.pairs; }
  [[nodiscard]] bool is_equator(int ring) const { return rings_.equator && ring == count() - 1; }

  /// Y_lm at the ring, without its cosine or sine of the longitude; zero is a surd.
  [[nodiscard]] ExactReal theta(int l, int m, int ring) const;
  /// The weight of one ring; both rings of a pair have this weight.
  [[nodiscard]] ExactReal weight(int ring) const;
  /// A description of the values of z1, z2, ...
  [[nodiscard]] std::string definition() const;

 private:
  Rings rings_;
};

/// The approximate absolute value.
inline double approximate(const ExactReal& value) { return std::abs(cln::double_approx(evaluate(value, 20))); }

/// cos(2 pi numerator / denominator); the denominator has to be a multiple of 4.
ExactReal cosine(int numerator, int denominator);
/// sin(2 pi numerator / denominator); the denominator has to be a multiple of 4.
ExactReal sine(int numerator, int denominator);
/// pi numerator / denominator
ExactReal pi_times(int numerator, int denominator);

}  // namespace sh::codegen::recipes
