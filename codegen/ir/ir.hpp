// The kernel IR: straight-line code in static single assignment form.
//
// A Kernel computes flat arrays of results from scalar or array parameters by a list of nodes, each of which refers to
// earlier nodes only. It supports inputs, exact real constants, negation, addition, subtraction, multiplication,
// fused multiply-add and, for the few recipes that need them, division, square root and selection. It deliberately does
// not support control flow, memory, calls or types: a kernel means the same in every scalar type and language, and the
// printer chooses the type. Constants stay exact until a printer rounds them (codegen/ir/literal.hpp).
//
// One counted loop is possible, for code that would outgrow the instruction cache: a kernel with a table of constants
// has nodes kTable, an element of the table's current row, and kRowSum, the sum of a value over all rows. Values that
// depend on the row and on no sum are the body of the loop; all others are computed once, before it or after it.
//
// Names are hints for readers, never identity. Nodes that reach no output are allowed (passes leave them behind,
// `prune` drops them) and cost nothing.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "codegen/ir/exact_real.hpp"
#include "codegen/ir/role.hpp"

namespace sh::codegen {

enum class Op { kInput, kConstant, kNeg, kAdd, kSub, kMul, kFma, kDiv, kSqrt, kSelect, kTable, kRowSum };

using NodeId = int;  ///< position in Kernel::nodes

struct Node {
  Op op = Op::kInput;
  /// kFma is args[0] * args[1] + args[2]; kSelect is args[0] < args[1] ? args[2] : args[3]
  std::array<NodeId, 4> args{-1, -1, -1, -1};
  int input = -1;      ///< kInput: position among the flattened parameters; kTable: column of the table
  ExactReal constant;  ///< kConstant
  std::string name;    ///< a hint such as "p_4_2"; may be empty
};

struct Output {
  NodeId node = -1;
  std::string label;  ///< the meaning of the value, e.g. "l=2 m=-1"
  int element = -1;   ///< which of the flattened results it is; -1: as many as there are outputs before it
};

struct Kernel {
  std::string name;    ///< "basis_l4", the same in every language
  std::string family;  ///< "basis"
  int degree = 0;
  std::string arguments;  ///< of `shgen emit` that give this kernel: "basis --degree 4"
  std::string recipe;     ///< which way of computing the family
  std::string citation;   ///< where the way comes from
  std::string title;      ///< one line: the functions that are computed
  std::string domain;     ///< the conditions on the inputs
  std::string result;     ///< the outputs, their order and convention
  bool factored = false;  ///< the recipe chose the forms of its polynomials: the pass `factor` leaves them alone
  std::vector<Parameter> parameters;
  std::vector<Parameter> results;  ///< arrays, or one scalar; a result named as a parameter is updated in place
  std::vector<Node> nodes;
  std::vector<Output> outputs;                ///< the flattened results, in order; those left out are not written
  std::vector<std::vector<ExactReal>> table;  ///< rows of constants that the loop runs over; empty: no loop

  /// True when the only result is a scalar, which functions return.
  [[nodiscard]] bool returns_scalar() const { return results.size() == 1 && results[0].shape.empty(); }
  /// Which of the flattened results an output is.
  [[nodiscard]] int element(std::size_t output) const {
    return outputs[output].element < 0 ? static_cast<int>(output) : outputs[output].element;
  }
  [[nodiscard]] const Node& node(NodeId id) const { return nodes[static_cast<std::size_t>(id)]; }
  [[nodiscard]] NodeId size() const { return static_cast<NodeId>(nodes.size()); }
};

int argument_count(Op op);
/// When a node is computed: before the loop (also when there is none), for every row of the table, after the loop.
enum class Phase { kBefore, kBody, kAfter };
/// By node. Throws std::logic_error for a sum of a value that depends on no row, or on a sum and a row.
std::vector<Phase> phases(const Kernel& kernel);
/// Printable name of an operation: "mul".
std::string op_name(Op op);
/// For every node, whether an output depends on it.
std::vector<bool> live_nodes(const Kernel& kernel);
/// The kernel with the nodes listed in `order` (earlier ones first, arguments before users) and no others.
Kernel with_order(const Kernel& kernel, const std::vector<NodeId>& order);
/// Throws std::logic_error when a node refers forward or an output to nothing; the message names the kernel.
void require_well_formed(const Kernel& kernel);

/// Appends nodes to a kernel.
class Builder {
 public:
  explicit Builder(Kernel& kernel) : kernel_(kernel) {}
  NodeId append(Node node);
  NodeId input(int index, std::string name);
  NodeId constant(ExactReal value, std::string name = {});
  NodeId neg(NodeId a, std::string name = {}) { return operation(Op::kNeg, {a, -1, -1, -1}, std::move(name)); }
  NodeId add(NodeId a, NodeId b, std::string name = {}) { return operation(Op::kAdd, {a, b, -1, -1}, std::move(name)); }
  NodeId sub(NodeId a, NodeId b, std::string name = {}) { return operation(Op::kSub, {a, b, -1, -1}, std::move(name)); }
  NodeId mul(NodeId a, NodeId b, std::string name = {}) { return operation(Op::kMul, {a, b, -1, -1}, std::move(name)); }
  NodeId fma(NodeId a, NodeId b, NodeId c, std::string name = {}) {
    return operation(Op::kFma, {a, b, c, -1}, std::move(name));
  }
  NodeId div(NodeId a, NodeId b, std::string name = {}) { return operation(Op::kDiv, {a, b, -1, -1}, std::move(name)); }
  NodeId sqrt(NodeId a, std::string name = {}) { return operation(Op::kSqrt, {a, -1, -1, -1}, std::move(name)); }
  /// a < b ? then : otherwise
  NodeId select(NodeId a, NodeId b, NodeId then, NodeId otherwise, std::string name = {}) {
    return operation(Op::kSelect, {a, b, then, otherwise}, std::move(name));
  }
  NodeId table(int column) { return append({Op::kTable, {-1, -1, -1, -1}, column, {}, {}}); }
  NodeId row_sum(NodeId a, std::string name = {}) { return operation(Op::kRowSum, {a, -1, -1, -1}, std::move(name)); }
  void name(NodeId id, std::string name) { kernel_.nodes[static_cast<std::size_t>(id)].name = std::move(name); }

 private:
  NodeId operation(Op op, const std::array<NodeId, 4>& args, std::string name);

  Kernel& kernel_;
};

}  // namespace sh::codegen
