#include "symbolic/errata/parts.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> gpfault_projection() { return {}; }

}  // namespace sh::symbolic::errata
