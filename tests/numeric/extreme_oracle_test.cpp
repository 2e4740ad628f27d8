// The oracle's own error at low degree where inputs are extreme, against itself at 100 digits: near the poles relative
// to each value, whose size is down to 1e-300; everywhere in units of the band's maximum.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::numeric {
namespace {

constexpr int kDegree = 10;

// Largest |error| / size over all coefficients; size(exact, l) in the type's epsilon. Values below the smallest normal
// number over epsilon have fewer digits and are left out by a size of 0.
template <class Real, class Size>
test::Worst worst_error(const std::vector<Direction>& directions, Size size) {
  test::Worst worst;
  for (const auto& given : directions) {
    const auto x = static_cast<Real>(given.x), y = static_cast<Real>(given.y), z = static_cast<Real>(given.z);
    const auto values = basis(kDegree, x, y, z);
    std::vector<Mpfr100> exact(values.size());
    basis(kDegree, Mpfr100(x), Mpfr100(y), Mpfr100(z), exact.data());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const int l = static_cast<int>(std::sqrt(i));
      const Mpfr100 error = abs(Mpfr100(Mpfr100(values[i]) - exact[i]));
      const double scale = size(std::abs(static_cast<double>(exact[i])), l);
      if (scale == 0) continue;
      worst.keep(static_cast<double>(Mpfr100(error / (static_cast<double>(machine_epsilon<Real>()) * scale))),
                 "l={} m={} at ({:.17g}, {:.17g}, {:.17g})", l, static_cast<int>(i) - l * (l + 1), x, y, z);
    }
  }
  return worst;
}

template <class Real>
double own_size(double value, int /*degree*/) {
  const auto least = static_cast<double>(std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon());
  return value >= least ? value : 0;
}
double band_size(double /*value*/, int degree) { return band_maximum(degree); }

TEST(ExtremeOracle, NearThePolesEveryValueKeepsItsDigits) {
  const auto poles = near_pole_directions();
  const std::string what = ", 1e-300..0.1 from the poles, eps x value";
  worst_error<double>(poles, own_size<double>).report("oracle l<=10 double" + what, 30);
  worst_error<float>(poles, own_size<float>).report("oracle l<=10 float" + what, 30);
}

TEST(ExtremeOracle, EverywhereTheBandsMaximumBoundsTheError) {
  const auto all = standard_directions(500);
  const std::string what = ", any direction, eps x band maximum";
  worst_error<double>(all, band_size).report("oracle l<=10 double" + what, 6);
  worst_error<float>(all, band_size).report("oracle l<=10 float" + what, 6);
}

}  // namespace
}  // namespace sh::numeric
