#include "numeric/report/source_claims.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "numeric/errata/errata.hpp"

namespace sh::numeric {
namespace {

SourceClaim row(const errata::Source& source, const errata::Entry& entry, const errata::Reading& reading) {
  return {entry.place.id,
          entry.place.where + ": " + reading.text,
          source.short_name,
          reading.number,
          0,
          reading.unit,
          false,
          reading.holds,
          ""};
}

SourceClaim unmeasured(const std::string& id, int reading) {
  for (const errata::Source& source : errata::all_sources()) {
    for (const errata::Entry& entry : source.entries) {
      for (const errata::Reading& candidate : entry.readings) {
        if (entry.place.id == id && !candidate.number.empty() && reading-- == 0) return row(source, entry, candidate);
      }
    }
  }
  throw std::out_of_range("expected a measured reading of the errata, got " + id);
}

}  // namespace

SourceClaim claim_of(const std::string& id, int reading, double measured, const std::string& how) {
  return claim_of(id, reading, measured, how, rounds_to(measured, unmeasured(id, reading).printed));
}

SourceClaim claim_of(const std::string& id, int reading, double measured, const std::string& how, bool reproduced) {
  SourceClaim claim = unmeasured(id, reading);
  claim.measured = measured;
  claim.how = how;
  claim.reproduced = reproduced;
  return claim;
}

std::vector<SourceClaim> source_claims(bool quick, const std::function<void()>& step) {
  std::vector<SourceClaim> all;
  const auto add = [&](const std::vector<SourceClaim>& claims) {
    all.insert(all.end(), claims.begin(), claims.end());
    if (step) step();
  };
  add(cube_map_claims());
  add(bilinear_claims());
  add(irradiance_claims(quick));
  add(random_sample_claims(quick));
  return all;
}

bool rounds_to(double value, const std::string& printed) {
  const std::size_t point = printed.find('.');
  const auto decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
  const double unit = std::pow(10.0, -static_cast<double>(decimals));
  return std::abs(value - std::strtod(printed.c_str(), nullptr)) <= 0.5 * unit * (1 + 1e-9);
}

}  // namespace sh::numeric
