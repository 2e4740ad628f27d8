// Pass: write polynomials of one or two terms in factored form, where that saves operations.
//
// A node whose exact value is c, c v, c v w, or [v] (c1 v^d + c0) with d = 1 or 2 is rebuilt in that form with one
// exact constant for each coefficient; the rewrite stays only if the kernel needs fewer operations with it, everything
// shared. Longer polynomials are left as the recipe wrote them: which of their forms to take trades operations against
// error and is a recipe's choice.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

Kernel factor(const Kernel& kernel);

}  // namespace sh::codegen::passes
