// Pass: drops nodes that reach no output, and unused inputs and constants.
#include "codegen/passes/passes.hpp"

namespace sh::codegen::passes {

Kernel prune(const Kernel& kernel) {
  const std::vector<bool> live = live_nodes(kernel);
  std::vector<NodeId> order;
  for (NodeId id = 0; id < kernel.size(); ++id) {
    if (live[id]) order.push_back(id);
  }
  return with_order(kernel, order);
}

}  // namespace sh::codegen::passes
