#include "numeric/output/version.hpp"

namespace sh::output {

std::string version_of(const std::string& tool) { return tool + " " + SHFORGE_VERSION; }

}  // namespace sh::output
