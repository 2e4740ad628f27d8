// The emitted kernels that the tests of the languages share.
#pragma once

#include <string>
#include <vector>

#include "codegen/choose/catalogue.hpp"

namespace sh::codegen::test {

/// The lowest, a middle and the highest degree that `shgen list` names for the family; fewer if it has fewer.
std::vector<int> some_degrees(const Family& family);

/// The output of `shgen emit FAMILY --degree N` for every family at some_degrees. Each process computes it once,
/// because it takes long.
const std::vector<FinishedKernel>& emitted_kernels();

/// Expects that the file of each kernel compiles alone in the language. Defined in language_test.cpp.
void expect_files_compile_alone(const std::string& language, const std::vector<FinishedKernel>& kernels);

}  // namespace sh::codegen::test
