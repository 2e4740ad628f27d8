// A kernel at the end of the pipeline, with all facts that its file states.
#pragma once

#include "codegen/ir/cost.hpp"
#include "codegen/ir/ir.hpp"
#include "codegen/measure/measure.hpp"

namespace sh::codegen {

/// A kernel with its domain, cost and measured errors.
struct FinishedKernel {
  Kernel kernel;
  Domain domain;
  Cost cost;
  MeasuredError in_float;
  MeasuredError in_double;
};

}  // namespace sh::codegen
