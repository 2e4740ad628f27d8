// Printer: the SSA of a kernel as text, one node a line, for people who work on the generator.
#pragma once

#include <string>

#include "codegen/ir/ir.hpp"

namespace sh::codegen::print {

std::string dump(const Kernel& kernel);

}  // namespace sh::codegen::print
