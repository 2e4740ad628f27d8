// Trigonometric polynomials of the longitude, from coefficients to samples (and back, transposed), as short circuits.
//
// Samples are taken at phi_j = 2 pi j / M, j = 0 .. M/4, M a multiple of 4, split by parity: functions of even or odd
// order, cosines or sines. The four parts at phi_j give the values at +-phi_j and pi +- phi_j, and multiply like the
// group Z2 x Z2. The recipe that makes the coefficients multiplies them by constants anyway, so their scales are free
// and are chosen for the shortest circuits.
#pragma once

#include <array>
#include <vector>

#include "codegen/recipes/linear_circuit.hpp"

namespace sh::codegen::recipes {

/// Parts: bit 0 is set for sines, bit 1 for odd orders; the product of parts p and q is part p ^ q.
inline constexpr int kParts = 4;
constexpr int part_of(int order) { return (order < 0 ? 1 : 0) + (order % 2 == 0 ? 0 : 2); }

/// The shape of a transform.
struct PhiShape {
  int degree = 0;             ///< orders -degree .. degree
  int angles = 0;             ///< M
  int rings = 1;              ///< 1, or 2 which share the coefficients of order +-degree
  bool half_at_ends = false;  ///< the samples at j = 0 and M/4 count half
  /// Costs of operations outside that a scale other than this one brings: order -> (scale, operations).
  std::map<int, std::pair<ExactReal, int>> preferred;
  std::vector<int> unscaled;  ///< orders (>= 0) whose cosine and sine keep their scale
};

class PhiTransform {
 public:
  explicit PhiTransform(const PhiShape& shape);

  /// The factor by which the coefficient of an order has to be multiplied.
  [[nodiscard]] const ExactReal& scale(int order) const;
  /// True when both rings share the coefficient.
  [[nodiscard]] bool shared(int order) const { return shape_.rings == 2 && std::abs(order) == shape_.degree; }

  /// coefficients: by ring, then by order + degree, scaled; shared ones in the first ring.
  /// Returns samples by ring, then by j, then by part.
  using Samples = std::vector<std::vector<std::array<Value, kParts>>>;
  using Coefficients = std::vector<std::vector<Value>>;
  [[nodiscard]] Samples sample(SignedBuilder& build, const Coefficients& coefficients) const;
  /// The transposed map; shared coefficients are the sum over both rings.
  [[nodiscard]] Coefficients analyse(SignedBuilder& build, const Samples& samples) const;

 private:
  struct Column {
    int ring = 0;
    int order = 0;
  };
  [[nodiscard]] int samples() const { return shape_.angles / 4 + 1; }
  [[nodiscard]] std::vector<int> orders_of(int part) const;
  [[nodiscard]] ExactReal entry(int order, int j) const;
  [[nodiscard]] LinearMap matrix(int part) const;
  [[nodiscard]] int cost(int part, int attempts) const;
  [[nodiscard]] std::vector<ExactReal> candidate_scales(int order) const;
  void choose_scales(int part);

  PhiShape shape_;
  std::vector<ExactReal> scales_;  // by order + degree
  std::array<std::vector<Column>, kParts> columns_;
  std::array<LinearCircuit, kParts> circuits_;
};

}  // namespace sh::codegen::recipes
