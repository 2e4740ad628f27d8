// Legendre functions: transforms over many rings at high degree, and the oracle at 100 digits. Gaunt coefficients:
// exact ones against 10 ms at degree 100, and in double.
//
// The target of a transform is a figure of another library, ducc (b3de68c2), measured on another machine: 0.092 ns a
// degree, order and ring at degree 1000, 0.14 at 300, 0.32 at 100. The speed of multiply-adds converts it to this
// machine: the other one did 39.7 of doubles a nanosecond. (Side by side on this machine, ducc takes this time, and the
// transforms take two thirds of it.)
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "numeric/methods/methods.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/gaunt.hpp"
#include "numeric/oracle/legendre_rings.hpp"
#include "numeric/oracle/legendre_values.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/real.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr double kOperations = 39.7;  // multiply-adds of doubles a nanosecond where ducc was measured

struct Peer {
  int degree;
  double ns;
};
constexpr std::array<Peer, 3> kDucc{{{100, 0.32}, {300, 0.14}, {1000, 0.092}}};

struct Rings {
  std::vector<double> z, sine;
};

// As many Gauss-Legendre rings as make quadrature exact.
Rings gauss_rings(int degree) {
  Rings rings{numeric::gauss_legendre<double>(degree + 1).nodes, {}};
  for (const double z : rings.z) rings.sine.push_back(std::sqrt((1 - z) * (1 + z)));
  return rings;
}

// Nanoseconds of a double's multiply-add, eight to an operation of fma_task.
double multiply_add() { return least_times({fma_task()})[0] / kFmaOperations / 8 * 1e9; }

// Every eighth order, each the least of some passes: a whole transform is longer than the machine leaves alone.
void transforms(Table& table) {
  table.section("Legendre transforms over degree + 1 rings, two coefficients each, ns a degree, order and ring",
                "target: three times ducc, in multiply-adds of this machine");
  const double limit = multiply_add() * kOperations;
  for (const auto& [of_degree, ducc] : kDucc) {
    const int degree = of_degree;
    const Rings rings = gauss_rings(degree);
    const numeric::LegendreRings transform(degree, rings.z, rings.sine);
    const std::vector<double> a(2 * static_cast<std::size_t>(degree) + 2, 0.5);
    std::vector<double> values(2 * rings.z.size());
    std::vector<double> back(a.size());
    std::array<double, 2> seconds{};
    double count = 0;
    for (int m = 0; m <= degree; m += 8) {
      const std::size_t n = 2 * static_cast<std::size_t>(degree - m) + 2;
      const auto t = least_times({[&] { transform.synthesis(degree, m, std::span(a).first(n), values); },
                                  [&] { transform.analysis(degree, m, values, std::span(back).first(n)); }},
                                 5);
      for (std::size_t i = 0; i < 2; ++i) seconds[i] += t[i];
      count += 0.5 * static_cast<double>(n * rings.z.size());
    }
    const std::string what = ", degree " + std::to_string(degree);
    table.ratio("synthesis" + what, "ns", seconds[0] / count * 1e9, ducc * limit, "ducc", 3);
    table.ratio("analysis" + what, "ns", seconds[1] / count * 1e9, ducc * limit, "ducc", 3);
  }
}

void errors(Table& table) {
  constexpr int kDegree = 1000;
  constexpr std::array<std::size_t, 15> kRings{0, 1, 2, 5, 20, 40, 80, 160, 320, 490, 499, 500, 501, 960, 1000};
  const Rings rings = gauss_rings(kDegree);
  const numeric::LegendreRings transform(kDegree, rings.z, rings.sine);
  double worst = 0;  // next to the poles, at the equator and between
  for (const int m : {0, 1, 10, 100, 500, 900}) {
    const auto terms = static_cast<std::size_t>(kDegree - m) + 1;
    std::vector<double> a(2 * terms), values(2 * rings.z.size());
    double size = 0;
    for (std::size_t k = 0; k < terms; ++k) {
      a[2 * k] = std::cos(static_cast<double>(k * k));
      size += a[2 * k] * a[2 * k] * (2 * static_cast<double>(k) + 2 * m + 1) / (4 * numeric::pi<double>());
    }
    transform.synthesis(kDegree, m, a, values);
    for (const std::size_t i : kRings) {
      std::vector<long double> p(terms);
      numeric::legendre_column<long double>(kDegree, m, rings.z[i], rings.sine[i], p.data());
      long double sum = -static_cast<long double>(values[2 * i]);
      for (std::size_t k = 0; k < terms; ++k) sum += static_cast<long double>(a[2 * k]) * p[k];
      worst = std::max(worst, static_cast<double>(std::abs(sum)) / std::sqrt(size));
    }
  }
  table.section("Error of a synthesis at degree 1000, against long double", "unit: root of the sum of squared terms");
  table.figure("synthesis, poles to equator", scientific(worst), worst, 1e-12);
}

void oracle(Table& table) {
  table.section("The oracle at degree 100, 100 digits, all 10,201 values of one direction, ms");
  const auto d = numeric::normalized<numeric::Mpfr100>(1, 2, 3);
  std::vector<numeric::Mpfr100> out(numeric::coefficient_count(100));
  const auto t = least_times({[&] { numeric::basis(100, d[0], d[1], d[2], out.data()); }}, 15);
  table.figure("basis<Mpfr100>(100)", "ms", t[0] * 1e3, 3);
}

void methods(Table& table) {
  table.section("All P_lm of one ring at degree 400, ns a value, by method");
  constexpr int kDegree = 400;
  std::vector<double> out(numeric::legendre_count(kDegree));
  for (const auto& method : numeric::legendre_methods<double>()) {
    const auto t = least_times({[&] { method.run(kDegree, 0.8, 0.6, out.data()); }}, 5);
    table.remark(std::string(method.name) + ": " + std::to_string(t[0] * 1e9 / static_cast<double>(out.size())));
  }
}

}  // namespace

void legendre(Table& table) {
  transforms(table);
  errors(table);
  oracle(table);
  methods(table);
}

void gaunt(Table& table) {
  table.section("Gaunt coefficients of the oracle", "orders (l/2, -l/4, -l/4)");
  for (const int l : {100, 1000}) {
    const numeric::Triple degrees{l, l, l};
    const numeric::Triple orders{l / 2, -l / 4, -l / 4};
    const std::vector<double> t = least_times(
        {[&] { keep(numeric::gaunt_exact(degrees, orders)); }, [&] { keep(numeric::gaunt<double>(degrees, orders)); }});
    const std::string what = "degree " + std::to_string(l);
    table.figure("exact, " + what, "ms", t[0] * 1e3, l == 100 ? 10 : 100);
    table.remark("double, " + what + ": " + scientific(t[1] * 1e3) + " ms");
  }
}

}  // namespace sh::bench
