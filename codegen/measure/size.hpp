// The size that an error is compared with, from the formulas of a family's domain and the parameters of a kernel.
#pragma once

#include "codegen/families/family.hpp"
#include "numeric/kernels/signature.hpp"

namespace sh::codegen {

/// The parameters and results of a function of any language; flat inputs and outputs are the kernel's own.
numeric::Signature signature_of(const Kernel& kernel);

/// At flattened inputs, for an element of the flattened results. Throws std::invalid_argument for a wrong formula.
Size size_of(const Kernel& kernel, const Domain& domain);

}  // namespace sh::codegen
