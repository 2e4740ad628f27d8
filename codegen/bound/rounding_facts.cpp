// The part of the analysis that holds on every box: steps, reach and degrees of a kernel.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "codegen/bound/rounding.hpp"

namespace sh::codegen::bound {
namespace {

// The degree of every node in the coordinates of a vector. Throws unless every node is homogeneous.
std::vector<int> degrees_in_vector(const Kernel& kernel) {
  std::vector<int> degree;
  for (const Node& node : kernel.nodes) {
    const auto of = [&](int i) { return degree[node.args[i]]; };
    switch (node.op) {
      case Op::kInput:
        degree.push_back(1);
        break;
      case Op::kConstant:
        degree.push_back(0);
        break;
      case Op::kNeg:
        degree.push_back(of(0));
        break;
      case Op::kAdd:
      case Op::kSub:
        if (of(0) != of(1)) throw std::domain_error("a sum is not homogeneous in the vector");
        degree.push_back(of(0));
        break;
      case Op::kMul:
        degree.push_back(of(0) + of(1));
        break;
      case Op::kDiv:
        degree.push_back(of(0) - of(1));
        break;
      case Op::kSqrt:
        degree.push_back(of(0) / 2);
        break;
      default:
        throw std::domain_error("it has the operation " + op_name(node.op));
    }
  }
  return degree;
}

}  // namespace

RoundingAnalysis::RoundingAnalysis(const Kernel& kernel, const Region& region, Format format)
    : format_(std::move(format)),
      coordinate_(region.coordinate),
      homogeneous_(region.homogeneous),
      values_(kernel.nodes.size()),
      absolute_(kernel.nodes.size()),
      grid_(kernel.nodes.size()),
      derivatives_(kernel.nodes.size()),
      by_roundings_(kernel.nodes.size()),
      error_(region.coordinate.size()) {
  describe(kernel, region);
  set_reach();
}

void RoundingAnalysis::describe(const Kernel& kernel, const Region& region) {
  std::vector<int> uses(kernel.nodes.size(), 0);
  for (const Node& node : kernel.nodes) {
    for (const NodeId arg : arguments(node)) ++uses[arg];
  }
  for (const Output& output : kernel.outputs) {
    outputs_.push_back(output.node);
    ++uses[output.node];
  }
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    Step& step = steps_.emplace_back();
    step.op = node.op;
    step.args = node.args;
    step.input = node.input;
    if (node.op == Op::kConstant) step.constant = rounded(node.constant, format_);
    describe_operation(step);
    step.split = step.contractible && (uses[id] > 1 || node.op == Op::kNeg);
    // The uses of a negative are uses of the product.
    if (node.op == Op::kNeg && step.contractible) steps_[node.args[0]].split = true;
  }
  set_tiny(kernel, region);
}

void RoundingAnalysis::describe_operation(Step& step) const {
  const auto argument = [&](int i) -> const Step& { return steps_[step.args[i]]; };
  switch (step.op) {
    case Op::kInput:
    case Op::kConstant:
      return;
    case Op::kNeg:
      step.contractible = argument(0).contractible;
      return;
    case Op::kAdd:
    case Op::kSub:
      // Twice a number is exact, but twice a product may be contracted.
      step.computed = step.relative = step.args[0] != step.args[1] || argument(0).contractible;
      return;
    case Op::kMul:
      step.computed = true;
      step.relative = !argument(0).constant.power_of_two && !argument(1).constant.power_of_two;
      step.contractible = step.relative;
      return;
    case Op::kFma:
    case Op::kDiv:
    case Op::kSqrt:
      step.computed = step.relative = true;
      return;
    default:
      throw std::domain_error("it has the operation " + op_name(step.op));
  }
}

// A vector of length s scales a node of degree k by s^k, so the error of a subnormal result counts s^-k times.
void RoundingAnalysis::set_tiny(const Kernel& kernel, const Region& region) {
  const std::vector<int> degree = region.homogeneous ? degrees_in_vector(kernel) : std::vector<int>(steps_.size(), 0);
  for (std::size_t id = 0; id < steps_.size(); ++id) {
    const double most = std::max(std::pow(region.lengths.low, -degree[id]), std::pow(region.lengths.high, -degree[id]));
    steps_[id].tiny = steps_[id].computed ? format_.tiny() * most * kSlack : 0;
  }
}

void RoundingAnalysis::set_reach() {
  for (const NodeId output : outputs_) {
    std::vector<bool> reached(steps_.size(), false);
    reached[output] = true;
    std::vector<NodeId>& reach = reach_.emplace_back();
    for (NodeId id = output; id >= 0; --id) {
      if (!reached[id]) continue;
      reach.push_back(id);
      for (int i = 0; i < argument_count(steps_[id].op); ++i) reached[steps_[id].args[i]] = true;
    }
  }
}

std::vector<int> RoundingAnalysis::signs(std::size_t output) {
  reverse(output);
  std::vector<int> signs(coordinate_.size(), 0);
  for (const NodeId id : reach_[output]) {
    if (steps_[id].op != Op::kInput || !derivatives_[id].is_number()) continue;
    const Interval derivative = derivatives_[id].number();
    signs[steps_[id].input] = derivative.low > 0 ? 1 : derivative.high < 0 ? -1 : 0;
  }
  return signs;
}

}  // namespace sh::codegen::bound
