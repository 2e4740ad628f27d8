// Sums with exact coefficients, written without negations: a value carries its sign until a sum or difference takes it.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// The value of a node, or minus it.
struct Signed {
  NodeId node = -1;
  bool negative = false;

  [[nodiscard]] Signed operator-() const { return {node, !negative}; }
};

/// factor * value; no operation for a factor of 1 or -1. The factor must not be zero.
Signed scaled(Builder& build, const symbolic::Surd& factor, Signed value, const std::string& name = {});

/// a * b
Signed product(Builder& build, Signed a, Signed b);

/// The sum of at least one value, from the left; negative only when all of them are.
Signed sum(Builder& build, const std::vector<Signed>& values, const std::string& name = {});

/// sum of factors[i] * values[i]; zero factors drop out, at least one has to stay.
Signed weighted_sum(Builder& build, const std::vector<symbolic::Surd>& factors, const std::vector<Signed>& values,
                    const std::string& name = {});

/// A node with the value itself: a negation where it cannot be avoided.
NodeId settled(Builder& build, Signed value);

}  // namespace sh::codegen::recipes
