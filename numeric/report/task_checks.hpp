// The checks of numeric/kernels as methods are compared by: with inputs of one scale, so that absolute errors compare.
#pragma once

#include <string>

#include "numeric/kernels/family_check.hpp"

namespace sh::numeric {

// As kernels/family_check.hpp, but gradients at |d| = 1 and samples of weight 1.
FamilyCheck task_check(const std::string& family);

}  // namespace sh::numeric
