// Legendre functions: transforms over many rings at high degree, and of whole maps, beside libsharp where it is installed;
// the oracle at 100 digits. Gaunt coefficients: exact ones against 10 ms at degree 100, and in double.
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
#include "numeric/oracle/sphere_transform.hpp"
#include "tests/bench/harness.hpp"
#include "tests/bench/sharp_control.hpp"

namespace sh::bench {
namespace {

struct Rings {
  std::vector<double> z, sine, weight;
};

// As many Gauss-Legendre rings as make quadrature exact.
Rings gauss_rings(int degree) {
  const auto rule = numeric::gauss_legendre<double>(degree + 1);
  Rings rings{rule.nodes, {}, rule.weights};
  for (const double z : rings.z) rings.sine.push_back(std::sqrt((1 - z) * (1 + z)));
  return rings;
}

struct Goal {
  int degree;
  double synthesis, analysis;  // of the time of libsharp
};
constexpr std::array<Goal, 3> kGoals{{{100, 0.56, 0.56}, {300, 0.71, 0.79}, {1000, 0.74, 0.91}}};

// Coefficients of all orders, the rings of each by turns with the other library; nothing but Legendre functions.
void transforms(Table& table) {
  table.section("Legendre transforms of all orders over degree + 1 rings, ns a degree, order and ring",
                kHasSharp ? "control: libsharp without its Fourier transforms, one thread"
                          : "no control: libsharp is not installed");
  for (const Goal& goal : kGoals) {
    const int degree = goal.degree;
    const Rings rings = gauss_rings(degree);
    const numeric::LegendreRings transform(degree, rings.z, rings.sine);
    const auto terms = [degree](int m) { return 2 * static_cast<std::size_t>(degree - m) + 2; };
    const std::vector<double> a(terms(0), 0.5);
    const std::size_t of_order = 2 * rings.z.size();
    std::vector<double> values((static_cast<std::size_t>(degree) + 1) * of_order), back(a.size());
    const SharpControl sharp(degree, rings.z, 2 * degree + 2, false);
    const std::vector<double> t =
        least_times({[&] {
                       for (int m = 0; m <= degree; ++m) {
                         transform.synthesis(degree, m, std::span(a).first(terms(m)),
                                             std::span(values).subspan(m * of_order, of_order));
                       }
                     },
                     [&] { sharp.synthesis(); },
                     [&] {
                       for (int m = 0; m <= degree; ++m) {
                         transform.analysis(degree, m, std::span(values).subspan(m * of_order, of_order),
                                            std::span(back).first(terms(m)));
                       }
                     },
                     [&] { sharp.analysis(); }},
                    degree > 300 ? 7 : 15);
    const double ns = 1e9 / (0.5 * (degree + 1) * (degree + 2) * static_cast<double>(rings.z.size()));
    const std::string what = ", degree " + std::to_string(degree);
    if (kHasSharp) {
      table.ratio("synthesis" + what, "ns", t[0] * ns, t[1] * ns, "libsharp", goal.synthesis);
      table.ratio("analysis" + what, "ns", t[2] * ns, t[3] * ns, "libsharp", goal.analysis);
    } else {
      table.remark("synthesis" + what + ": " + std::to_string(t[0] * ns));
      table.remark("analysis" + what + ": " + std::to_string(t[2] * ns));
    }
  }
}

// Coefficients to maps and back.
void maps(Table& table) {
  table.section("Maps of degree + 1 rings, one thread, ms",
                kHasSharp ? "control: libsharp, one thread" : "no control: libsharp is not installed");
  for (const auto& goal : kGoals) {
    const int degree = goal.degree, around = numeric::smooth_around(2 * degree + 1);
    const Rings rings = gauss_rings(degree);
    const numeric::SphereTransform transform(degree, rings.z, rings.sine, around);
    std::vector<double> a(coefficient_count(degree), 0.5), map(rings.z.size() * around);
    const SharpControl sharp(degree, rings.z, around, true);
    const std::vector<double> t =
        least_times({[&] { transform.synthesis(a, map); }, [&] { sharp.synthesis(); },
                     [&] { transform.analysis(map, rings.weight, a); }, [&] { sharp.analysis(); }},
                    degree > 300 ? 7 : 15);
    const std::string what = ", degree " + std::to_string(degree);
    if (kHasSharp) {
      table.ratio("coefficients to map" + what, "ms", t[0] * 1e3, t[1] * 1e3, "libsharp", 1);
      table.ratio("map to coefficients" + what, "ms", t[2] * 1e3, t[3] * 1e3, "libsharp", 1);
    } else {
      table.remark("coefficients to map" + what + ": " + std::to_string(t[0] * 1e3));
      table.remark("map to coefficients" + what + ": " + std::to_string(t[2] * 1e3));
    }
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
  table.section("The oracle at degree 100, 100 digits, all 10,201 values of one direction, ms",
                "limit: six multiplications for each degree and order m >= 0: two of the recurrence, two of its norm, "
                "two values");
  constexpr int kDegree = 100, kMultiplications = 6 * (kDegree + 1) * (kDegree + 2) / 2;
  const auto d = numeric::normalized<numeric::Mpfr100>(1, 2, 3);
  std::vector<numeric::Mpfr100> out(numeric::coefficient_count(kDegree));
  const auto multiply = [&] {
    for (int i = 0; i < kMultiplications; ++i) out[i % 64] = d[i % 3] * d[(i + 1) % 3];
  };
  const auto t = least_times({[&] { numeric::basis(kDegree, d[0], d[1], d[2], out.data()); }, multiply}, 15);
  table.ratio("basis<Mpfr100>(100)", "ms", t[0] * 1e3, t[1] * 1e3, "multiplications", 2);
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
  maps(table);
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
