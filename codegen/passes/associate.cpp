// Pass: writes k (v w) as (k v) w if nothing else uses the product v w. Operations and depth stay the same.
//
// GLSL compilers may regroup such a product (Mesa does so, and GLSL ES 3.00 has no `precise`). They keep products in
// this order, so every language computes the same bits.
#include "codegen/passes/passes.hpp"

namespace sh::codegen::passes {
namespace {

// The kernel with its inputs and constants first, so that every product may use any of them.
Kernel leaves_first(const Kernel& kernel) {
  std::vector<NodeId> order;
  for (const bool leaf : {true, false}) {
    for (NodeId id = 0; id < kernel.size(); ++id) {
      if ((argument_count(kernel.node(id).op) == 0) == leaf) order.push_back(id);
    }
  }
  return with_order(kernel, order);
}

std::vector<int> use_counts(const Kernel& kernel) {
  std::vector<int> uses(kernel.nodes.size());
  for (const Node& node : kernel.nodes) {
    for (const NodeId arg : arguments(node)) ++uses[arg];
  }
  for (const Output& output : kernel.outputs) ++uses[output.node];
  return uses;
}

}  // namespace

Kernel associate(const Kernel& kernel) {
  Kernel result = leaves_first(kernel);
  const std::vector<int> uses = use_counts(result);
  const auto at = [&result](NodeId id) -> Node& { return result.nodes[id]; };
  const auto is_constant = [&at](NodeId id) { return at(id).op == Op::kConstant; };
  for (Node& outer : result.nodes) {
    if (outer.op != Op::kMul) continue;
    const NodeId left = outer.args[0];
    const NodeId right = outer.args[1];
    const NodeId k = is_constant(left) ? left : right;
    const NodeId vw = is_constant(left) ? right : left;
    if (!is_constant(k) || at(vw).op != Op::kMul || uses[vw] > 1) continue;
    Node& inner = at(vw);
    const NodeId v = inner.args[0];
    const NodeId w = inner.args[1];
    if (is_constant(v) || is_constant(w)) continue;
    inner.args = {k, v, -1, -1};
    inner.name.clear();
    outer.args = {vw, w, -1, -1};
  }
  return result;
}

}  // namespace sh::codegen::passes
