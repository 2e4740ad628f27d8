// All claims in one list: source_claims.hpp.
#include "numeric/report/source_claims.hpp"

#include <cmath>
#include <cstdlib>

namespace sh::numeric {

std::vector<SourceClaim> source_claims(bool quick) {
  std::vector<SourceClaim> all = cube_map_claims();
  for (const auto& more : {bilinear_claims(), irradiance_claims(quick), random_sample_claims(quick)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

bool rounds_to(double value, const std::string& printed) {
  const std::size_t point = printed.find('.');
  const auto decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
  const double unit = std::pow(10.0, -static_cast<double>(decimals));
  return std::abs(value - std::strtod(printed.c_str(), nullptr)) <= 0.5 * unit * (1 + 1e-9);
}

}  // namespace sh::numeric
