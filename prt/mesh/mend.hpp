// Flaws of the input that the program can mend: each prints one line on standard error or, in strict mode, is an error.
#pragma once
#include <stdexcept>
#include <string>

#include "numeric/output/log.hpp"

namespace sh::prt {

enum class OnFlaw { kMend, kRefuse };

/// Call once per kind of flaw, with a complete line such as `a.obj: 3 faces have no area (dropped)`; control characters
/// of file names are printed as hexadecimal escapes.
/// kMend: prints `warning: line` on standard error; kRefuse: throws std::runtime_error(line + why).
inline void report_flaw(OnFlaw on_flaw, const std::string& line) {
  if (on_flaw == OnFlaw::kRefuse) throw std::runtime_error(line + "; refused because of --strict");
  output::log_line("warning", "warning: ", line);
}

}  // namespace sh::prt
