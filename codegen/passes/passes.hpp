// The passes: each pass takes a kernel and returns a kernel that computes the same values.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

/// Computes equal expressions once (value numbering; addition and multiplication commute).
Kernel share(const Kernel& kernel);
/// Does the same, and resolves zeros, ones, signs and operations on constants. Values that a mask sets to zero
/// disappear.
Kernel fold(const Kernel& kernel);
/// Writes polynomials of one or two terms in factored form if that saves operations.
Kernel factor(const Kernel& kernel);
/// Drops nodes that reach no output, and inputs and constants that nothing uses.
Kernel prune(const Kernel& kernel);
/// Writes k (v w) as (k v) w if nothing else uses the product v w.
Kernel associate(const Kernel& kernel);
/// Orders the nodes so that few values are live at once.
Kernel schedule(const Kernel& kernel);

}  // namespace sh::codegen::passes
