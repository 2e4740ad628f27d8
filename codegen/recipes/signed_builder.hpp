// Appends sums and products of values that carry a sign, so that no operation is spent on negations or zeros.
//
// It is for recipes that add many terms with constants of either sign. A subtraction costs as much as an addition. A
// negation is left over only where a result itself is the negative of a node.
#pragma once

#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// A node or its negative; zero when there is no node.
struct Value {
  NodeId node = -1;
  bool negative = false;
  [[nodiscard]] bool is_zero() const { return node < 0; }
};

class SignedBuilder {
 public:
  explicit SignedBuilder(Kernel& kernel) : kernel_(kernel), build_(kernel) {}

  Value input(int index, std::string name = {}) { return {build_.input(index, std::move(name))}; }
  /// Elements first .. first + count - 1 of the flattened parameters.
  std::vector<Value> inputs(int first, int count);
  Value times(Value a, Value b);
  Value times(const ExactReal& factor, Value a);
  /// The same as one product where `a` is itself a constant times a value: the two constants are made one.
  Value times_once(const ExactReal& factor, Value a);
  Value plus(Value a, Value b);
  Value minus(Value a, Value b) { return plus(a, opposite(b)); }
  /// One after the other, beginning with one that needs no negation where there is one.
  Value sum(const std::vector<Value>& terms);
  /// The element of the table's current row, and the sum of a value over all rows.
  Value table(int column) { return {build_.table(column)}; }
  Value row_sum(Value a) { return a.is_zero() ? a : Value{build_.row_sum(a.node), a.negative}; }
  /// By halves: a short chain and little rounding error for many terms.
  Value balanced_sum(const std::vector<Value>& terms);
  static Value opposite(Value a) { return {a.node, !a.negative}; }
  /// Gives the node a name for readers; zeros have none.
  Value named(Value a, std::string name);
  /// The plain node: a constant for zero, a negation where one is left over.
  NodeId node(Value a);

 private:
  Kernel& kernel_;
  Builder build_;
};

}  // namespace sh::codegen
