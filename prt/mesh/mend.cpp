#include "prt/mesh/mend.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <stdexcept>

namespace sh::prt {

void report_flaw(OnFlaw on_flaw, const std::string& line) {
  if (on_flaw == OnFlaw::kRefuse) throw std::runtime_error(line + "; refused because of --strict");
  fmt::print(stderr, "warning: {}\n", line);
}

void report_found(const std::string& line) { fmt::print(stderr, "prt: {}\n", line); }

}  // namespace sh::prt
