// Scripts for Gappa (https://gappa.gitlabpages.inria.fr), a second opinion on bounds: an independent program proves the
// error of the same kernel on the box where our bound is largest.
//
// Gappa propagates errors forwards and without contraction. On a small box that proves the bound of the reverse analysis.
#pragma once

#include <string>

#include "codegen/bound/bound.hpp"

namespace sh::codegen::bound {

/// The script for the output with the largest bound on `proved.worst_box`. Throws std::invalid_argument for a kernel
/// without a bound, with coefficients, or with vectors of any length.
std::string gappa_script(const Kernel& kernel, const Domain& domain, const Format& format, const Bound& proved);

}  // namespace sh::codegen::bound
