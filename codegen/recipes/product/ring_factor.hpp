// The constants of the rings of a quadrature, in kernels with and without a loop over the pairs of rings.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/recipes/product/ring_quadrature.hpp"
#include "codegen/recipes/signed_builder.hpp"

namespace sh::codegen::recipes {

/// One element for a single ring; one element for each pair of rings if a loop runs over the pairs.
using Factor = std::vector<ExactReal>;

/// Arithmetic element by element.
Factor times(Factor factor, const ExactReal& scale);
Factor times(Factor factor, const Factor& other);
Factor quotient(Factor factor, const Factor& divisor);

/// The approximate absolute value of the smallest element.
double smallest_size(const Factor& factor);

/// The constants of one kernel. looped: a loop runs over the pairs, and ring 0 stands for all of them.
class RingFactors {
 public:
  RingFactors(Kernel& kernel, const RingQuadrature& quadrature, bool looped)
      : kernel_(kernel), quadrature_(quadrature), looped_(looped) {}

  [[nodiscard]] Factor one(int ring) const;
  [[nodiscard]] Factor theta(int l, int m, int ring) const;
  [[nodiscard]] Factor weight(int ring) const;
  /// The value times the factor; the kernel's table holds factors of all pairs.
  Value scaled(SignedBuilder& build, const Factor& factor, Value value);

 private:
  template <class Of>
  [[nodiscard]] Factor of_rings(int ring, const Of& of) const;

  Kernel& kernel_;
  const RingQuadrature& quadrature_;
  bool looped_;
  std::map<std::string, int> columns_;  // of the loop's table, by the constants in them
};

}  // namespace sh::codegen::recipes
