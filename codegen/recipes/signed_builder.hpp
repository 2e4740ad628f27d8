// Appends sums and products of values that carry a sign, so that negations and zeros need no operation.
//
// It serves recipes that add many terms with constants of either sign. A subtraction costs as much as an addition. A
// negation remains only where a result itself is the negative of a node.
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
};

/// Appends nodes to a kernel.
class SignedBuilder {
 public:
  explicit SignedBuilder(Kernel& kernel) : kernel_(kernel), build_(kernel) {}

  Value input(int index, std::string name = {}) { return {build_.input(index, std::move(name))}; }
  /// Elements first .. first + count - 1 of the flattened parameters.
  std::vector<Value> inputs(int first, int count);
  Value times(Value a, Value b);
  Value times(const ExactReal& factor, Value a);
  /// The same, but if `a` is a constant times a value, one product with both constants replaces it.
  Value times_once(const ExactReal& factor, Value a);
  Value plus(Value a, Value b);
  Value minus(Value a, Value b) { return plus(a, opposite(b)); }
  /// Adds the terms one after the other. The sum starts with a positive term if there is one.
  Value sum(const std::vector<Value>& terms);
  /// An element of the table's current row.
  Value table(int column) { return {build_.table(column)}; }
  /// The sum of a value over all rows of the table.
  Value row_sum(Value a) { return a.is_zero() ? a : Value{build_.row_sum(a.node), a.negative}; }
  /// Adds the terms by halves. For many terms this gives a short chain and a small rounding error.
  Value balanced_sum(const std::vector<Value>& terms);
  static Value opposite(Value a) { return {a.node, !a.negative}; }
  /// Gives the node a name for readers; a zero has no name.
  Value named(Value a, std::string name);
  /// The node with the value: a constant for zero, a new negation for a negative value.
  NodeId node(Value a);

 private:
  Kernel& kernel_;
  Builder build_;
};

}  // namespace sh::codegen
