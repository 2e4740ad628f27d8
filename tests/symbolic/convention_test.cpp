// Conventions: axes, index orders, maps of coefficients, rotations and products, and refusals.
#include "symbolic/convention/convention.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "symbolic/convention/convention_map.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

RadicalSum number(int n) { return RadicalSum(cln::cl_RA(n)); }

// Coefficients 1, 2, 3, ... in the array order of a convention, holes zero.
std::vector<RadicalSum> counting_coefficients(IndexOrder order, int degree) {
  std::vector<RadicalSum> c(storage_size(order, degree));
  int next = 1;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) c[storage_position(order, degree, l, m)] = number(next++);
  }
  return c;
}

// c' = C c, both arrays in their own index order.
std::vector<RadicalSum> map_coefficients(const ConventionMap& map, const std::vector<RadicalSum>& coefficients) {
  std::vector<RadicalSum> result(storage_size(map.to_order, map.degree));
  for (int l = 0; l <= map.degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      RadicalSum& sum = result[storage_position(map.to_order, map.degree, l, m)];
      for (int n = -l; n <= l; ++n) {
        sum += map.forward[l](l + m, l + n) * coefficients[storage_position(map.from_order, map.degree, l, n)];
      }
    }
  }
  return result;
}

// D' = C D C^-1
std::vector<Matrix<RadicalSum>> map_rotation(const ConventionMap& map, const std::vector<Matrix<RadicalSum>>& bands) {
  std::vector<Matrix<RadicalSum>> result;
  for (std::size_t l = 0; l < bands.size(); ++l) result.push_back(map.forward[l] * bands[l] * map.backward[l]);
  return result;
}

ConventionMap inverse(const ConventionMap& map) {
  return {map.degree, map.to_order, map.from_order, map.backward, map.forward, map.folds};
}

TEST(SignedPermutation, ThereAreFortyEightHalfOfThemRotations) {
  std::set<std::string> names;
  int rotations = 0;
  for (const SignedPermutation& p : all_signed_permutations()) {
    names.insert(p.to_string());
    rotations += p.determinant() > 0 ? 1 : 0;
    EXPECT_EQ(p * p.inverse(), SignedPermutation());
    EXPECT_EQ(SignedPermutation(p.to_string()), p);
  }
  EXPECT_EQ(names.size(), 48U);
  EXPECT_EQ(rotations, 24);
}

TEST(SignedPermutation, ComposesLikeItsMatrices) {
  const SignedPermutation a("y,-x,z");
  const SignedPermutation b("-z,x,y");
  EXPECT_EQ((a * b).matrix(), a.matrix() * b.matrix());
}

TEST(SignedPermutation, RefusesWhatNamesNoAxes) {
  for (const char* text : {"", "x,y", "x,y,y", "x,y,w", "x,y,z,z", "--x,y,z"}) {
    EXPECT_THROW(SignedPermutation{text}, std::invalid_argument) << text;
  }
}

TEST(Axes, AreNoPermutationOfCoefficientsFromBandTwoOn) {
  const Matrix<Surd> band = surd_entries(2, axes_band(SignedPermutation("y,z,x"), 2));
  EXPECT_EQ(band(2, 2), Surd(cln::cl_RA(-1) / 2));  // 3x^2 - 1 holds -1/2 of 3z^2 - 1
}

TEST(IndexOrder, EveryCoefficientHasItsOwnPlace) {
  constexpr int kDegree = 4;
  for (const IndexOrder order :
       {IndexOrder::kAcn, IndexOrder::kZeroFirst, IndexOrder::kCosineSineBands, IndexOrder::kCosineSineArray}) {
    std::set<int> places;
    for (int l = 0; l <= kDegree; ++l) {
      for (int m = -l; m <= l; ++m) places.insert(storage_position(order, kDegree, l, m));
    }
    EXPECT_EQ(places.size(), 25U);
    EXPECT_GE(*places.begin(), 0);
    EXPECT_LT(*places.rbegin(), storage_size(order, kDegree));
  }
}

TEST(IndexOrder, PlacesAreTheDocumentedOnes) {
  EXPECT_EQ(storage_position(IndexOrder::kAcn, 2, 2, -2), 4);
  EXPECT_EQ(storage_position(IndexOrder::kZeroFirst, 2, 2, 1), 5);  // 0, 1, -1, 2, -2
  EXPECT_EQ(storage_position(IndexOrder::kZeroFirst, 2, 2, -1), 6);
  EXPECT_EQ(storage_position(IndexOrder::kCosineSineBands, 2, 2, 2), 6);  // 0, 1, 2, -1, -2
  EXPECT_EQ(storage_position(IndexOrder::kCosineSineBands, 2, 2, -1), 7);
  EXPECT_EQ(storage_position(IndexOrder::kCosineSineArray, 2, 1, -1), 13);  // [1][1][1] of (2, 3, 3)
}

TEST(Convention, RefusesContradictionsAndDegreesOutOfRange) {
  Convention c;
  c.complex = true;
  c.normalization = Normalization::kUnnormalized;
  EXPECT_THROW(require_convention(c, 1), std::invalid_argument);
  EXPECT_THROW(require_convention({}, -1), std::invalid_argument);
  EXPECT_THROW(require_convention({}, 21), std::invalid_argument);
  EXPECT_THROW(convention_map({}, find_preset("unity").convention, 3), std::invalid_argument);
  EXPECT_NO_THROW(convention_map({}, find_preset("unity").convention, 2));
}

TEST(ConventionMap, CoefficientsGoTheOtherWayThanBasisFunctions) {
  // Functions larger by sqrt(4 pi) need coefficients smaller by it.
  const Convention four_pi{.normalization = Normalization::kFourPi};
  const ConventionMap map = convention_map({}, four_pi, 1);
  const auto c = map_coefficients(map, counting_coefficients(IndexOrder::kAcn, 1));
  EXPECT_EQ(c[3], number(4) * RadicalSum(Surd::square_root(cln::cl_RA(1) / 4, -1)));
  EXPECT_EQ(basis_change(four_pi, 1)(0, 0), RadicalSum(Surd::square_root(4, 1)));
}

TEST(ConventionMap, EveryPresetGivesTheCoefficientsBack) {
  for (const Preset& preset : presets()) {
    for (const Convention& convention : {preset.convention, preset.in_world()}) {
      const auto there = convention_map({}, convention, 2);
      const auto back = convention_map(convention, {}, 2);
      const auto c = counting_coefficients(IndexOrder::kAcn, 2);
      EXPECT_EQ(map_coefficients(back, map_coefficients(there, c)), c) << preset.name;
    }
  }
}

TEST(ConventionMap, IndirectAndDirectMapsAgreeOnCoefficients) {
  const Convention a = find_preset("shtools").convention;
  const Convention b = find_preset("threejs").in_world();
  const auto c = counting_coefficients(a.order, 3);
  const auto direct = map_coefficients(convention_map(a, b, 3), c);
  const auto indirect = map_coefficients(convention_map({}, b, 3), map_coefficients(convention_map(a, {}, 3), c));
  EXPECT_EQ(direct, indirect);
}

TEST(ConventionMap, RefusesToComposeMapsOfDifferentDegrees) {
  EXPECT_THROW((void)compose(convention_map({}, {}, 1), convention_map({}, {}, 2)), std::invalid_argument);
}

std::vector<Matrix<RadicalSum>> rotation_of(int degree) {
  const Matrix<cln::cl_RA> r(3, 3,
                             {cln::cl_RA(2) / 3, cln::cl_RA(-1) / 3, cln::cl_RA(2) / 3,  //
                              cln::cl_RA(2) / 3, cln::cl_RA(2) / 3, cln::cl_RA(-1) / 3,  //
                              cln::cl_RA(-1) / 3, cln::cl_RA(2) / 3, cln::cl_RA(2) / 3});
  const auto bands = rotation_bands<cln::cl_RA>(degree, r, 1);
  std::vector<Matrix<RadicalSum>> result;
  for (int l = 0; l <= degree; ++l) {
    result.push_back(surd_entries(l, bands[l]).mapped([](const Surd& entry) { return RadicalSum(entry); }));
  }
  return result;
}

std::vector<RadicalSum> rotated(const std::vector<Matrix<RadicalSum>>& bands, const std::vector<RadicalSum>& c,
                                IndexOrder order) {
  std::vector<RadicalSum> result(c.size());
  const int degree = static_cast<int>(bands.size()) - 1;
  const auto place = [&](int l, int m) { return static_cast<std::size_t>(storage_position(order, degree, l, m)); };
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n) {
        result[place(l, m)] += bands[l](l + m, l + n) * c[place(l, n)];
      }
    }
  }
  return result;
}

TEST(ConventionMap, RotateThenMapEqualsMapThenRotate) {
  constexpr int kDegree = 2;
  const auto bands = rotation_of(kDegree);
  const auto c = counting_coefficients(IndexOrder::kAcn, kDegree);
  for (const Preset& preset : presets()) {
    const ConventionMap map = convention_map({}, preset.in_world(), kDegree);
    const auto first_rotated = map_coefficients(map, rotated(bands, c, IndexOrder::kAcn));
    const auto then_rotated = rotated(map_rotation(map, bands), map_coefficients(map, c), preset.convention.order);
    EXPECT_EQ(first_rotated, then_rotated) << preset.name;
  }
}

// (fg)_k = sum P_ijk f_i g_j, arrays in ACN order
std::vector<RadicalSum> product(const TripleTensor& form, const std::vector<RadicalSum>& f,
                                const std::vector<RadicalSum>& g) {
  std::vector<RadicalSum> result(f.size());
  for (const auto& [t, value] : form) {
    result[t.k] += value * f[t.i] * g[t.j];
  }
  return result;
}

TEST(ConventionMap, MultiplyThenMapEqualsMapThenMultiply) {
  constexpr int kDegree = 2;
  const TripleTensor gaunt = all_orders(gaunt_tensor(kDegree));
  const auto f = counting_coefficients(IndexOrder::kAcn, kDegree);
  std::vector<RadicalSum> g(f.rbegin(), f.rend());
  for (const char* name : {"directxmath", "threejs", "ambix", "scipy"}) {
    const ConventionMap map = convention_map({}, find_preset(name).in_world(), kDegree);
    const auto mapped_product = map_coefficients(map, product(gaunt, f, g));
    const auto product_of_mapped =
        product(map_product_form(map, gaunt), map_coefficients(map, f), map_coefficients(map, g));
    EXPECT_EQ(mapped_product, product_of_mapped) << name;
  }
}

TEST(ConventionMap, TripleIntegralScalesWithAllThreeFunctions) {
  const TripleTensor gaunt = all_orders(gaunt_tensor(1));
  const ConventionMap map = convention_map({}, {.normalization = Normalization::kFourPi}, 1);
  const RadicalSum root(Surd::square_root(4, 1));  // each function grows by sqrt(4 pi)
  for (const auto& [t, value] : map_triple_integral(map, gaunt)) EXPECT_EQ(value, root * root * root * gaunt.at(t));
  for (const auto& [t, value] : map_product_form(map, gaunt)) EXPECT_EQ(value, root * gaunt.at(t));
}

TEST(ConventionMap, GauntTensorGoesThereAndBack) {
  const TripleTensor gaunt = all_orders(gaunt_tensor(2));
  const ConventionMap map = convention_map({}, find_preset("scipy").in_world(), 2);
  EXPECT_EQ(map_triple_integral(inverse(map), map_triple_integral(map, gaunt)), gaunt);
  EXPECT_EQ(map_product_form(inverse(map), map_product_form(map, gaunt)), gaunt);
}

TEST(ConventionMap, RefusesProductsWithAFoldedCosineAndEntriesBeyondItsDegree) {
  const TripleTensor gaunt = all_orders(gaunt_tensor(2));
  EXPECT_THROW((void)map_product_form(convention_map({}, find_preset("unity").convention, 2), gaunt),
               std::invalid_argument);
  EXPECT_THROW((void)map_triple_integral(convention_map({}, {}, 1), gaunt), std::invalid_argument);
}

}  // namespace
}  // namespace sh::symbolic
