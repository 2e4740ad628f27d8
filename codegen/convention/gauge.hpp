// Rescales the inputs and outputs of a kernel by exact factors. This costs nothing where constants of the kernel can
// absorb the factors.
//
// The new kernel holds every value v as g v, with a factor g that is called the gauge of v. The caller gives the gauges
// of inputs and outputs. A product has the product of the gauges of its factors. Both terms of a sum need the same
// gauge. A multiplication by a constant may have any gauge, because the constant changes with it. One pass over the
// kernel finds all gauges. Where constants leave no freedom, it adds one multiplication (or a change of sign).
#pragma once

#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// The kernel that reads inputs[i] * (input i) and writes outputs[k] * (output k). Each flattened parameter and each
/// flattened result has one factor, which is not zero.
Kernel with_gauges(const Kernel& kernel, const std::vector<symbolic::Surd>& inputs,
                   const std::vector<symbolic::Surd>& outputs);

}  // namespace sh::codegen
