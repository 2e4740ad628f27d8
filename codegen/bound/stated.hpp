// The errors that the file of a kernel states: a proved bound and the largest error seen, in float and double.
#pragma once

#include "codegen/measure/measure.hpp"

namespace sh::codegen::bound {

/// Proves the bounds of a finished kernel and searches for its largest errors, beyond those of the tested inputs.
void state_errors(FinishedKernel& finished);

}  // namespace sh::codegen::bound
