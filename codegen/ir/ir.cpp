#include "codegen/ir/ir.hpp"

#include <iterator>
#include <stdexcept>
#include <utility>

namespace sh::codegen {

namespace {

struct Operation {
  Op op;
  int arguments;
  const char* name;
};

constexpr Operation kOperations[] = {
    {Op::kInput, 0, "input"}, {Op::kConstant, 0, "constant"}, {Op::kNeg, 1, "neg"},     {Op::kAdd, 2, "add"},
    {Op::kSub, 2, "sub"},     {Op::kMul, 2, "mul"},           {Op::kFma, 3, "fma"},     {Op::kDiv, 2, "div"},
    {Op::kSqrt, 1, "sqrt"},   {Op::kSelect, 4, "select"},     {Op::kTable, 0, "table"}, {Op::kRowSum, 1, "row_sum"}};

constexpr const Operation& operation_of(Op op) { return kOperations[static_cast<std::size_t>(op)]; }

constexpr bool is_in_order() {
  if (std::size(kOperations) != static_cast<std::size_t>(Op::kRowSum) + 1) return false;
  for (std::size_t i = 0; i < std::size(kOperations); ++i) {
    if (kOperations[i].op != static_cast<Op>(i)) return false;
  }
  return true;
}
static_assert(is_in_order(), "kOperations lists the operations in the order of Op");

}  // namespace

int argument_count(Op op) { return operation_of(op).arguments; }

Node moved(Node node, const std::vector<NodeId>& position) {
  for (NodeId& arg : node.args) {
    if (arg >= 0) arg = position[arg];
  }
  return node;
}

std::string op_name(Op op) { return operation_of(op).name; }

std::vector<Phase> phases(const Kernel& kernel) {
  std::vector<Phase> result(kernel.nodes.size(), Phase::kBefore);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    bool in_row = node.op == Op::kTable || node.stride != 0;
    bool after = node.op == Op::kRowSum;
    for (const NodeId arg : arguments(node)) {
      in_row = in_row || result[arg] == Phase::kBody;
      after = after || result[arg] == Phase::kAfter;
    }
    if (in_row != (node.op == Op::kRowSum) && in_row && after) {
      throw std::logic_error(kernel.name + ": node " + std::to_string(id) +
                             ": expected an argument that depends on a row or on a sum over all rows, got both");
    }
    if (node.op == Op::kRowSum && !in_row) {
      throw std::logic_error(kernel.name + ": node " + std::to_string(id) +
                             ": expected a sum of a value that depends on a row of the table, got another value");
    }
    result[id] = after ? Phase::kAfter : in_row ? Phase::kBody : Phase::kBefore;
  }
  return result;
}

std::vector<bool> live_nodes(const Kernel& kernel) {
  std::vector<bool> live(kernel.nodes.size(), false);
  for (const Output& output : kernel.outputs) live[output.node] = true;
  for (NodeId id = kernel.size() - 1; id >= 0; --id) {
    if (!live[id]) continue;
    for (const NodeId arg : arguments(kernel.node(id))) live[arg] = true;
  }
  return live;
}

Kernel with_order(const Kernel& kernel, const std::vector<NodeId>& order) {
  Kernel result = kernel;
  result.nodes.clear();
  std::vector<NodeId> position(kernel.nodes.size(), -1);
  for (const NodeId id : order) {
    position[id] = Builder(result).append(moved(kernel.node(id), position));
  }
  for (Output& output : result.outputs) output.node = position[output.node];
  require_well_formed(result);
  return result;
}

void require_well_formed(const Kernel& kernel) {
  for (NodeId id = 0; id < kernel.size(); ++id) {
    for (const NodeId arg : arguments(kernel.node(id))) {
      if (arg >= 0 && arg < id) continue;
      throw std::logic_error(kernel.name + ": node " + std::to_string(id) +
                             ": expected an earlier node as argument, got node " + std::to_string(arg));
    }
  }
  for (const Output& output : kernel.outputs) {
    if (output.node >= 0 && output.node < kernel.size()) continue;
    throw std::logic_error(kernel.name + ": output " + output.label + ": expected a node, got none");
  }
}

NodeId Builder::append(Node node) {
  kernel_.nodes.push_back(std::move(node));
  return kernel_.size() - 1;
}

NodeId Builder::operation(Op op, const std::array<NodeId, 4>& args, std::string name) {
  return append({op, args, -1, {}, std::move(name)});
}

NodeId Builder::input(int index, std::string name, int stride) {
  return append({Op::kInput, {-1, -1, -1, -1}, index, {}, std::move(name), stride});
}

NodeId Builder::constant(ExactReal value, std::string name) {
  return append({Op::kConstant, {-1, -1, -1, -1}, -1, std::move(value), std::move(name)});
}

}  // namespace sh::codegen
