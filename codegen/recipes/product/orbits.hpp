// A quadrature on orbits of (+-x, +-y, +-z), for products of two functions with one orbit in each SIMD lane.
//
// Y_i has a parity under each reflection; its class p is the triple of them. On an orbit a function is eight numbers
// A_p, the sums over each class of c_i Y_i at the orbit's point with x, y, z >= 0, and a product is h_r = sum_p A_p
// B_(p^r). The integral of h Y_i over the sphere is a sum over the orbits of weight Y_i h_r(i). Rings of constant z as
// in ring_quadrature.hpp, on each of them equally spaced angles phi_j = (j + 1/2) 2 pi / M: both are exact for the
// product of three functions.
#pragma once

#include <array>
#include <vector>

#include "codegen/recipes/product/ring_quadrature.hpp"

namespace sh::codegen::recipes {

/// Coefficients of four classes, one of each class; -1: that class has none left.
using ClassRow = std::array<int, 4>;

class OrbitQuadrature {
 public:
  /// For products of two functions of `degree` at most, projected on the same bands.
  explicit OrbitQuadrature(int degree);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] int count() const { return static_cast<int>(orbits_.size()); }
  /// Y_i at the orbit's point with x, y, z >= 0.
  [[nodiscard]] ExactReal value(int i, int orbit) const;
  /// Sum of the weights of the orbit's points.
  [[nodiscard]] ExactReal weight(int orbit) const;
  /// The classes 1, y, z, x, then their opposites xyz, xz, xy, yz: opposite ones differ in all three parities, that is
  /// under the inversion.
  [[nodiscard]] const std::vector<ClassRow>& rows(bool opposite) const { return opposite ? opposite_rows_ : rows_; }
  /// For people: which points.
  [[nodiscard]] std::string definition() const;

 private:
  struct Orbit {
    int ring = 0;
    int angle = 0;  // j
  };

  int degree_;
  int angles_;  // M
  RingQuadrature rings_;
  std::vector<Orbit> orbits_;
  std::vector<ClassRow> rows_;
  std::vector<ClassRow> opposite_rows_;
};

}  // namespace sh::codegen::recipes
