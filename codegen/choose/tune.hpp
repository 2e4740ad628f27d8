// Measures recipes: prints them as C++, compiles this code with the machine's compiler, runs it and reads the times.
#pragma once

#include <string>
#include <vector>

#include "codegen/choose/wisdom.hpp"
#include "codegen/families/family.hpp"

namespace sh::codegen {

/// Describes the compiler (the environment variable CXX, otherwise c++) and the processor.
std::string describe_machine();

/// The time of each recipe, in the order of `recipes`. One run measures all recipes: they take turns in several passes,
/// and the minimum counts. Takes a few seconds. Throws std::runtime_error with the compiler's first message if the
/// compiler fails.
std::vector<Timing> measure_times(const Family& family, const std::vector<Recipe>& recipes, int degree);

}  // namespace sh::codegen
