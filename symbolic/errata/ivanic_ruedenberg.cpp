#include "symbolic/errata/errata.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> ivanic_ruedenberg() { return {}; }

}  // namespace sh::symbolic::errata
