// The passes: each takes a kernel and gives one that computes the same. Each .cpp file explains its own.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

/// Computes equal expressions once (value numbering; addition and multiplication commute).
Kernel share(const Kernel& kernel);
/// The same, with zeros, ones, signs and operations on constants resolved: values that a mask sets to zero disappear.
Kernel fold(const Kernel& kernel);
/// Writes polynomials of one or two terms in factored form, where that saves operations.
Kernel factor(const Kernel& kernel);
/// Drops nodes that reach no output, and inputs and constants that nothing uses.
Kernel prune(const Kernel& kernel);
/// Writes k (v w) as (k v) w where the product v w serves nothing else.
Kernel associate(const Kernel& kernel);
/// Orders the nodes so that few values are live at once.
Kernel schedule(const Kernel& kernel);

}  // namespace sh::codegen::passes
