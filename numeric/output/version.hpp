// The version of the project, for `--version` of all tools.
#pragma once
#include <string>

namespace sh::output {

/// "TOOL 0.1.0".
std::string version_of(const std::string& tool);

}  // namespace sh::output
