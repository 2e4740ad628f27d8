#include "codegen/ir/cost.hpp"

#include <algorithm>

namespace sh::codegen {
namespace {

// The counter of an operation; nullptr for operations that cost nothing.
int Cost::*counter_of(Op op) {
  switch (op) {
    case Op::kNeg:
      return &Cost::neg;
    case Op::kAdd:
    case Op::kSub:
    case Op::kRowSum:
      return &Cost::add;
    case Op::kMul:
      return &Cost::mul;
    case Op::kFma:
      return &Cost::fma;
    case Op::kDiv:
      return &Cost::div;
    case Op::kSqrt:
      return &Cost::sqrt;
    case Op::kSelect:
      return &Cost::select;
    default:
      return nullptr;
  }
}

// A value is live from its own position to its last use. The kernel stores results as soon as it computes them, inputs
// are live from the start, and constants are immediate operands.
int most_live_values(const Kernel& kernel, const std::vector<bool>& live) {
  std::vector<NodeId> last_use(kernel.nodes.size(), -1);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    if (!live[id]) continue;
    for (const NodeId arg : arguments(kernel.node(id))) last_use[arg] = id;
  }
  std::vector<int> change(kernel.nodes.size() + 1, 0);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    if (!live[id] || node.op == Op::kConstant || node.op == Op::kTable) continue;
    ++change[node.op == Op::kInput ? 0 : id];
    --change[std::max(last_use[id], id + 1)];
  }
  int now = 0;
  int most = 0;
  for (const int step : change) most = std::max(most, now += step);
  return most;
}

}  // namespace

Cost cost(const Kernel& kernel) {
  const std::vector<bool> live = live_nodes(kernel);
  const std::vector<Phase> phase = phases(kernel);
  const auto rows = static_cast<int>(kernel.table.size());
  Cost result;
  std::vector<int> depth(kernel.nodes.size(), 0);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    if (!live[id]) continue;
    const Node& node = kernel.node(id);
    const bool every_row = phase[id] == Phase::kBody || node.op == Op::kRowSum;
    if (int Cost::*const counter = counter_of(node.op)) result.*counter += every_row ? rows : 1;
    int& here = depth[id];
    const int steps = node.op == Op::kRowSum ? rows : 1;
    for (const NodeId arg : arguments(node)) here = std::max(here, depth[arg] + steps);
    result.depth = std::max(result.depth, here);
  }
  result.max_live = most_live_values(kernel, live);
  return result;
}

}  // namespace sh::codegen
