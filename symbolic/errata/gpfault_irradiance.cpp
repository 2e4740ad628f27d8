#include "symbolic/errata/parts.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> gpfault_irradiance() { return {}; }

}  // namespace sh::symbolic::errata
