#include "codegen/passes/share.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace sh::codegen::passes {
namespace {

using Key = std::tuple<Op, std::array<NodeId, 3>, int, ExactReal>;

Key key_of(const Node& node) {
  std::array<NodeId, 3> args = node.args;
  const bool commutes = node.op == Op::kAdd || node.op == Op::kMul || node.op == Op::kFma;
  if (commutes && args[0] > args[1]) std::swap(args[0], args[1]);
  return {node.op, args, node.input, node.constant};
}

}  // namespace

Kernel share(const Kernel& kernel) {
  Kernel result = kernel;
  result.nodes.clear();
  std::map<Key, NodeId> known;
  std::vector<NodeId> position;
  for (const Node& original : kernel.nodes) {
    Node node = original;
    for (NodeId& arg : node.args) {
      if (arg >= 0) arg = position[static_cast<std::size_t>(arg)];
    }
    const auto [found, inserted] = known.try_emplace(key_of(node), result.size());
    if (inserted) {
      result.nodes.push_back(std::move(node));
    } else if (Node& first = result.nodes[static_cast<std::size_t>(found->second)]; first.name.empty()) {
      first.name = node.name;
    }
    position.push_back(found->second);
  }
  for (Output& output : result.outputs) output.node = position[static_cast<std::size_t>(output.node)];
  return result;
}

}  // namespace sh::codegen::passes
