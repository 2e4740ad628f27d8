// What a kernel costs: operations, counted exactly, and run time on the machine at hand.
#pragma once

#include "numeric/bind.hpp"
#include "numeric/samples.hpp"

namespace sh::numeric {

// Operations of one call, counted by running it on Wide.
Operations count_operations(const BoundKernel& kernel, const Signature& signature);

// Nanoseconds a call, T float or double: the least mean over some inputs of several passes. Informative: it depends on
// the machine and on what else runs there.
template <class T>
double nanoseconds_per_call(const BoundKernel& kernel, const Samples<T>& samples);

}  // namespace sh::numeric
