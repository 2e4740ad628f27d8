// Passes: compute equal expressions once (value numbering; addition and multiplication commute), and fold.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

Kernel share(const Kernel& kernel);

/// The same, with zeros, ones, signs and operations on constants resolved: what a mask sets to zero disappears.
Kernel fold(const Kernel& kernel);

}  // namespace sh::codegen::passes
