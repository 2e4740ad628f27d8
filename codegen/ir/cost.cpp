#include "codegen/ir/cost.hpp"

#include <algorithm>
#include <stdexcept>

namespace sh::codegen {
namespace {

void count(const Node& node, int times, Cost& cost) {
  switch (node.op) {
    case Op::kInput:
    case Op::kConstant:
    case Op::kTable:
      return;
    case Op::kNeg:
      cost.neg += times;
      return;
    case Op::kAdd:
    case Op::kSub:
    case Op::kRowSum:
      cost.add += times;
      return;
    case Op::kMul:
      cost.mul += times;
      return;
    case Op::kFma:
      cost.fma += times;
      return;
    case Op::kDiv:
      cost.div += times;
      return;
    case Op::kSqrt:
      cost.sqrt += times;
      return;
    case Op::kSelect:
      cost.select += times;
      return;
  }
  throw std::logic_error("cost: unknown operation");
}

// A value is live from its own position to its last use. The kernel stores results as soon as it computes them, inputs
// are live from the start, and constants are immediate operands.
int most_live_values(const Kernel& kernel, const std::vector<bool>& live) {
  std::vector<NodeId> last_use(kernel.nodes.size(), -1);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    if (!live[id]) continue;
    for (int i = 0; i < argument_count(node.op); ++i) {
      last_use[node.args[i]] = id;
    }
  }
  std::vector<int> change(kernel.nodes.size() + 1, 0);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    if (!live[id] || node.op == Op::kConstant || node.op == Op::kTable) continue;
    const NodeId end = std::max(last_use[id], id);
    ++change[node.op == Op::kInput ? 0 : id];
    --change[std::max(end, id + 1)];
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
    count(node, every_row ? rows : 1, result);
    int& here = depth[id];
    const int steps = node.op == Op::kRowSum ? rows : 1;
    for (int i = 0; i < argument_count(node.op); ++i) {
      here = std::max(here, depth[node.args[i]] + steps);
    }
    result.depth = std::max(result.depth, here);
  }
  result.max_live = most_live_values(kernel, live);
  return result;
}

}  // namespace sh::codegen
