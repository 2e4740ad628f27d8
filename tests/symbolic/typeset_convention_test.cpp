// Typeset tables in every convention: the typeset functions, rotations, products and zonal functions fit together.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "numeric/oracle/quadrature.hpp"
#include "symbolic/product/gaunt.hpp"
#include "tests/symbolic/typeset_support.hpp"

namespace sh::symbolic {
namespace {

using namespace test;  // NOLINT(google-build-using-namespace): the vocabulary of these tests

// In each convention the typeset functions and the typeset rotation fit together: sum c'_m Y_m(s) = sum c_m Y_m(R^-1
// s).
TEST(Typeset, RotationsFitTheFunctionsInEveryConvention) {
  const std::array<double, 9> r = matrix_of({0.1, -0.7, 0.5, 0.5});
  const Values turn = entries_of(r);
  for (const Preset& preset : presets()) {
    const Formulas rotation = formulas("rotation", 2, preset.name);
    for (const char* family : {"basis", "solid"}) {
      const Formulas basis = formulas(family, 2, preset.name);
      for (const auto& s : directions(3)) {
        const std::array<double, 3> back{r[0] * s[0] + r[3] * s[1] + r[6] * s[2],
                                         r[1] * s[0] + r[4] * s[1] + r[7] * s[2],
                                         r[2] * s[0] + r[5] * s[1] + r[8] * s[2]};
        for (int n = -2; n <= 2; ++n) {  // the function (2, n)
          std::complex<double> turned = 0;
          for (int m = -2; m <= 2; ++m) {
            const auto entry = rotation.find("D^{2}" + tex_indices(m, n));
            if (entry == rotation.end()) continue;
            turned += test::evaluate(entry->second, turn) * test::evaluate(basis.at(function_symbol(2, m)), point(s));
          }
          const std::complex<double> expected = test::evaluate(basis.at(function_symbol(2, n)), point(back));
          EXPECT_NEAR(std::abs(turned - expected), 0, kTolerance) << preset.name << " " << n;
        }
      }
    }
  }
}

TEST(Typeset, GauntFitsTheFunctionsInEveryConventionThatKeepsRadiance) {
  for (const Preset& preset : presets()) {
    if (preset.convention.folded != Folded::kNothing) {
      EXPECT_THROW(formulas("gaunt", 1, preset.name), std::invalid_argument);
      continue;
    }
    const Formulas gaunt = formulas("gaunt", 1, preset.name);
    const Formulas basis = formulas("basis", 1, preset.name);
    std::vector<std::complex<double>> sums(64);
    for (const auto& node : numeric::sphere_rule<double>(3)) {
      std::vector<std::complex<double>> y;
      for (int i = 0; i < 4; ++i) {
        const DegreeOrder index = degree_order(i);
        y.push_back(
            test::evaluate(basis.at(function_symbol(index.degree, index.order)), point({node.x, node.y, node.z})));
      }
      for (std::size_t t = 0; t < 64; ++t) sums[t] += node.weight * y[t / 16] * y[t / 4 % 4] * y[t % 4];
    }
    for (int t = 0; t < 64; ++t) {
      const IndexTriple triple = sorted({t / 16, t / 4 % 4, t % 4});
      const auto entry = gaunt.find("G" + tex_indices(triple.i, triple.j, triple.k));
      const std::complex<double> value = entry == gaunt.end() ? 0 : test::evaluate(entry->second, {});
      EXPECT_NEAR(std::abs(value - sums[t]), 0, kTolerance) << preset.name << " " << t;
    }
  }
}

// A cap, its coefficients in a convention, summed with the functions of that convention: the same value everywhere.
TEST(Typeset, ZonalFunctionsAndTurnsFitTheFunctionsInEveryConvention) {
  const Formulas own_cap = formulas("cap", 2);
  const Formulas own_basis = formulas("basis", 2);
  const Values half_angle{{"c", 0.4}};
  for (const Preset& preset : presets()) {
    if (preset.convention.folded != Folded::kNothing) continue;
    const Formulas cap = formulas("cap", 2, preset.name);
    const Formulas basis = formulas("basis", 2, preset.name);
    const Formulas turned = formulas("turned-zonal", 2, preset.name);
    Values axis = point({0.6, 0.0, 0.8});
    for (int l = 0; l <= 2; ++l) {
      axis["h_{" + std::to_string(l) + "}"] = real(cap, "z_{" + std::to_string(l) + "}", half_angle);
    }
    for (const auto& s : directions(5)) {
      double expected = 0;
      std::complex<double> upright = 0;
      std::complex<double> tilted = 0;
      const double t = 0.6 * s[0] + 0.8 * s[2];
      double expected_tilted = 0;
      for (int l = 0; l <= 2; ++l) {
        const std::string z = "z_{" + std::to_string(l) + "}";
        const double own = real(own_cap, z, half_angle);
        expected += own * real(own_basis, function_symbol(l, 0), point(s));
        expected_tilted += own * real(own_basis, function_symbol(l, 0), point({0, 0, t}));
        upright += real(cap, z, half_angle) * test::evaluate(basis.at(function_symbol(l, 0)), point(s));
        for (int m = -l; m <= l; ++m) {
          tilted += test::evaluate(turned.at("c" + tex_indices(l, m)), axis) *
                    test::evaluate(basis.at(function_symbol(l, m)), point(s));
        }
      }
      EXPECT_NEAR(std::abs(upright - expected), 0, kTolerance) << preset.name;
      EXPECT_NEAR(std::abs(tilted - expected_tilted), 0, kTolerance) << preset.name;
    }
  }
}

}  // namespace
}  // namespace sh::symbolic
