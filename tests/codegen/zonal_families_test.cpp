// Caps, zonal functions, irradiance and windows: their cost, their errors, and the inputs at which they must not lose
// digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "codegen/ir/evaluate.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/zonal/zonal.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::cost_of;
using test::fastest;
using test::kernel_of;

TEST(ZonalFamilies, TurningCostsFewerMultiplicationsThanTheBasisAndAScaling) {
  for (int degree = 2; degree <= 10; ++degree) {
    // The constants sqrt(4 pi/(2l+1)) once for each band, and a multiplication for each coefficient.
    const int coefficients = numeric::coefficient_count(degree);
    const int scaling = degree + 1 + coefficients;
    int basis = std::numeric_limits<int>::max();
    for (const Recipe& recipe : recipes_for(find_family("basis"), degree)) {
      basis = std::min(basis, cost_of("basis", recipe.name, degree).mul);
    }
    EXPECT_LT(cost_of("zonal", "columns", degree).mul, basis + scaling) << degree;
    // And an addition for each coefficient, and the cap itself.
    const Cost light = cost_of("add_cap", "columns", degree);
    EXPECT_LT(light.mul, basis + scaling + cost_of("cap", "horner", degree).mul) << degree;
  }
}

TEST(ZonalFamilies, ErrorsStayWithinTheirLimits) {
  struct Limit {
    std::string family;
    double speed, accuracy;  // in the units of the family, of every degree
  };
  // Measured: cap 10.2 / 4.3, zonal 13.2 / 7.8, add_cap 13.3, add_cap_rgb 9.9, windows 6.4, 5.1, 8.7, 12.9, 13.7, 0.8.
  const std::vector<Limit> limits{{"cap", 15, 6},
                                  {"zonal", 20, 10},
                                  {"add_cap", 20, 20},
                                  {"add_cap_rgb", 20, 20},
                                  {"irradiance", 1.5, 1.5},
                                  {"irradiance_matrix", 1, 1},
                                  {"irradiance_evaluate", 3, 3},
                                  {"irradiance_zh3", 9, 9},
                                  {"irradiance_zh3_rgb", 9, 9},
                                  {"lightmap", 1.5, 1.5},
                                  {"lightmap_project", 1.5, 1.5},
                                  {"lightmap_evaluate", 2, 2},
                                  {"window_hann", 10, 7},
                                  {"window_lanczos", 8, 8},
                                  {"window_lanczos2", 14, 14},
                                  {"window_lanczos4", 20, 20},
                                  {"window_gaussian", 20, 20},
                                  {"window_laplacian", 1.5, 1.5}};
  for (const Limit& limit : limits) {
    const Family& family = find_family(limit.family);
    for (const int degree : {2, 4, 10}) {
      if (degree > family.largest_written || recipes_for(family, degree).empty()) continue;
      const FinishedKernel fast = fastest(limit.family, degree);
      const FinishedKernel accurate = preferred_kernel(family, degree, Prefer::kAccuracy);
      EXPECT_LT(fast.in_float.rounding.eps, limit.speed) << limit.family << " " << degree;
      EXPECT_LT(fast.in_double.rounding.eps, limit.speed * 1.3) << limit.family << " " << degree;
      EXPECT_LT(accurate.in_float.rounding.eps, limit.accuracy) << limit.family << " " << degree;
    }
  }
}

// The largest relative error of z_0 .. z_degree, in units of epsilon; exact coefficients from symbolic/.
template <class T>
double relative_error(const Kernel& kernel, T u) {
  const auto terms = symbolic::zonal_coefficients(symbolic::zonal_family("cap-small"), kernel.degree);
  const std::vector<cln::cl_RA> exact_u{cln::rational(cln::cl_float(static_cast<double>(u)))};
  const std::vector<T> z = Evaluator<T>(kernel)(std::vector<T>{u});
  double worst = 0;
  for (std::size_t l = 0; l < z.size(); ++l) {
    const cln::cl_F exact = terms[l].at(exact_u).evaluate(40);
    const double relative =
        cln::double_approx(cln::cl_float(z[l] == 0 ? 0 : 1, cln::float_format(40)) *
                               cln::cl_float(cln::rational(cln::cl_float(static_cast<double>(z[l])))) / exact -
                           1);
    worst = std::max(worst, std::abs(relative) / static_cast<double>(std::numeric_limits<T>::epsilon()));
  }
  return worst;
}

TEST(Cap, TinyCapsKeepAllTheirDigits) {
  const Family& cap = find_family("cap");
  for (const int degree : {2, 6, 7, 10}) {
    for (const Recipe& recipe : recipes_for(cap, degree)) {
      const Kernel kernel = kernel_of("cap", recipe.name, degree);
      // Measured 3.6 and 10.0; the recurrence multiplies the rounding error of 1 - u by up to 27 at degree 10.
      const double limit = recipe.name == "recurrence" ? 13 : 5;
      for (const double u : {1e-3, 1e-7, 1e-12, 1e-30, 1e-37}) {
        EXPECT_LT(relative_error(kernel, static_cast<float>(u)), limit) << recipe.name << " " << degree << " " << u;
        EXPECT_LT(relative_error(kernel, u), limit) << recipe.name << " " << degree << " " << u;
      }
      EXPECT_LT(relative_error(kernel, 1e-300), limit);
    }
  }
}

TEST(Cap, SubnormalSizesGiveTheNearestSubnormalsWithinAFewUnits) {
  const Family& cap = find_family("cap");
  for (const int degree : {4, 10}) {
    for (const Recipe& recipe : recipes_for(cap, degree)) {
      const Kernel kernel = kernel_of("cap", recipe.name, degree);
      const double unit = std::numeric_limits<double>::denorm_min();
      const std::vector<double> z = Evaluator<double>(kernel)(std::vector<double>{1000 * unit});
      for (std::size_t l = 0; l < z.size(); ++l) {
        // z_l = sqrt((2l+1) pi) u for a cap so small that every Y_l0 is constant in it.
        const double expected = std::sqrt((2 * static_cast<double>(l) + 1) * M_PI) * 1000;
        EXPECT_NEAR(z[l] / unit, expected, 16) << recipe.name << " " << l;
      }
    }
  }
}

TEST(Cap, EmptyAndWholeSphereAreExact) {
  const Family& cap = find_family("cap");
  for (const int degree : {3, 10}) {
    for (const Recipe& recipe : recipes_for(cap, degree)) {
      const Kernel kernel = kernel_of("cap", recipe.name, degree);
      const std::vector<float> none = Evaluator<float>(kernel)(std::vector<float>{0});
      const std::vector<float> sphere = Evaluator<float>(kernel)(std::vector<float>{2});
      EXPECT_TRUE(std::all_of(none.begin(), none.end(), [](float z) { return z == 0; }));
      EXPECT_FLOAT_EQ(sphere[0], static_cast<float>(2 * std::sqrt(M_PI)));
      EXPECT_TRUE(std::all_of(sphere.begin() + 1, sphere.end(), [](float z) { return z == 0; }));
    }
  }
}

TEST(Irradiance, OddDegreesAboveOneBecomeZeroWhateverStandsThere) {
  const Kernel kernel = fastest("irradiance", 5).kernel;
  std::vector<float> c(36, std::numeric_limits<float>::infinity());
  const std::vector<float> e = Evaluator<float>(kernel)(c);
  for (const int l : {3, 5}) {
    for (int i = l * l; i < numeric::coefficient_count(l); ++i) EXPECT_EQ(e[i], 0.0F);
  }
}

TEST(Catalogue, RefusesADegreeThatAFamilyLeavesOutAndListsTheOthers) {
  EXPECT_THROW(preferred_kernel(find_family("window_hann"), 0, Prefer::kSpeed), std::invalid_argument);
  try {
    preferred_kernel(find_family("lightmap"), 0, Prefer::kAccuracy);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "lightmap: expected a degree among 1, got 0");
  }
}

}  // namespace
}  // namespace sh::codegen
