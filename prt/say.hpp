// What prt says on standard error while it works.
#pragma once
#include <string_view>

#include "numeric/output/log.hpp"

namespace sh::prt {

/// One line, without `prt: ` and the end of the line.
inline void say(std::string_view line) { output::log_line("message", "prt: ", line); }

}  // namespace sh::prt
