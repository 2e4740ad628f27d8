#include "symbolic/errata/parts.hpp"

namespace sh::symbolic::errata {

std::vector<Entry> sloan_basis() { return {}; }

}  // namespace sh::symbolic::errata
