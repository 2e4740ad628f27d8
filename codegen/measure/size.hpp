// Computes the size that an error is compared with, from the formulas of a family's domain and the parameters of a
// kernel.
#pragma once

#include "codegen/families/family.hpp"
#include "numeric/kernels/signature.hpp"

namespace sh::codegen {

/// The parameters and results of the printed function, in any language. Its flat inputs and outputs equal the kernel's.
numeric::Signature signature_of(const Kernel& kernel);

/// The size at flattened inputs for an element of the flattened results. Throws std::invalid_argument for a wrong
/// formula.
Size size_of(const Kernel& kernel, const Domain& domain);

}  // namespace sh::codegen
