// A quadrature on orbits of (+-x, +-y, +-z), for products of two functions. Each SIMD lane holds one orbit.
//
// Y_i has a parity under each reflection; the triple of its parities is its class p. On an orbit, eight numbers A_p
// represent a function: the sums over each class of c_i Y_i at the orbit's point with x, y, z >= 0. A product is
// h_r = sum_p A_p B_(p^r). The integral of h Y_i over the sphere is a sum over the orbits of weight Y_i h_r(i). The
// orbits lie on the rings of constant z of ring_quadrature.hpp, at equally spaced angles phi_j = (j + 1/2) 2 pi / M.
// The quadrature is exact for the product of three functions.
#pragma once

#include <array>
#include <vector>

#include "codegen/recipes/product/ring_quadrature.hpp"

namespace sh::codegen::recipes {

/// Four coefficients, one from each of four classes; -1: the class has no further coefficient.
using ClassRow = std::array<int, 4>;

/// The points, values and weights of the quadrature.
class OrbitQuadrature {
 public:
  /// Serves products of two functions of at most `degree`, projected on the same bands.
  explicit OrbitQuadrature(int degree);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] int count() const { return static_cast<int>(orbits_.size()); }
  /// Y_i at the orbit's point with x, y, z >= 0.
  [[nodiscard]] ExactReal value(int i, int orbit) const;
  /// The sum of the weights of the orbit's points.
  [[nodiscard]] ExactReal weight(int orbit) const;
  /// The classes 1, y, z, x, or their opposites xyz, xz, xy, yz. Opposite classes differ in all three parities.
  [[nodiscard]] const std::vector<ClassRow>& rows(bool opposite) const { return opposite ? opposite_rows_ : rows_; }
  /// A description of the points.
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
