// Pass: compute equal expressions once (value numbering; addition and multiplication commute).
#pragma once

#include "codegen/ir.hpp"

namespace sh::codegen::passes {

Kernel share(const Kernel& kernel);

}  // namespace sh::codegen::passes
