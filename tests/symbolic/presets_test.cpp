// Each preset's first two bands (three where the polynomials are documented to there) are the functions that its source
// evaluates, in the source's own coordinates. The constants are those the sources print, to their digits.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "symbolic/convention/convention.hpp"
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/typeset/typeset_families.hpp"
#include "symbolic/zonal/zonal.hpp"
#include "tests/message_of.hpp"

namespace sh::symbolic {
namespace {

using Direction = std::array<double, 3>;
using Values = std::vector<std::complex<double>>;

// An exact unit vector without symmetry.
const Direction& direction() {
  static const Direction d{2.0 / 7, -3.0 / 7, 6.0 / 7};
  return d;
}

Direction turned(const SignedPermutation& axes, const Direction& d) {
  return {axes.sign(0) * d[axes.axis(0)], axes.sign(1) * d[axes.axis(1)], axes.sign(2) * d[axes.axis(2)]};
}

double evaluate(const Polynomial& p, const Direction& d) {
  double sum = 0;
  for (const auto& [monomial, coefficient] : p.terms()) {
    double term = cln::double_approx(coefficient);
    for (int i = 0; i < 3; ++i) term *= std::pow(d[i], monomial.exponent(i));
    sum += term;
  }
  return sum;
}

// The functions in array order of the preset, as it evaluates them.
Values functions(const Convention& c, int degree) {
  Values values(storage_size(c.order, degree));
  const Direction own = turned(c.axes, direction());
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const ConventionFunction f = convention_function(c, l, m);
      const double factor = cln::double_approx(f.factor.evaluate(20));
      values[storage_position(c.order, degree, l, m)] = {factor * evaluate(f.re, own), factor * evaluate(f.im, own)};
    }
  }
  return values;
}

void expect_functions(const char* preset, int degree, const Values& expected, double tolerance) {
  const Values actual = functions(find_preset(preset).convention, degree);
  ASSERT_EQ(actual.size(), expected.size()) << preset;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i].real(), expected[i].real(), tolerance) << preset << " function " << i;
    EXPECT_NEAR(actual[i].imag(), expected[i].imag(), tolerance) << preset << " function " << i;
  }
}

const double x = direction()[0];
const double y = direction()[1];
const double z = direction()[2];

Values with_phase(double c0, double c1, double c2, double c20, double c22) {
  return {
      c0, -c1 * y, c1 * z, -c1 * x, c2 * x * y, -c2 * y * z, c20 * (3 * z * z - 1), -c2 * x * z, c22 * (x * x - y * y)};
}

TEST(Presets, DirectXMathHasTheMinusSignOnOddOrders) {
  expect_functions("directxmath", 2,
                   with_phase(0.282094791773878140, 0.488602511902919920, 1.092548430592079200, 0.315391565252520050,
                              0.546274215296039590),
                   2e-15);
}

TEST(Presets, GaussianSplattingHasTheMinusSignOnOddOrders) {
  expect_functions(
      "gaussian-splatting", 2,
      with_phase(0.28209479177387814, 0.4886025119029199, 1.0925484305920792, 0.31539156525252005, 0.5462742152960396),
      2e-15);
}

TEST(Presets, UnrealHasTheMinusSignOnOddOrders) {
  expect_functions("unreal", 2, with_phase(0.282095, 0.488603, 1.092548, 0.315392, 0.546274), 1e-6);
}

TEST(Presets, ThreeJsHasNoSigns) {
  expect_functions("threejs", 2,
                   {0.282095, 0.488603 * y, 0.488603 * z, 0.488603 * x, 1.092548 * x * y, 1.092548 * y * z,
                    0.315392 * (3 * z * z - 1), 1.092548 * x * z, 0.546274 * (x * x - y * y)},
                   1e-6);
}

TEST(Presets, UnityAndFilamentSumPlainPolynomials) {
  const Values polynomials{1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y};
  expect_functions("unity", 2, polynomials, 1e-15);
  expect_functions("filament", 2, polynomials, 1e-15);
}

TEST(Presets, UnityFoldsItsPrintedConstantsIntoOrthonormalCoefficients) {
  // kNormalizationConstants, which multiply coefficients with the Condon-Shortley phase.
  const std::array<double, 9> printed{0.28209479177387814347,  -0.32573500793527994772, 0.32573500793527994772,
                                      -0.32573500793527994772, 0.27313710764801976764,  -0.27313710764801976764,
                                      0.07884789131313000151,  -0.27313710764801976764, 0.13656855382400988382};
  const ConventionMap map = convention_map(find_preset("directxmath").convention, find_preset("unity").convention, 2);
  for (int i = 0; i < 9; ++i) {
    const auto [l, m] = degree_order(i);
    const Surd factor = map.forward[l](l + m, l + m).surd();
    EXPECT_NEAR(cln::double_approx(factor.evaluate(20)), printed[i], 1e-16) << i;
  }
}

TEST(Presets, AmbixHasTheConstantOfItsPaper) {
  const double w = 1 / std::sqrt(4 * M_PI);
  const double r3 = std::sqrt(3.0);
  expect_functions("ambix", 2,
                   {w, w * y, w * z, w * x, w * r3 * x * y, w * r3 * y * z, w * (3 * z * z - 1) / 2, w * r3 * x * z,
                    w * r3 / 2 * (x * x - y * y)},
                   1e-15);
}

TEST(Presets, AmbixStreamsHaveASignalInW) {
  const double r3 = std::sqrt(3.0);
  expect_functions("ambix-w1", 2,
                   {1, y, z, x, r3 * x * y, r3 * y * z, (3 * z * z - 1) / 2, r3 * x * z, r3 / 2 * (x * x - y * y)},
                   1e-15);
}

TEST(Presets, FuMaHasTheWeightsOfItsTable) {
  const double l = std::sqrt(135.0 / 256);
  const double n = std::sqrt(27.0 / 4);
  expect_functions("fuma", 3,
                   {std::sqrt(0.5), x, y, z, (3 * z * z - 1) / 2, 2 * x * z, 2 * y * z, x * x - y * y, 2 * x * y,
                    z * (5 * z * z - 3) / 2, l * x * (5 * z * z - 1), l * y * (5 * z * z - 1), n * z * (x * x - y * y),
                    2 * n * x * y * z, x * (x * x - 3 * y * y), y * (3 * x * x - y * y)},
                   2e-15);
  EXPECT_THROW(require_convention(find_preset("fuma").convention, 4), std::invalid_argument);
}

TEST(Presets, E3nnHasPolarYAndThreeNormalizations) {
  const double r15 = std::sqrt(15.0);
  const Values component{1,
                         std::sqrt(3.0) * x,
                         std::sqrt(3.0) * y,
                         std::sqrt(3.0) * z,
                         r15 * x * z,
                         r15 * x * y,
                         std::sqrt(5.0) * (y * y - (x * x + z * z) / 2),
                         r15 * y * z,
                         r15 / 2 * (z * z - x * x)};
  expect_functions("e3nn-component", 2, component, 2e-15);
  Values integral;
  Values norm;
  for (std::size_t i = 0; i < component.size(); ++i) {
    integral.push_back(component[i] / std::sqrt(4 * M_PI));
    norm.push_back(component[i] / std::sqrt(i == 0 ? 1.0 : i < 4 ? 3.0 : 5.0));
  }
  expect_functions("e3nn-integral", 2, integral, 2e-15);
  expect_functions("e3nn-norm", 2, norm, 2e-15);
}

TEST(Presets, ScipyIsComplexWithThePhase) {
  const std::complex<double> plus{x, y};  // sin(theta) exp(i phi)
  const double c1 = std::sqrt(3 / (8 * M_PI));
  const double c2 = std::sqrt(15 / (8 * M_PI));
  const double c22 = std::sqrt(15 / (32 * M_PI));
  expect_functions("scipy", 2,
                   {1 / std::sqrt(4 * M_PI), c1 * std::conj(plus), std::sqrt(3 / (4 * M_PI)) * z, -c1 * plus,
                    c22 * std::conj(plus * plus), c2 * z * std::conj(plus),
                    std::sqrt(5 / (16 * M_PI)) * (3 * z * z - 1), -c2 * z * plus, c22 * plus * plus},
                   2e-15);
}

TEST(Presets, ShtoolsKeepsCosineAndSineInTwoTriangles) {
  const double r3 = std::sqrt(3.0);
  expect_functions("shtools", 1, {1, 0, r3 * z, r3 * x, 0, 0, 0, r3 * y}, 1e-15);
}

TEST(Presets, OursIsTheDefault) {
  EXPECT_EQ(find_preset("shforge").convention, Convention{});
  EXPECT_EQ(find_preset("shforge").in_world(), Convention{});
}

TEST(Presets, StateTheirSourceAndWhatTheyCover) {
  for (const Preset& preset : presets()) {
    EXPECT_FALSE(preset.source.empty()) << preset.name;
    EXPECT_FALSE(preset.covers.empty()) << preset.name;
    const bool polar_z = preset.name.find("e3nn") == std::string::npos;
    EXPECT_EQ(preset.convention.axes, SignedPermutation(polar_z ? "x,y,z" : "z,x,y")) << preset.name;
  }
}

TEST(Presets, WorldAxesHaveTheHandednessOfTheirEngine) {
  EXPECT_EQ(find_preset("threejs").world.determinant(), 1);
  EXPECT_EQ(find_preset("filament").world.determinant(), 1);
  EXPECT_EQ(find_preset("ambix").world.determinant(), 1);
  EXPECT_EQ(find_preset("unity").world.determinant(), -1);
  EXPECT_EQ(find_preset("unreal").world.determinant(), -1);
}

template <class Items>
void expect_list(const std::string& message, const Items& items) {
  EXPECT_NE(message.find("'nothing'"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const auto& item : items) EXPECT_NE(message.find(item.name), std::string::npos) << message;
}

TEST(Names, AnUnknownOneIsRefusedInOneLineWithTheKnownOnes) {
  expect_list(sh::test::message_of([] { find_preset("nothing"); }), presets());
  expect_list(sh::test::message_of([] { zonal_family("nothing"); }), zonal_families());
  expect_list(sh::test::message_of([] { typeset_table("nothing", 2, presets().front()); }), typeset_families());
}

}  // namespace
}  // namespace sh::symbolic
