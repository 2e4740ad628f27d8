// The worst input of a generated kernel by search (worst_input.hpp), beyond the inputs that its family's check tries.
//
// The search maximizes the distance from the kernel run on Wide, which needs no oracle. The errors that it returns are
// measured against the oracle as everywhere else (samples.hpp). Inputs stay where the check's are: directions,
// quaternions and matrices are moved back to the nearest one of the domain and rounded again; other values stay between
// the least and the largest that the check tries.
#pragma once

#include "numeric/kernels/kernel_check.hpp"
#include "numeric/sampling/worst_input.hpp"

namespace sh::numeric {

/// The errors of a kernel on T, float or double, at the tops that the search reaches from the inputs of its family's
/// check. Throws std::invalid_argument for a kernel that no check describes.
template <class T>
KernelResult search_kernel(const BoundKernel& kernel, const FamilyCheck& check, const SearchEffort& effort);

}  // namespace sh::numeric
