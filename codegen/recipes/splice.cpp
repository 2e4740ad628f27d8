#include "codegen/recipes/splice.hpp"

namespace sh::codegen::recipes {

std::vector<NodeId> splice(Builder& build, const Kernel& part, const std::vector<NodeId>& inputs) {
  std::vector<NodeId> position;
  for (Node node : part.nodes) {
    if (node.op == Op::kInput) {
      position.push_back(inputs[node.input]);
      continue;
    }
    for (NodeId& arg : node.args) {
      if (arg >= 0) arg = position[arg];
    }
    position.push_back(build.append(std::move(node)));
  }
  std::vector<NodeId> results;
  for (const Output& output : part.outputs) results.push_back(position[output.node]);
  return results;
}

}  // namespace sh::codegen::recipes
