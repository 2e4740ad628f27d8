// The generated C++ kernels as data: by degree a function to call, its operations and its run time.
//
// Only shcheck includes this: numeric's library knows nothing of the generated code.
#pragma once

#include <string>

#include "numeric/counted.hpp"

namespace sh::numeric {

constexpr int kMaxKernelDegree = 10;

// The name of a kernel in every language: "basis_l4".
std::string basis_kernel_name(int degree);

// sh::basis_l<degree> for T = float or double, 0 <= degree <= kMaxKernelDegree.
template <class T>
using BasisKernel = void (*)(T x, T y, T z, T* out);
template <class T>
BasisKernel<T> basis_kernel(int degree);

// Operations of one call, counted by running it on Counted.
Operations count_operations(int degree);

// Nanoseconds a call, single direction: the least mean over 1,024 calls of several passes. Informative: it depends on
// the machine and on what else runs there.
template <class T>
double nanoseconds_per_call(int degree);

}  // namespace sh::numeric
