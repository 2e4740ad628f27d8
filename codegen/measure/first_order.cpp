#include "codegen/measure/first_order.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "codegen/ir/literal.hpp"

namespace sh::codegen {
namespace {

// True if the operation may round. Products with powers of two and twice a number are exact.
bool may_round(const Kernel& kernel, const Node& node, const std::vector<bool>& is_power) {
  switch (node.op) {
    case Op::kAdd:
      return node.args[0] != node.args[1];
    case Op::kMul:
      return !is_power[node.args[0]] && !is_power[node.args[1]];
    case Op::kSub:
    case Op::kFma:
    case Op::kDiv:
    case Op::kSqrt:
      return true;
    case Op::kTable:
    case Op::kRowSum:
      throw std::logic_error("first order: " + kernel.name + " has a loop");
    default:
      return false;
  }
}

}  // namespace

FirstOrder::FirstOrder(const Kernel& kernel, const bound::Format& format)
    : kernel_(kernel),
      unit_(format.epsilon() / 2),
      values_(kernel.nodes.size()),
      derivatives_(kernel.nodes.size()),
      constant_errors_(kernel.nodes.size()) {
  std::vector<bool> is_power(kernel.nodes.size(), false);
  for (NodeId id = 0; id < kernel.size(); ++id) {
    const Node& node = kernel.node(id);
    rounds_.push_back(may_round(kernel, node, is_power));
    if (node.op != Op::kConstant) continue;
    const bound::RoundedConstant constant = bound::rounded(node.constant, format);
    values_[id] = nearest<double>(node.constant);
    constant_errors_[id] = constant.error.low;
    is_power[id] = constant.power_of_two;
  }
}

void FirstOrder::move_to(std::span<const double> inputs) {
  for (NodeId id = 0; id < kernel_.size(); ++id) {
    const Node& node = kernel_.node(id);
    const auto value = [&](int i) { return values_[node.args[i]]; };
    double& result = values_[id];
    switch (node.op) {
      case Op::kInput:
        result = inputs[node.input];
        break;
      case Op::kNeg:
        result = -value(0);
        break;
      case Op::kAdd:
        result = value(0) + value(1);
        break;
      case Op::kSub:
        result = value(0) - value(1);
        break;
      case Op::kMul:
        result = value(0) * value(1);
        break;
      case Op::kFma:
        result = value(0) * value(1) + value(2);
        break;
      case Op::kDiv:
        result = value(0) / value(1);
        break;
      case Op::kSqrt:
        result = std::sqrt(value(0));
        break;
      case Op::kSelect:
        result = value(0) < value(1) ? value(2) : value(3);
        break;
      default:
        break;
    }
  }
}

double FirstOrder::error(std::size_t output) {
  std::fill(derivatives_.begin(), derivatives_.end(), 0.0);
  const NodeId last = kernel_.outputs[output].node;
  derivatives_[last] = 1;
  double roundings = 0, constants = 0;
  for (NodeId id = last; id >= 0; --id) {
    const double derivative = derivatives_[id];
    if (derivative == 0) continue;
    if (rounds_[id]) roundings += std::abs(derivative * values_[id]) * unit_;
    constants += derivative * constant_errors_[id];
    pass_on(id);
  }
  return roundings + std::abs(constants);
}

void FirstOrder::pass_on(NodeId id) {
  const Node& node = kernel_.node(id);
  const double derivative = derivatives_[id];
  const auto value = [&](int i) { return values_[node.args[i]]; };
  const auto pass = [&](int i, double part) { derivatives_[node.args[i]] += part; };
  switch (node.op) {
    case Op::kNeg:
      return pass(0, -derivative);
    case Op::kAdd:
    case Op::kSub:
      pass(0, derivative);
      return pass(1, node.op == Op::kAdd ? derivative : -derivative);
    case Op::kFma:
      pass(2, derivative);
      [[fallthrough]];
    case Op::kMul:
      pass(0, derivative * value(1));
      return pass(1, derivative * value(0));
    case Op::kDiv:
      pass(0, derivative / value(1));
      return pass(1, -derivative * values_[id] / value(1));
    case Op::kSqrt:
      return pass(0, derivative / (2 * values_[id]));
    case Op::kSelect:
      return pass(value(0) < value(1) ? 2 : 3, derivative);
    default:
      return;
  }
}

}  // namespace sh::codegen
