// A kernel as the analysis reads it: the nodes that reach an output, without a loop.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::bound {

/// The kernel with the rows of its loop one after the other, without nodes that reach no output. A sum over the rows is
/// a chain of additions, the first row first.
Kernel straight(const Kernel& kernel);

}  // namespace sh::codegen::bound
