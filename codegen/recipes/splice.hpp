// One kernel inside another: a recipe that begins or ends with the result of another recipe.
#pragma once

#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// Appends the nodes of `part`, its flattened parameters being the nodes `inputs`; returns its flattened results.
std::vector<NodeId> splice(Builder& build, const Kernel& part, const std::vector<NodeId>& inputs);

}  // namespace sh::codegen::recipes
