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

struct Worst {
  double error = 0;
  std::string where = "nowhere";

  void add(double other, const Direction& d, int i) {
    if (other <= error) return;
    const int l = static_cast<int>(std::sqrt(i));
    *this = {other, fmt::format("l={} m={} at ({:.17g}, {:.17g}, {:.17g})", l, i - l * (l + 1), d.x, d.y, d.z)};
  }
};

// Largest |error| / size over all coefficients; size(exact, l) in the type's epsilon. Values below the smallest normal
// number over epsilon have fewer digits and are left out by a size of 0.
template <class Real, class Size>
Worst worst_error(const std::vector<Direction>& directions, Size size) {
  Worst worst;
  for (const auto& given : directions) {
    const auto x = static_cast<Real>(given.x), y = static_cast<Real>(given.y), z = static_cast<Real>(given.z);
    std::vector<Real> values(coefficient_count(kDegree));
    std::vector<Mpfr100> exact(coefficient_count(kDegree));
    basis(kDegree, x, y, z, values.data());
    basis(kDegree, Mpfr100(x), Mpfr100(y), Mpfr100(z), exact.data());
    for (int i = 0; i < coefficient_count(kDegree); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Mpfr100 error = abs(Mpfr100(Mpfr100(values[at]) - exact[at]));
      const double scale = size(std::abs(static_cast<double>(exact[at])), static_cast<int>(std::sqrt(i)));
      if (scale == 0) continue;
      worst.add(static_cast<double>(Mpfr100(error / (static_cast<double>(machine_epsilon<Real>()) * scale))),
                {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}, i);
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
  const auto in_double = worst_error<double>(poles, own_size<double>);
  test::report_extreme("oracle l<=10 double, 1e-300..0.1 from the poles, eps x value", in_double.error, 30,
                       in_double.where);
  const auto in_float = worst_error<float>(poles, own_size<float>);
  test::report_extreme("oracle l<=10 float, 1e-300..0.1 from the poles, eps x value", in_float.error, 30,
                       in_float.where);
}

TEST(ExtremeOracle, EverywhereTheBandsMaximumBoundsTheError) {
  const auto all = standard_directions(500);
  const auto in_double = worst_error<double>(all, band_size);
  test::report_extreme("oracle l<=10 double, any direction, eps x band maximum", in_double.error, 6, in_double.where);
  const auto in_float = worst_error<float>(all, band_size);
  test::report_extreme("oracle l<=10 float, any direction, eps x band maximum", in_float.error, 6, in_float.where);
}

}  // namespace
}  // namespace sh::numeric
