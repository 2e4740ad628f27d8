#include "symbolic/errata/errata.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> ramamoorthi() { return {}; }

}  // namespace sh::symbolic::errata
