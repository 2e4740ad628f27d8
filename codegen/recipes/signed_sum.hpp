// Sums with exact coefficients and without negations: a value carries its sign until a sum or difference takes it.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// A node or its negative.
struct Signed {
  NodeId node = -1;
  bool negative = false;

  [[nodiscard]] Signed operator-() const { return {node, !negative}; }
};

/// factor * value. A factor of 1 or -1 needs no operation. The factor must not be zero.
Signed scaled(Builder& build, const symbolic::Surd& factor, Signed value, const std::string& name = {});

/// a * b
Signed product(Builder& build, Signed a, Signed b);

/// The sum of at least one value, from left to right. Its sign is negative only if all values are negative.
Signed sum(Builder& build, const std::vector<Signed>& values, const std::string& name = {});

/// The sum of factors[i] * values[i]. Zero factors drop out; at least one factor has to be nonzero.
Signed weighted_sum(Builder& build, const std::vector<symbolic::Surd>& factors, const std::vector<Signed>& values,
                    const std::string& name = {});

/// A node with the value; a negation if the value is negative.
NodeId settled(Builder& build, Signed value);

}  // namespace sh::codegen::recipes
