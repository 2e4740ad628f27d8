#include "symbolic/errata/parts.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> green_products() { return {}; }

}  // namespace sh::symbolic::errata
