// Flaws of the input that the program can mend: each prints one line on standard error or, in strict mode, is an error.
#pragma once
#include <string>

namespace sh::prt {

enum class OnFlaw { kMend, kRefuse };

/// Call once per kind of flaw, with a complete line such as `a.obj: 3 faces have no area (dropped)`.
/// kMend: prints `warning: line` on standard error; kRefuse: throws std::runtime_error(line + why).
void report_flaw(OnFlaw on_flaw, const std::string& line);

/// Reports something that may interest the user: prints `prt: line` on standard error.
void report_found(const std::string& line);

}  // namespace sh::prt
