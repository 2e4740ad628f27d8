// Bounds from every input, for kernels with one number as parameter in a format of few numbers.
//
// At one input nothing is left to bound but the choices of a compiler that may contract a * b + c. The computed value of
// a node lies between two numbers of the format. They follow from those of its arguments, because rounding is monotone.
// So the errors are those of the kernel itself, not the sum of the most that each operation could add (rounding.hpp).
#pragma once

#include <optional>

#include "codegen/bound/bound.hpp"
#include "codegen/bound/region.hpp"

namespace sh::codegen::bound {

/// kernel: straight. Nothing where the numbers of the region are not those of one parameter in binary16, and where an
/// output is not a number, a coefficient, or a number times a coefficient.
std::optional<Bound> bound_at_every_number(const Kernel& kernel, const Domain& domain, const Region& region,
                                           const Format& format);

}  // namespace sh::codegen::bound
