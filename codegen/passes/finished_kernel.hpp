// A kernel at the end of the pipeline with everything its file says about it.
#pragma once

#include "codegen/ir/cost.hpp"
#include "codegen/ir/ir.hpp"
#include "codegen/measure/measure.hpp"

namespace sh::codegen {

struct FinishedKernel {
  Kernel kernel;
  Domain domain;
  Cost cost;
  MeasuredError in_float;
  MeasuredError in_double;
};

}  // namespace sh::codegen
