// Pass: orders the nodes so that few values are live at once.
//
// It uses greedy list scheduling: among the nodes with ready arguments, it takes the node that ends the most lifetimes.
// In a tie it takes the node that is nearest to the previous node in the original order. The original order stays if it
// does not need more live values. Then divisions and square roots, and the nodes that they need, go first: the processor
// computes the others while it waits for them.
#include <algorithm>
#include <numeric>

#include "codegen/ir/cost.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen::passes {
namespace {

class ListScheduler {
 public:
  explicit ListScheduler(const Kernel& kernel)
      : kernel_(kernel), done_(kernel.nodes.size(), false), uses_left_(kernel.nodes.size(), 0) {
    for (const Node& node : kernel.nodes) {
      for (const NodeId arg : arguments(node)) ++uses_left_[arg];
    }
  }

  std::vector<NodeId> order() {
    // Inputs and constants need no computation, so they come first in their own order.
    for (NodeId id = 0; id < kernel_.size(); ++id) {
      if (argument_count(kernel_.node(id).op) == 0) take(id);
    }
    while (order_.size() < kernel_.nodes.size()) take(best_ready());
    return std::move(order_);
  }

 private:
  [[nodiscard]] bool ready(NodeId id) const {
    const auto args = arguments(kernel_.node(id));
    return !done_[id] && std::all_of(args.begin(), args.end(), [this](NodeId arg) { return done_[arg]; });
  }

  [[nodiscard]] bool is_constant(NodeId id) const {
    return kernel_.node(id).op == Op::kConstant || kernel_.node(id).op == Op::kTable;
  }

  // The change of the number of live values by the node.
  [[nodiscard]] int live_change(NodeId id) const {
    const auto args = arguments(kernel_.node(id));
    int change = uses_left_[id] > 0 ? 1 : 0;
    for (auto arg = args.begin(); arg != args.end(); ++arg) {
      if (!is_constant(*arg) && uses_left_[*arg] == std::count(arg, args.end(), *arg))
        --change;  // once: at its first place
    }
    return change;
  }

  [[nodiscard]] NodeId best_ready() const {
    NodeId best = -1;
    int best_change = 0;
    for (NodeId id = 0; id < kernel_.size(); ++id) {
      if (!ready(id)) continue;
      const int change = live_change(id);
      if (best < 0 || change < best_change) {
        best = id;
        best_change = change;
      }
    }
    return best;
  }

  void take(NodeId id) {
    for (const NodeId arg : arguments(kernel_.node(id))) --uses_left_[arg];
    done_[id] = true;
    order_.push_back(id);
  }

  const Kernel& kernel_;
  std::vector<bool> done_;
  std::vector<int> uses_left_;
  std::vector<NodeId> order_;
};

Kernel slow_first(const Kernel& kernel) {
  enum Place { kGiven, kSlow, kOther };
  std::vector<Place> place(kernel.nodes.size(), kOther);
  for (NodeId id = kernel.size() - 1; id >= 0; --id) {
    const Node& node = kernel.node(id);
    if (argument_count(node.op) == 0) place[id] = kGiven;
    if (node.op == Op::kDiv || node.op == Op::kSqrt) place[id] = kSlow;
    if (place[id] != kSlow) continue;
    for (const NodeId arg : arguments(node)) place[arg] = kSlow;
  }
  std::vector<NodeId> order(kernel.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&place](NodeId a, NodeId b) { return place[a] < place[b]; });
  return with_order(kernel, order);
}

}  // namespace

Kernel prune(const Kernel& kernel) {
  const std::vector<bool> live = live_nodes(kernel);
  std::vector<NodeId> order;
  for (NodeId id = 0; id < kernel.size(); ++id) {
    if (live[id]) order.push_back(id);
  }
  return with_order(kernel, order);
}

Kernel schedule(const Kernel& kernel) {
  const Kernel listed = with_order(kernel, ListScheduler(kernel).order());
  return slow_first(cost(listed).max_live < cost(kernel).max_live ? listed : kernel);
}

}  // namespace sh::codegen::passes
