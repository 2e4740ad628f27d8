// Rescales the inputs and outputs of a kernel by exact factors, at no cost where its constants can take them up.
//
// Every value v of the kernel is held as g v for a factor g, its gauge. Inputs and outputs prescribe theirs; a product
// has the product of its factors' gauges, both terms of a sum need the same one, and a multiplication by a constant
// may have any, as the constant changes with it. The gauges are found in one pass over the kernel; where constants
// leave no freedom, one multiplication (or a change of sign) is added.
#pragma once

#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// The kernel that reads inputs[i] * (input i) and writes outputs[k] * (output k). One factor, none of them zero, for
/// each flattened parameter and each flattened result.
Kernel with_gauges(const Kernel& kernel, const std::vector<symbolic::Surd>& inputs,
                   const std::vector<symbolic::Surd>& outputs);

}  // namespace sh::codegen
