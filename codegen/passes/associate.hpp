// Pass: write k (v w) as (k v) w where the product v w serves nothing else. Same operations, same depth.
//
// GLSL compilers may regroup such a product (Mesa does, `precise` does not exist in GLSL ES 3.00); written in the order
// they prefer, every language computes the same bits.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen::passes {

Kernel associate(const Kernel& kernel);

}  // namespace sh::codegen::passes
