// Pass: drop nodes that reach no output, and inputs and constants that nothing uses.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

Kernel prune(const Kernel& kernel);

}  // namespace sh::codegen::passes
