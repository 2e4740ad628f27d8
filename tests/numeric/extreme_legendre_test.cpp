// The oracle's Legendre functions at degree 1000 and 10,000 in double against 50 digits at the same input, at the worst
// colatitudes that a search finds: over the whole range, next to the poles, at the equator, in the deep tail.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numeric/oracle/legendre_rings.hpp"
#include "numeric/oracle/legendre_values.hpp"
#include "numeric/oracle/real.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "tests/numeric/extreme.hpp"
#include "tests/numeric/hill_climb.hpp"
#include "tests/numeric/keep_worst.hpp"

namespace sh::numeric {
namespace {

using test::hill_climb;
using test::report_extreme;
using test::WorstInput;

// A row in double beside its exact values.
struct Row {
  std::vector<double> computed, exact, error, amplitude;  // (degree + 1)

  Row(int degree, double z, double sine)
      : computed(degree + 1), exact(computed.size()), error(computed.size()), amplitude(computed.size()) {
    std::vector<Mpfr50> wide(computed.size());
    legendre_row(degree, z, sine, computed.data());
    legendre_row(degree, Mpfr50(z), Mpfr50(sine), wide.data());
    for (std::size_t m = 0; m < wide.size(); ++m) {
      exact[m] = static_cast<double>(wide[m]);
      error[m] = std::abs(static_cast<double>(Mpfr50(wide[m] - computed[m])));
    }
    legendre_amplitude(degree, sine, exact.data(), amplitude.data());
  }
};

Row row_at(int degree, double theta) { return {degree, std::cos(theta), std::sin(theta)}; }

// Where an amplitude is at least 1e-290 an error is held against it.
double error_of_amplitude(const Row& row) {
  double worst = 0;
  for (std::size_t m = 0; m < row.error.size(); ++m) {
    if (row.amplitude[m] >= 1e-290) keep_worst(worst, row.error[m] / row.amplitude[m]);
  }
  return worst;
}

double error_of_band(int degree, const Row& row) {
  double worst = 0;
  for (const double e : row.error) keep_worst(worst, e / band_maximum(degree));
  return worst;
}

// The worst over the whole range, next to a pole (1e-9 .. 0.1) and next to the equator.
template <class Error>
WorstInput worst_colatitude(int starts, int steps, const Error& error) {
  const double quarter = std::acos(-1.0) / 2;
  WorstInput worst = hill_climb(0, 2 * quarter, starts, steps, error);
  const auto keep = [&](WorstInput found, double theta) {
    if (found.error > worst.error) worst = {theta, found.error};
  };
  // Many starts: errors are largest where z is 1 - 2^-53, theta = 1.05e-8 to 1.8e-8, and each product rounds downwards.
  const WorstInput pole = hill_climb(-9, -1, 6 * starts, steps / 4, [&](double t) { return error(std::pow(10, t)); });
  keep(pole, std::pow(10, pole.input));
  const WorstInput equator =
      hill_climb(-9, -1, starts, steps, [&](double t) { return error(quarter + std::pow(10, t)); });
  keep(equator, quarter + std::pow(10, equator.input));
  return worst;
}

std::string theta_text(const WorstInput& worst) { return fmt::format("theta={:.17g}", worst.input); }

TEST(ExtremeLegendre, Degree1000AtTheWorstColatitude) {
  const auto local = worst_colatitude(5, 30, [](double theta) { return error_of_amplitude(row_at(1000, theta)); });
  report_extreme("P_lm l=1000 double, every order, of the local amplitude", local.error, 1e-12, theta_text(local));
  const auto band = worst_colatitude(5, 30, [](double theta) { return error_of_band(1000, row_at(1000, theta)); });
  report_extreme("P_lm l=1000 double, every order, of the band maximum", band.error, 1e-13, theta_text(band));
}

TEST(ExtremeLegendre, Degree10000AtTheWorstColatitude) {
  const auto local = worst_colatitude(2, 8, [](double theta) { return error_of_amplitude(row_at(10000, theta)); });
  report_extreme("P_lm l=10000 double, every order, of the local amplitude", local.error, 1e-11, theta_text(local));
  const auto band = worst_colatitude(2, 8, [](double theta) { return error_of_band(10000, row_at(10000, theta)); });
  report_extreme("P_lm l=10000 double, every order, of the band maximum", band.error, 1e-11, theta_text(band));
}

// Values of 1e-308 to 1e-290: relative error.
double deep_error(const Row& row) {
  double worst = 0;
  for (std::size_t m = 0; m < row.error.size(); ++m) {
    const double size = std::abs(row.exact[m]);
    if (size >= 2.3e-308 && size <= 1e-290) keep_worst(worst, row.error[m] / size);
  }
  return worst;
}

// Subnormal values: against their spacing and 1e-13 of themselves. Zero where that is nearest, and nowhere else.
double subnormal_error(const Row& row) {
  double worst = 0;
  for (std::size_t m = 0; m < row.error.size(); ++m) {
    if (std::abs(row.exact[m]) >= 2.3e-308) continue;
    // Scaled by 2^100, since the spacing itself cannot be added to.
    const double unit = 0x1p-974 + 1e-13 * 0x1p100 * std::abs(row.exact[m]);
    keep_worst(worst, 0x1p100 * std::abs(row.exact[m] - row.computed[m]) / unit);
    if ((row.exact[m] == 0) != (row.computed[m] == 0)) keep_worst(worst, 1e9);
  }
  return worst;
}

TEST(ExtremeLegendre, Degree1000NearThePoleKeepsTheDeepTail) {
  const auto theta = [](double t) { return std::pow(10, t); };
  const auto search = [&](const auto& error) {
    auto worst = hill_climb(-300, 0, 12, 20, [&](double t) { return error(row_at(1000, theta(t))); });
    const auto near = hill_climb(-3, 0.1, 12, 20, [&](double t) { return error(row_at(1000, theta(t))); });
    if (near.error > worst.error) worst = near;
    worst.input = theta(worst.input);
    return worst;
  };
  const auto deep = search(deep_error);
  report_extreme("P_lm l=1000 double, values of 1e-308 to 1e-290, relative", deep.error, 1e-12, theta_text(deep));
  const auto subnormal = search(subnormal_error);
  report_extreme("P_lm l=1000 double, subnormal values, of spacing + 1e-13 value", subnormal.error, 1,
                 theta_text(subnormal));
}

// At sine = 1e-300 the orders 0 and 1 are there, and order 2 would be 1e-596.
TEST(ExtremeLegendre, PolesAndNextToThem) {
  test::Worst worst;
  for (const int degree : {1, 2, 1000, 10000}) {
    for (const double sine : {0.0, 5e-324, 1e-300, 1e-200, 1e-100}) {
      for (const double z : {1.0, -1.0}) {
        const Row row(degree, z, sine);
        for (std::size_t m = 0; m < row.error.size(); ++m) {
          const double size = std::max(std::abs(row.exact[m]), 2.3e-308 / 1e-13);
          worst.keep(row.error[m] / size, "l={} m={} z={} sine={:g}", degree, m, z, sine);
        }
      }
    }
  }
  worst.report("P_lm l<=10000 double, poles and 5e-324..1e-100 off, relative", 1e-12);
}

// P_l0^2 + 2 sum P_lm^2 = (2l+1) / 4 pi: an identity that no reference takes part in.
double addition_error(int degree, double theta) {
  std::vector<double> row(degree + 1);
  legendre_row(degree, std::cos(theta), std::sin(theta), row.data());
  long double sum = -static_cast<long double>(row[0]) * row[0];
  for (const double p : row) sum += 2 * static_cast<long double>(p) * p;
  return std::abs(static_cast<double>(sum) / (band_maximum(degree) * band_maximum(degree)) - 1);
}

// The squares of cos and sin sum to 1 within 2e-16 only, which the degree multiplies: 2e-13 and 2e-12.
TEST(ExtremeLegendre, AdditionTheoremAtDegree1000And10000) {
  const auto low = worst_colatitude(20, 30, [](double theta) { return addition_error(1000, theta); });
  report_extreme("addition theorem l=1000 double, relative", low.error, 1e-12, theta_text(low));
  const auto high = worst_colatitude(8, 15, [](double theta) { return addition_error(10000, theta); });
  report_extreme("addition theorem l=10000 double, relative", high.error, 1e-11, theta_text(high));
}

// One order of a transform: random coefficients, rings next to the poles, to the equator and between.
TEST(ExtremeLegendre, TransformsOverRingsAtDegree1000) {
  constexpr int kDegree = 1000;
  std::vector<double> z, sine;
  for (const double theta :
       {1e-300, 1e-8, 1e-4, 1.6e-3, 0.01, 0.1, 0.149, 0.151, 0.4, 1.0, 1.4, 1.56, 1.5705, 1.5708}) {
    z.push_back(std::cos(theta));
    sine.push_back(std::sin(theta));
  }
  const LegendreRings rings(kDegree, z, sine);
  test::Worst worst;
  for (const int order : {0, 1, 2, 10, 100, 500, 990}) {
    const auto terms = static_cast<std::size_t>(kDegree - order) + 1;
    std::vector<double> a(2 * terms), values(2 * z.size());
    double size = 0;
    for (std::size_t k = 0; k < terms; ++k) {
      a[2 * k] = std::cos(static_cast<double>(k * k));
      size += std::pow(a[2 * k] * band_maximum(order + static_cast<int>(k)), 2);
    }
    rings.synthesis(kDegree, order, a, values);
    for (std::size_t i = 0; i < z.size(); ++i) {
      std::vector<long double> p(terms);
      legendre_column<long double>(kDegree, order, z[i], sine[i], p.data());
      long double error = -values[2 * i];
      for (std::size_t k = 0; k < terms; ++k) error += a[2 * k] * p[k];
      worst.keep(static_cast<double>(std::abs(error)) / std::sqrt(size), "m={} z={:.17g} sine={:.17g}", order, z[i],
                 sine[i]);
    }
  }
  worst.report("LegendreRings l<=1000 double, of the root of the sum of squared terms", 1.2e-13);
}

}  // namespace
}  // namespace sh::numeric
