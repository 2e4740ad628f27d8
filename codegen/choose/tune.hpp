// Measures recipes: prints them as C++, compiles that with the machine's compiler, runs it and reads the times.
#pragma once

#include <string>
#include <vector>

#include "codegen/choose/wisdom.hpp"
#include "codegen/families/family.hpp"

namespace sh::codegen {

/// The compiler (the environment variable CXX, else c++) and the processor, in words.
std::string describe_machine();

/// The time of each of the recipes, in their order, all in one run: the minimum of several passes in which they take
/// turns. Takes a few seconds. Throws std::runtime_error with the compiler's first message when it fails.
std::vector<Timing> measure_times(const Family& family, const std::vector<Recipe>& recipes, int degree);

}  // namespace sh::codegen
