#include "symbolic/errata/errata.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> blanco() { return {}; }

}  // namespace sh::symbolic::errata
