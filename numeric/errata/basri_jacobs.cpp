// BJ: [BasriJacobs03].
#include "numeric/errata/parts.hpp"

namespace sh::errata {

std::vector<Entry> basri_jacobs() {
  return {
      {.id = "BJ-01",
       .where = "Energy of the clamped cosine",
       .kind = Kind::kText,
       .print = Print::kReport,
       .printed = "three bands hold 99.22 % of the energy of the clamped cosine",
       .readings = {{"share of bands 0 to 2 in INT max(0, z)^2", true,
                     "100*sum((2*l+1)*Pi*integral(c,0,1,c*P(l,0))^2,l,0,2)/(2*Pi/3) ~ 99.22", "99.22", "%"}}},
  };
}

}  // namespace sh::errata
