// The rounding error of a kernel at one point to first order, if every rounding is as large as it can be and all of them
// add up: the sum over the nodes of |d output / d node| x epsilon/2 x |node|, and the error from rounded constants.
//
// No proof: it leaves out terms of second order. It is smooth where the error itself jumps, so a search climbs it first.
#pragma once

#include <span>
#include <vector>

#include "codegen/bound/format.hpp"
#include "codegen/ir/ir.hpp"

namespace sh::codegen {

class FirstOrder {
 public:
  /// kernel: without a loop (passes::unroll); it has to outlive this object.
  FirstOrder(const Kernel& kernel, const bound::Format& format);

  /// Computes the nodes at flattened inputs.
  void move_to(std::span<const double> inputs);
  /// The error of an output there, absolute.
  double error(std::size_t output);

 private:
  void pass_on(NodeId id);

  const Kernel& kernel_;
  double unit_;  // the largest relative error of one rounding
  std::vector<double> values_;
  std::vector<double> derivatives_;
  std::vector<double> constant_errors_;  // rounded - exact
  std::vector<bool> rounds_;             // by node
};

}  // namespace sh::codegen
