// The kernel IR: straight-line code in static single assignment form.
//
// A Kernel computes flat arrays of results from scalar or array parameters by a list of nodes. Each node refers to
// earlier nodes only. The IR supports inputs, exact real constants, negation, addition, subtraction, multiplication and
// fused multiply-add. For a few recipes it also supports division, square root and selection. It deliberately does not
// support control flow, memory, calls or types: a kernel has the same meaning in every scalar type and language, and
// the printer chooses the type. Constants stay exact until a printer rounds them (codegen/ir/literal.hpp).
//
// A kernel may have one counted loop, for code that would outgrow the instruction cache. Such a kernel has a table of
// constants. A node kTable is an element of the table's current row; an input with a stride moves on from row to row; a
// node kRowSum is the sum of a value over all rows. Values that depend on the row and on no sum form the body of the
// loop. The kernel computes all other values once, before or after the loop.
//
// Names are hints for readers, never identity. Some nodes may reach no output: passes leave them behind and `prune`
// drops them. They cost nothing.
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codegen/ir/exact_real.hpp"
#include "codegen/ir/role.hpp"

namespace sh::codegen {

/// The operation of a node.
enum class Op { kInput, kConstant, kNeg, kAdd, kSub, kMul, kFma, kDiv, kSqrt, kSelect, kTable, kRowSum };

using NodeId = int;  ///< position in Kernel::nodes

/// One operation of a kernel.
struct Node {
  Op op = Op::kInput;
  /// kFma is args[0] * args[1] + args[2]; kSelect is args[0] < args[1] ? args[2] : args[3].
  std::array<NodeId, 4> args{-1, -1, -1, -1};
  int input = -1;      ///< kInput: position among the flattened parameters; kTable: column of the table
  ExactReal constant;  ///< kConstant: the value
  std::string name;    ///< a hint such as "p_4_2"; may be empty
  int stride = 0;      ///< kInput: the positions from one row of the table to the next; 0: the same in every row
};

/// One element of the results.
struct Output {
  NodeId node = -1;
  std::string label;  ///< the meaning of the value, e.g. "l=2 m=-1"
  int element = -1;   ///< position among the flattened results; -1: the position among the outputs
};

/// The code that computes one family at one degree, and the texts that describe it.
struct Kernel {
  std::string name;    ///< "basis_l4", the same in every language
  std::string family;  ///< "basis"
  int degree = 0;
  std::string arguments;  ///< the arguments of `shgen emit` that print this kernel: "basis --degree 4"
  std::string recipe;     ///< the name of the recipe
  std::string citation;   ///< the source of the recipe
  std::string title;      ///< one line: the functions that the kernel computes
  std::string domain;     ///< the conditions on the inputs
  std::string result;     ///< the outputs, their order and convention
  bool factored = false;  ///< true: the recipe chose the forms of its polynomials, and the pass `factor` keeps them
  std::vector<Parameter> parameters;
  std::vector<Parameter> results;  ///< arrays, or one scalar; a result with the name of a parameter is updated in place
  std::vector<Node> nodes;
  std::vector<Output> outputs;                ///< the flattened results in order; a kernel may leave some out
  std::vector<std::vector<ExactReal>> table;  ///< the rows of constants of the loop; empty: no loop

  /// True if the only result is a scalar. A printed function returns it.
  [[nodiscard]] bool returns_scalar() const { return results.size() == 1 && results[0].shape.empty(); }
  /// The position of an output among the flattened results.
  [[nodiscard]] int element(std::size_t output) const {
    return outputs[output].element < 0 ? static_cast<int>(output) : outputs[output].element;
  }
  [[nodiscard]] const Node& node(NodeId id) const { return nodes[id]; }
  [[nodiscard]] NodeId size() const { return static_cast<NodeId>(nodes.size()); }
};

/// The number of arguments of an operation.
int argument_count(Op op);
/// The arguments of a node.
inline std::span<const NodeId> arguments(const Node& node) {
  return std::span(node.args).first(argument_count(node.op));
}
/// The node with every argument replaced by its new position.
Node moved(Node node, const std::vector<NodeId>& position);
/// The time at which a kernel computes a node: before the loop (also without a loop), for every row of the table, or
/// after the loop.
enum class Phase { kBefore, kBody, kAfter };
/// The phase of every node. Throws std::logic_error for a sum of a value that depends on no row, and for a value that
/// depends on a sum and on a row.
std::vector<Phase> phases(const Kernel& kernel);
/// The printable name of an operation: "mul".
std::string op_name(Op op);
/// For every node: true if an output depends on it.
std::vector<bool> live_nodes(const Kernel& kernel);
/// The kernel with only the nodes in `order`. Arguments come before the nodes that use them.
Kernel with_order(const Kernel& kernel, const std::vector<NodeId>& order);
/// Throws std::logic_error, which names the kernel, if a node refers to a later node or an output refers to no node.
void require_well_formed(const Kernel& kernel);

/// Appends nodes to a kernel.
class Builder {
 public:
  explicit Builder(Kernel& kernel) : kernel_(kernel) {}
  NodeId append(Node node);
  NodeId input(int index, std::string name, int stride = 0);
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
  void name(NodeId id, std::string name) { kernel_.nodes[id].name = std::move(name); }

 private:
  NodeId operation(Op op, const std::array<NodeId, 4>& args, std::string name);

  Kernel& kernel_;
};

}  // namespace sh::codegen
