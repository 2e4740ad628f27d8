// Converts trigonometric polynomials of the longitude from coefficients to samples (and back, transposed) by short
// circuits.
//
// The samples lie at phi_j = 2 pi j / M, j = 0 .. M/4, or half a step further at phi_j = 2 pi (j + 1/2) / M,
// j = 0 .. M/4 - 1, M a multiple of 4. Parity splits them into four parts: even or
// odd orders, cosines or sines. The four parts at phi_j give the values at +-phi_j and pi +- phi_j, and multiply like
// the group Z2 x Z2. A recipe multiplies its coefficients by constants in any case. Their scales are therefore free,
// and the transform chooses them for the shortest circuits.
#pragma once

#include <array>
#include <vector>

#include "codegen/recipes/linear_circuit.hpp"

namespace sh::codegen::recipes {

/// The number of parts. In the number of a part, bit 0 is set for sines and bit 1 for odd orders; the product of parts
/// p and q is part p ^ q.
inline constexpr int kParts = 4;
constexpr int part_of(int order) { return (order < 0 ? 1 : 0) + (order % 2 == 0 ? 0 : 2); }

/// The shape of a transform.
struct PhiShape {
  int degree = 0;             ///< orders -degree .. degree
  int angles = 0;             ///< M
  int rings = 1;              ///< 1 or 2; two rings share the coefficients of order +-degree
  bool half_at_ends = false;  ///< the samples at j = 0 and M/4 count half
  /// Scales that save operations outside the transform: order -> (scale, extra operations of any other scale).
  std::map<int, std::pair<ExactReal, int>> preferred;
  std::vector<int> unscaled;  ///< orders (>= 0) whose cosine and sine keep their scale
  bool half_step = false;     ///< the samples lie half a step further; none of them is an end
};

/// The transform of one shape.
class PhiTransform {
 public:
  explicit PhiTransform(const PhiShape& shape);

  /// The factor that the caller has to apply to the coefficient of an order.
  [[nodiscard]] const ExactReal& scale(int order) const;
  /// True if both rings share the coefficient.
  [[nodiscard]] bool shared(int order) const { return shape_.rings == 2 && std::abs(order) == shape_.degree; }

  /// coefficients: by ring, then by order + degree, scaled; the first ring holds shared coefficients. Returns samples
  /// by ring, then by j, then by part.
  using Samples = std::vector<std::vector<std::array<Value, kParts>>>;
  using Coefficients = std::vector<std::vector<Value>>;
  [[nodiscard]] Samples sample(SignedBuilder& build, const Coefficients& coefficients) const;
  /// The transposed map; shared coefficients are the sum over both rings.
  [[nodiscard]] Coefficients analyze(SignedBuilder& build, const Samples& samples) const;

 private:
  struct Column {
    int ring = 0;
    int order = 0;
  };
  [[nodiscard]] int samples() const { return shape_.angles / 4 + (shape_.half_step ? 0 : 1); }
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
