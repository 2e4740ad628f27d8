// The constants of transfer_apply in stages (codegen/runtime/transfer_rings.hpp): the quadrature of recipes/product/transfer,
// whose orders are scaled by their values at the first angle, phi_0 = pi / 4n.
#pragma once

#include "codegen/recipes/product/ring_quadrature.hpp"

namespace sh::codegen::recipes {

class TransferRings {
 public:
  /// n: the degree of light and result; that of the visibility is 2n.
  explicit TransferRings(int degree) : n_(degree), rings_(Rings{degree, true, false}) {}

  /// From coefficient (l, +-m) of the visibility to its order on a pair of rings, times cos or sin of m phi_0.
  [[nodiscard]] ExactReal theta(bool is_sine, int l, int m, int pair) const;
  /// From order m of the products on both rings of a pair to the coefficient of the result: the same times the weight.
  [[nodiscard]] ExactReal result(bool is_sine, int l, int m, int pair) const;
  /// The same for the poles.
  [[nodiscard]] ExactReal pole(int l) const { return rings_.theta(l, 0, n_); }
  [[nodiscard]] ExactReal pole_result(int l) const;
  /// cos(m phi_j) / cos(m phi_0), or of sines; 0 where the divisor is.
  [[nodiscard]] ExactReal ratio(bool is_sine, int m, int j) const;
  [[nodiscard]] std::string definition() const { return rings_.definition(); }

 private:
  [[nodiscard]] ExactReal phase(bool is_sine, int m, int j) const;

  int n_;
  RingQuadrature rings_;
};

}  // namespace sh::codegen::recipes
