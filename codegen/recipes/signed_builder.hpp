// Appends sums and products of values that carry a sign, so that negations and zeros need no operation.
//
// A subtraction costs as much as an addition. A negation remains only where a result itself is the negative of a node.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// A node or its negative; without a node it is zero.
struct Value {
  NodeId node = -1;
  bool negative = false;
  [[nodiscard]] bool is_zero() const { return node < 0; }
  [[nodiscard]] Value operator-() const { return {node, !negative}; }
};

/// Appends nodes to a kernel.
class SignedBuilder : public Builder {
 public:
  explicit SignedBuilder(Kernel& kernel) : Builder(kernel), kernel_(kernel) {}

  /// Elements first .. first + count - 1 of the flattened parameters.
  std::vector<Value> inputs(int first, int count);
  Value times(Value a, Value b);
  /// A factor of 1 or -1 needs no operation.
  Value times(const ExactReal& factor, Value a);
  /// The same, but if `a` is a constant times a value, one product with both constants replaces it.
  Value times_once(const ExactReal& factor, Value a);
  Value plus(Value a, Value b);
  Value minus(Value a, Value b) { return plus(a, -b); }
  /// Adds the terms one after the other. The sum starts with a positive term if there is one. name: for a sum of more
  /// than one term.
  Value sum(const std::vector<Value>& terms, const std::string& name = {});
  /// Adds the terms by halves. For many terms this gives a short chain and a small rounding error.
  Value balanced_sum(const std::vector<Value>& terms);
  /// The sum of a value over all rows of the table.
  Value row_sum(Value a) { return a.is_zero() ? a : Value{Builder::row_sum(a.node), a.negative}; }
  /// A constant. Its node has no sign, but its value has.
  Value fixed(const ExactReal& exact, const std::string& name = {});
  /// Gives the node a name for readers; a zero has no name.
  Value named(Value a, std::string name);
  /// The node with the value: a constant for zero, a new negation for a negative value.
  NodeId node(Value a);

 private:
  Kernel& kernel_;
};

}  // namespace sh::codegen
