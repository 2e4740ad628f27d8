#include <utility>

#include "codegen/passes/passes.hpp"

namespace sh::codegen::passes {
namespace {

class Unroller {
 public:
  explicit Unroller(const Kernel& kernel) : from_(kernel), phases_(phases(kernel)), place_(kernel.nodes.size(), -1) {
    result_ = kernel;
    result_.nodes.clear();
    result_.table.clear();
  }

  Kernel run() {
    copy(Phase::kBefore);
    for (const auto& row : from_.table) copy_row(row);
    copy(Phase::kAfter);
    for (Output& output : result_.outputs) output.node = place_[output.node];
    return std::move(result_);
  }

 private:
  void copy(Phase phase) {
    for (NodeId id = 0; id < from_.size(); ++id) {
      const Node& node = from_.node(id);
      if (phases_[id] != phase || node.op == Op::kRowSum || node.op == Op::kTable) continue;
      Node copied = moved(node, place_);
      copied.input += std::exchange(copied.stride, 0) * row_;
      place_[id] = Builder(result_).append(std::move(copied));
    }
  }

  void copy_row(const std::vector<ExactReal>& row) {
    for (NodeId id = 0; id < from_.size(); ++id) {
      const Node& node = from_.node(id);
      if (node.op == Op::kTable) place_[id] = Builder(result_).constant(row[node.input]);
    }
    copy(Phase::kBody);
    for (NodeId id = 0; id < from_.size(); ++id) {
      const Node& node = from_.node(id);
      if (node.op != Op::kRowSum) continue;
      const NodeId term = place_[node.args[0]];
      place_[id] = place_[id] < 0 ? term : Builder(result_).add(place_[id], term);
    }
    ++row_;
  }

  const Kernel& from_;
  std::vector<Phase> phases_;
  std::vector<NodeId> place_;
  Kernel result_;
  int row_ = 0;
};

}  // namespace

Kernel unroll(const Kernel& kernel) { return prune(kernel.table.empty() ? kernel : Unroller(kernel).run()); }

}  // namespace sh::codegen::passes
