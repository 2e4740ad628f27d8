// Typeset tables, read back by an independent reader and compared with the numeric oracle.
#include "symbolic/typeset/typeset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/zonal.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/typeset/typeset_families.hpp"
#include "tests/message_of.hpp"
#include "tests/symbolic/typeset_support.hpp"

namespace sh::symbolic {
namespace {

using namespace test;  // NOLINT(google-build-using-namespace): the vocabulary of these tests

TEST(Typeset, SurdsAreFractionsAndRoots) {
  EXPECT_EQ(tex_surd(Surd()), "0");
  EXPECT_EQ(tex_surd(Surd(1)), "1");
  EXPECT_EQ(tex_surd(Surd(-1)), "-1");
  EXPECT_EQ(tex_surd(Surd(cln::cl_RA(-3) / 4)), "-\\frac{3}{4}");
  EXPECT_EQ(tex_surd(Surd::square_root(cln::cl_RA(15) / 4, -1)), "\\frac{1}{2}\\sqrt{\\frac{15}{\\pi}}");
  EXPECT_EQ(tex_surd(Surd::square_root(4, 1)), "2\\sqrt{\\pi}");
  EXPECT_EQ(tex_surd(Surd::square_root(1, 2)), "\\pi");
  EXPECT_EQ(tex_surd(Surd::square_root(2, 3)), "\\pi\\sqrt{2\\pi}");
  EXPECT_EQ(tex_surd(Surd::square_root(cln::cl_RA(3) / 16, -3)), "\\frac{1}{4\\pi}\\sqrt{\\frac{3}{\\pi}}");
}

TEST(Typeset, ReaderRefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(test::evaluate("2\\,(x + 1)^{2} - \\frac{1}{2}", {{"x", 2}}), 17.5);
  EXPECT_THROW(test::evaluate("2 q", {}), std::runtime_error);
  EXPECT_THROW(test::evaluate("2 +", {}), std::runtime_error);
  EXPECT_THROW(test::evaluate("(2", {}), std::runtime_error);
  EXPECT_THROW(test::evaluate("2 )", {}), std::runtime_error);
}

TEST(Typeset, BasisMatchesTheOracleInBothFormats) {
  for (const char* family : {"basis", "solid"}) {
    const FormulaTable table = typeset_table(family, 6, find_preset("shforge"));
    const Formulas tex = test::read_formulas(tex_document(table));
    EXPECT_EQ(tex.size(), 49U);
    EXPECT_EQ(test::read_formulas(markdown_document(table)), tex);
    for (const auto& d : directions(20)) {
      const std::vector<double> expected = numeric::basis(6, d[0], d[1], d[2]);
      for (int l = 0; l <= 6; ++l) {
        for (int m = -l; m <= l; ++m) {
          const auto i = static_cast<std::size_t>(numeric::coefficient_index(l, m));
          EXPECT_NEAR(real(tex, function_symbol(l, m), point(d)), expected[i], kTolerance) << family << l << " " << m;
        }
      }
    }
  }
}

// Central differences of the oracle, which evaluates the homogeneous form off the sphere too.
TEST(Typeset, DerivativesMatchDifferencesOfTheOracle) {
  const Formulas gradient = formulas("gradient", 3);
  const Formulas hessian = formulas("hessian", 3);
  const std::string names = "xyz";
  constexpr long double kStep = 1e-4L;
  const auto at = [](const std::array<double, 3>& d, std::size_t a, long double u, std::size_t b, long double v) {
    std::array<long double, 3> p;
    std::ranges::copy(d, p.begin());
    p[a] += u;
    p[b] += v;
    std::vector<long double> out(16);
    numeric::basis(3, p[0], p[1], p[2], out.data());
    return out;
  };
  for (const auto& d : directions(3)) {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto plus = at(d, a, kStep, 0, 0);
      const auto minus = at(d, a, -kStep, 0, 0);
      for (std::size_t i = 0; i < 16; ++i) {
        const DegreeOrder y = degree_order(static_cast<int>(i));
        const std::string partial = std::string("\\partial_{") + names[a] + "} " + function_symbol(y.degree, y.order);
        const auto slope = static_cast<double>((plus[i] - minus[i]) / (2 * kStep));
        EXPECT_NEAR(real(gradient, partial, point(d)), slope, 2e-8) << partial;  // measured 6e-9: the step
      }
      for (std::size_t b = a; b < 3; ++b) {
        const auto pp = at(d, a, kStep, b, kStep);
        const auto pm = at(d, a, kStep, b, -kStep);
        const auto mp = at(d, a, -kStep, b, kStep);
        const auto mm = at(d, a, -kStep, b, -kStep);
        for (std::size_t i = 0; i < 16; ++i) {
          const DegreeOrder y = degree_order(static_cast<int>(i));
          const std::string partial =
              std::string("\\partial_{") + names[a] + names[b] + "} " + function_symbol(y.degree, y.order);
          const auto bend = static_cast<double>((pp[i] - pm[i] - mp[i] + mm[i]) / (4 * kStep * kStep));
          EXPECT_NEAR(real(hessian, partial, point(d)), bend, 1e-11) << partial;  // measured 2.8e-12: rounding
        }
      }
    }
  }
}

void expect_rotation(const Formulas& table, int degree, const Values& values, const std::array<double, 9>& r) {
  const std::vector<std::vector<double>> expected = numeric::rotation_bands(degree, r.data());
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n) {
        const std::string symbol = "D^{" + std::to_string(l) + "}" + tex_indices(m, n);
        const int place = (m + l) * (2 * l + 1) + n + l;
        EXPECT_NEAR(real(table, symbol, values), expected[l][place], kTolerance) << symbol;
      }
    }
  }
}

TEST(Typeset, RotationMatchesTheOracle) {
  const std::array<double, 4> q{0.1, -0.7, 0.5, 0.5};  // |q| = 1: 0.01 + 0.49 + 0.25 + 0.25
  const std::array<double, 9> r = matrix_of(q);
  expect_rotation(formulas("rotation", 3), 3, entries_of(r), r);
  expect_rotation(formulas("rotation-quaternion", 4), 4, {{"w", q[0]}, {"x", q[1]}, {"y", q[2]}, {"z", q[3]}}, r);
}

TEST(Typeset, TurnsAboutTheAxesMatchTheOracle) {
  const double angle = 0.83;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  expect_rotation(formulas("rotation-z", 5), 5, {{"c", c}, {"s", s}}, {c, -s, 0, s, c, 0, 0, 0, 1});
  const Values half{{"c", std::cos(angle / 2)}, {"s", std::sin(angle / 2)}};
  expect_rotation(formulas("rotation-y", 5), 5, half, {c, 0, s, 0, 1, 0, -s, 0, c});
  expect_rotation(formulas("rotation-x90", 5), 5, {}, {1, 0, 0, 0, 0, -1, 0, 1, 0});
}

// d_m0 = sqrt(4 pi / (2l+1)) times the spherical Legendre function, phase included.
TEST(Typeset, WignerMatricesMatchTheStandardLibrary) {
  const double beta = 0.7;
  const Formulas table = formulas("wigner-d", 5);
  const Values half{{"c", std::cos(beta / 2)}, {"s", std::sin(beta / 2)}};
  for (int l = 0; l <= 5; ++l) {
    for (int m = 0; m <= l; ++m) {
      const double expected = std::sqrt(4 * std::numbers::pi / (2 * l + 1)) *
                              std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(m), beta);
      EXPECT_NEAR(real(table, "d^{" + std::to_string(l) + "}" + tex_indices(m, 0), half), expected, kTolerance);
    }
  }
}

TEST(Typeset, GauntMatchesQuadrature) {
  const Formulas table = formulas("gaunt", 2);
  EXPECT_EQ(table.size(), 25U);
  std::vector<double> sums(729);
  for (const auto& node : numeric::sphere_rule<double>(6)) {
    const std::vector<double> y = numeric::basis(2, node.x, node.y, node.z);
    for (std::size_t t = 0; t < 729; ++t) sums[t] += node.weight * y[t / 81] * y[t / 9 % 9] * y[t % 9];
  }
  for (int t = 0; t < 729; ++t) {
    const IndexTriple triple = sorted({t / 81, t / 9 % 9, t % 9});
    const std::string symbol = "G" + tex_indices(triple.i, triple.j, triple.k);
    EXPECT_NEAR(real(table, symbol, {}), sums[t], kTolerance) << symbol;
  }
}

struct Functions {
  std::vector<double> a;
  std::vector<double> b;
  std::vector<double> zonal;
  Values values;
};

Functions random_functions(int degree) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Functions f;
  const auto fill = [&](std::vector<double>& list, const char* name, int count) {
    for (int i = 0; i < count; ++i) {
      list.push_back(uniform(random));
      f.values[std::string(name) + "_{" + std::to_string(i) + "}"] = list.back();
    }
  };
  fill(f.a, "a", numeric::coefficient_count(degree));
  fill(f.b, "b", numeric::coefficient_count(degree));
  fill(f.zonal, "h", degree + 1);
  return f;
}

double value_of(const std::vector<double>& coefficients, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) sum += coefficients[i] * y[i];
  return sum;
}

TEST(Typeset, ProductsMatchQuadrature) {
  constexpr int kDegree = 3;
  const Functions f = random_functions(kDegree);
  std::vector<double> turned_h(16);
  for (int l = 0; l <= kDegree; ++l) {
    turned_h[coefficient_index(l, 0)] = f.zonal[l];
  }
  std::vector<double> product(16);
  std::vector<double> square(16);
  std::vector<double> zonal(16);
  for (const auto& node : numeric::sphere_rule<double>(3 * kDegree)) {
    const std::vector<double> y = numeric::basis(kDegree, node.x, node.y, node.z);
    const double a = value_of(f.a, y);
    for (std::size_t k = 0; k < 16; ++k) {
      product[k] += node.weight * a * value_of(f.b, y) * y[k];
      square[k] += node.weight * a * a * y[k];
      zonal[k] += node.weight * a * value_of(turned_h, y) * y[k];
    }
  }
  const Formulas transfer = formulas("transfer", kDegree);
  const Formulas product_table = formulas("product", kDegree);
  const Formulas square_table = formulas("square", kDegree);
  const Formulas zonal_table = formulas("zonal-product", kDegree);
  for (int k = 0; k < 16; ++k) {
    const std::string symbol = "c_{" + std::to_string(k) + "}";
    const auto place = static_cast<std::size_t>(k);
    EXPECT_NEAR(real(product_table, symbol, f.values), product[place], kTolerance) << k;
    EXPECT_NEAR(real(square_table, symbol, f.values), square[place], kTolerance) << k;
    EXPECT_NEAR(real(zonal_table, symbol, f.values), zonal[place], kTolerance) << k;
    double row = 0;
    for (int i = 0; i < 16; ++i) {
      row += real(transfer, "M" + tex_indices(k, i), f.values) * f.a[i];
    }
    EXPECT_NEAR(row, product[place], kTolerance) << k;
  }
}

struct ZonalSample {
  std::string family;
  Values values;
  double from;
  double to;
  std::function<double(double)> f;
};

std::vector<ZonalSample> zonal_samples() {
  const auto one = [](double) { return 1.0; };
  const double s = 0.3;
  const double c = std::sqrt(1 - s * s);
  return {
      {"cap", {{"c", 0.35}}, 0.35, 1, one},
      {"cap-small", {{"u", 0.02}}, 0.98, 1, one},
      {"cap-complement", {{"c", 0.35}}, -1, 0.35, one},
      {"annulus", {{"c_{0}", -0.2}, {"c_{1}", 0.6}}, -0.2, 0.6, one},
      {"hemisphere", {}, 0, 1, one},
      {"clamped-cosine", {}, 0, 1, [](double t) { return t; }},
      {"cosine-power", {{"n", 5}}, 0, 1, [](double t) { return std::pow(t, 5); }},
      {"linear-lobe", {{"a", 2}, {"c", 0.25}}, 0.25, 1, [](double t) { return 2 * (t - 0.25); }},
      {"sphere-light", {{"s", s}, {"c", c}}, c, 1, one},
      {"sphere-light-irradiance", {{"s", s}, {"c", c}}, c, 1, [s](double) { return 1 / (std::numbers::pi * s * s); }},
      {"cie-overcast", {}, 0, 1, [](double t) { return (1 + 2 * t) / 3; }}};
}

TEST(Typeset, ZonalFunctionsMatchQuadrature) {
  const numeric::GaussLegendreRule<double> rule = numeric::gauss_legendre<double>(12);
  for (const ZonalSample& sample : zonal_samples()) {
    const Formulas table = formulas(sample.family, 6);
    EXPECT_EQ(table.size(), 7U);
    const double half = (sample.to - sample.from) / 2;
    for (int l = 0; l <= 6; ++l) {
      double expected = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double t = sample.from + half * (rule.nodes[i] + 1);
        const double y = numeric::basis_value(l, 0, std::sqrt(1 - t * t), 0.0, t);
        expected += 2 * std::numbers::pi * half * rule.weights[i] * sample.f(t) * y;
      }
      EXPECT_NEAR(real(table, "z_{" + std::to_string(l) + "}", sample.values), expected, kTolerance)
          << sample.family << " " << l;
    }
  }
}

TEST(Typeset, LightsAndIrradianceMatchTheOracle) {
  const Formulas light = formulas("directional-light", 8);
  const Formulas irradiance = formulas("irradiance", 8);
  const Formulas convolution = formulas("convolution", 8);
  for (int l = 0; l <= 8; ++l) {
    const std::string index = "_{" + std::to_string(l) + "}";
    EXPECT_NEAR(real(light, "z" + index, {}), numeric::basis_value(l, 0, 0.0, 0.0, 1.0), kTolerance);
    EXPECT_NEAR(real(irradiance, "A" + index, {}), numeric::clamped_cosine_factor<double>(l), kTolerance);
    EXPECT_NEAR(real(convolution, "C" + index, {}), std::sqrt(4 * std::numbers::pi / (2 * l + 1)), kTolerance);
  }
}

TEST(Typeset, TurnedZonalFunctionMatchesTheOracle) {
  const Formulas table = formulas("turned-zonal", 5);
  for (const auto& d : directions(10)) {
    const std::vector<double> y = numeric::basis(5, d[0], d[1], d[2]);
    for (int i = 0; i < 36; ++i) {
      const DegreeOrder index = degree_order(i);
      Values values = point(d);
      values["h_{" + std::to_string(index.degree) + "}"] = 0.7;
      const double expected = std::sqrt(4 * std::numbers::pi / (2 * index.degree + 1)) * 0.7 * y[i];
      EXPECT_NEAR(real(table, "c" + tex_indices(index.degree, index.order), values), expected, kTolerance) << i;
    }
  }
}

TEST(Typeset, EveryFamilyRefusesDegreesBeyondItsLimitAndSaysWhy) {
  for (const TypesetFamily& family : typeset_families()) {
    EXPECT_FALSE(typeset_table(family.name, 2, find_preset("shforge")).rows.empty()) << family.name;
    EXPECT_FALSE(typeset_table(family.name, 0, find_preset("shforge")).rows.empty()) << family.name;
    EXPECT_THROW(typeset_table(family.name, -1, find_preset("shforge")), std::invalid_argument);
    const std::string message =
        sh::test::message_of([&] { typeset_table(family.name, family.max_degree + 1, find_preset("shforge")); });
    EXPECT_NE(message.find("0 to " + std::to_string(family.max_degree)), std::string::npos) << message;
    EXPECT_NE(message.find(family.limit), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace sh::symbolic
