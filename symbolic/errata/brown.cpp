#include "symbolic/errata/errata.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> brown() { return {}; }

}  // namespace sh::symbolic::errata
