// Inserts one kernel into another, for a recipe that begins or ends with the result of another recipe.
#pragma once

#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::recipes {

/// Appends the nodes of `part` and returns its flattened results. inputs: the nodes of its flattened parameters.
std::vector<NodeId> splice(Builder& build, const Kernel& part, const std::vector<NodeId>& inputs);

}  // namespace sh::codegen::recipes
