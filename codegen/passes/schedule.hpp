// Pass: order the nodes so that few values are live at once.
//
// Greedy list scheduling: of the nodes whose arguments are ready, take the one that ends the most lifetimes, then the
// one nearest to what was computed last in the original order. The original order stays if it needs no more values.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

Kernel schedule(const Kernel& kernel);

}  // namespace sh::codegen::passes
