// Runs a kernel in a given arithmetic: float and double (one rounding per node, no contraction), CLN floats, or any
// type with the same operators and a function that converts constants.
//
// An Evaluator converts the constants once and serves many inputs.
#pragma once

#include <cln/float.h>
#include <cln/real.h>

#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "codegen/ir/ir.hpp"
#include "codegen/ir/literal.hpp"

namespace sh::codegen {

/// T: float, double, cln::cl_F or another type with operators. All CLN inputs should have the digits that the constructor gets, because CLN rounds
/// mixed operations to the shorter operand.
template <class T>
class Evaluator {
 public:
  /// digits: decimal digits of the constants, for cl_F only. The kernel has to outlive the evaluator.
  explicit Evaluator(const Kernel& kernel, int digits = 0)
      : Evaluator(kernel, [digits](const ExactReal& constant) { return convert(constant, digits); }) {}

  /// convert: the value of a constant in T.
  Evaluator(const Kernel& kernel, const std::function<T(const ExactReal&)>& convert)
      : kernel_(kernel), phases_(phases(kernel)), values_(kernel.nodes.size()) {
    for (std::size_t i = 0; i < kernel.nodes.size(); ++i) {
      if (kernel.nodes[i].op == Op::kConstant) values_[i] = convert(kernel.nodes[i].constant);
    }
    for (const auto& row : kernel.table) {
      table_.emplace_back();
      for (const ExactReal& constant : row) table_.back().push_back(convert(constant));
    }
  }

  explicit Evaluator(const Kernel&& kernel, int digits = 0) = delete;

  /// inputs: the flattened parameters; result: the flattened outputs.
  std::vector<T> operator()(std::span<const T> inputs) {
    run(Phase::kBefore, inputs);
    for (row_ = 0; row_ < table_.size(); ++row_) run_row(inputs);
    run(Phase::kAfter, inputs);
    std::vector<T> results;
    results.reserve(kernel_.outputs.size());
    for (const Output& output : kernel_.outputs) results.push_back(value(output.node));
    return results;
  }

 private:
  void run(Phase phase, std::span<const T> inputs) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (phases_[i] == phase && kernel_.nodes[i].op != Op::kRowSum) step(kernel_.nodes[i], inputs, values_[i]);
    }
  }

  void run_row(std::span<const T> inputs) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (kernel_.nodes[i].op == Op::kTable) values_[i] = table_[row_][kernel_.nodes[i].input];
    }
    run(Phase::kBody, inputs);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (kernel_.nodes[i].op != Op::kRowSum) continue;
      const T& term = value(kernel_.nodes[i].args[0]);
      values_[i] = row_ == 0 ? term : values_[i] + term;
    }
  }

  static T convert(const ExactReal& constant, [[maybe_unused]] int digits) {
    if constexpr (std::is_floating_point_v<T>) {
      return nearest<T>(constant);
    } else {
      return evaluate(constant, digits);
    }
  }

  static T multiply_add(const T& a, const T& b, const T& c) {
    if constexpr (std::is_floating_point_v<T>) {
      return std::fma(a, b, c);
    } else {
      return a * b + c;
    }
  }

  static T square_root(const T& a) {
    if constexpr (std::is_floating_point_v<T>) {
      return std::sqrt(a);
    } else {
      using cln::sqrt;
      return sqrt(a);
    }
  }

  [[nodiscard]] const T& value(NodeId id) const { return values_[id]; }

  void step(const Node& node, std::span<const T> inputs, T& result) const {
    switch (node.op) {
      case Op::kInput:
        result = inputs[node.input + row_ * node.stride];
        return;
      case Op::kConstant:
      case Op::kTable:
      case Op::kRowSum:
        return;
      case Op::kNeg:
        result = -value(node.args[0]);
        return;
      case Op::kAdd:
        result = value(node.args[0]) + value(node.args[1]);
        return;
      case Op::kSub:
        result = value(node.args[0]) - value(node.args[1]);
        return;
      case Op::kMul:
        result = value(node.args[0]) * value(node.args[1]);
        return;
      case Op::kFma:
        result = multiply_add(value(node.args[0]), value(node.args[1]), value(node.args[2]));
        return;
      case Op::kDiv:
        result = value(node.args[0]) / value(node.args[1]);
        return;
      case Op::kSqrt:
        result = square_root(value(node.args[0]));
        return;
      case Op::kSelect:
        result = value(node.args[0]) < value(node.args[1]) ? value(node.args[2]) : value(node.args[3]);
        return;
    }
    throw std::logic_error("evaluate: unknown operation");
  }

  const Kernel& kernel_;
  std::vector<Phase> phases_;
  std::vector<T> values_;
  std::vector<std::vector<T>> table_;  // the constants of the loop, by row
  std::size_t row_ = 0;
};

}  // namespace sh::codegen
