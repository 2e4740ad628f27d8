// The committed kernels for products: against quadrature with the oracle's basis, in place, as constants.
#include "generated/cpp/product.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "generated/cpp/product_full.hpp"
#include "generated/cpp/product_zonal.hpp"
#include "generated/cpp/square.hpp"
#include "generated/cpp/triple.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "tests/generated/kernel_support.hpp"

namespace sh {
namespace {

using test::coefficient_count;
using test::expect_fills;
using test::expect_near;
using test::for_every_degree;
using test::unit_vector;

using Coefficients = std::vector<double>;

double dot(const Coefficients& a, const Coefficients& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// The coefficients of a pointwise product by integration over the sphere; exact up to rounding.
Coefficients integrated_product(const Coefficients& a, const Coefficients& b, int degree) {
  Coefficients result(coefficient_count(degree));
  for (const auto& node : numeric::sphere_rule<double>(3 * degree)) {
    Coefficients y(coefficient_count(degree));
    numeric::basis(degree, node.x, node.y, node.z, y.data());
    const double value = node.weight * dot(a, y) * dot(b, y);
    for (std::size_t i = 0; i < y.size(); ++i) result[i] += value * y[i];
  }
  return result;
}

Coefficients with_zeros(const Coefficients& zonal) {
  Coefficients c(zonal.size() * zonal.size());
  for (std::size_t l = 0; l < zonal.size(); ++l) c[l * (l + 1)] = zonal[l];
  return c;
}

TEST(GeneratedProducts, AgreeWithIntegrationOverTheSphere) {
  for_every_degree([]<int kDegree>() {
    const auto a = unit_vector(coefficient_count(kDegree), 1);
    const auto b = unit_vector(coefficient_count(kDegree), 2);
    const auto zonal = unit_vector(kDegree + 1, 3);
    Coefficients out(coefficient_count(kDegree));
    product<kDegree>(a.data(), b.data(), out.data());
    expect_near(out, integrated_product(a, b, kDegree), 2e-15);
    EXPECT_NEAR(triple<kDegree>(a.data(), b.data(), b.data()), dot(out, b), 1e-15);
    square<kDegree>(a.data(), out.data());
    expect_near(out, integrated_product(a, a, kDegree), 2e-15);
    product_zonal<kDegree>(a.data(), zonal.data(), out.data());
    expect_near(out, integrated_product(a, with_zeros(zonal), kDegree), 2e-15);
  });
}

// The function's value at a direction.
double value_at(const Coefficients& c, int degree, double x, double y, double z) {
  Coefficients values(c.size());
  numeric::basis(degree, x, y, z, values.data());
  return dot(c, values);
}

TEST(GeneratedProducts, CompleteOnesAreTheProductAtEveryPoint) {
  const auto test = []<int kDegree>() {
    const auto a = unit_vector(coefficient_count(kDegree), 11);
    const auto b = unit_vector(coefficient_count(kDegree), 12);
    Coefficients out(coefficient_count(2 * kDegree) + 1, std::numeric_limits<double>::quiet_NaN());
    product_full<kDegree>(a.data(), b.data(), out.data());
    EXPECT_TRUE(std::isnan(out.back()));
    out.pop_back();
    for (const auto& node : numeric::sphere_rule<double>(4)) {
      EXPECT_NEAR(value_at(out, 2 * kDegree, node.x, node.y, node.z),
                  value_at(a, kDegree, node.x, node.y, node.z) * value_at(b, kDegree, node.x, node.y, node.z), 1e-13);
    }
  };
  test.operator()<0>();
  test.operator()<1>();
  test.operator()<2>();
  test.operator()<3>();
  test.operator()<4>();
}

TEST(GeneratedProducts, InFloatStayWithinFourEpsOfTheLengths) {
  for_every_degree([]<int kDegree>() {
    constexpr double kLimit = 4 * std::numeric_limits<float>::epsilon();
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto a = unit_vector(coefficient_count(kDegree), 2 * seed);
      // Sharp peaks add up all coefficients: b is a again in every other pair.
      const auto b = seed % 2 == 0 ? a : unit_vector(coefficient_count(kDegree), 2 * seed + 1);
      const std::vector<float> a_float(a.begin(), a.end());
      const std::vector<float> b_float(b.begin(), b.end());
      const Coefficients a_rounded(a_float.begin(), a_float.end());
      const Coefficients b_rounded(b_float.begin(), b_float.end());
      Coefficients wanted(coefficient_count(kDegree));
      std::vector<float> out(coefficient_count(kDegree));
      product<kDegree>(a_rounded.data(), b_rounded.data(), wanted.data());
      product<kDegree>(a_float.data(), b_float.data(), out.data());
      expect_near(out, wanted, kLimit);
    }
  });
}

TEST(GeneratedProducts, DoNotDependOnTheOrderOfTheFactors) {
  for_every_degree([]<int kDegree>() {
    const auto a = unit_vector(coefficient_count(kDegree), 4);
    const auto b = unit_vector(coefficient_count(kDegree), 5);
    Coefficients ab(coefficient_count(kDegree));
    Coefficients ba(coefficient_count(kDegree));
    product<kDegree>(a.data(), b.data(), ab.data());
    product<kDegree>(b.data(), a.data(), ba.data());
    expect_near(ab, ba, 4e-16);
  });
}

TEST(GeneratedProducts, WorkInPlace) {
  for_every_degree([]<int kDegree>() {
    const auto a = unit_vector(coefficient_count(kDegree), 6);
    const auto b = unit_vector(coefficient_count(kDegree), 7);
    const auto zonal = unit_vector(kDegree + 1, 8);
    Coefficients wanted(coefficient_count(kDegree));
    product<kDegree>(a.data(), b.data(), wanted.data());
    Coefficients over_a = a;
    product<kDegree>(over_a.data(), b.data(), over_a.data());
    EXPECT_EQ(over_a, wanted);
    Coefficients over_b = b;
    product<kDegree>(a.data(), over_b.data(), over_b.data());
    EXPECT_EQ(over_b, wanted);
    square<kDegree>(a.data(), wanted.data());
    over_a = a;
    square<kDegree>(over_a.data(), over_a.data());
    EXPECT_EQ(over_a, wanted);
    Coefficients twice = a;
    product<kDegree>(twice.data(), twice.data(), twice.data());
    expect_near(twice, wanted, 4e-16);
    product_zonal<kDegree>(a.data(), zonal.data(), wanted.data());
    over_a = a;
    product_zonal<kDegree>(over_a.data(), zonal.data(), over_a.data());
    EXPECT_EQ(over_a, wanted);
  });
}

TEST(GeneratedProducts, WithAConstantScaleTheOtherFactor) {
  // 1 = sqrt(4 pi) Y_00.
  for_every_degree([]<int kDegree>() {
    Coefficients one(coefficient_count(kDegree));
    one[0] = std::sqrt(4 * M_PI);
    const auto b = unit_vector(coefficient_count(kDegree), 9);
    Coefficients out(coefficient_count(kDegree));
    product<kDegree>(one.data(), b.data(), out.data());
    expect_near(out, b, 4e-15);
    product<kDegree>(Coefficients(coefficient_count(kDegree)).data(), b.data(), out.data());
    expect_near(out, Coefficients(coefficient_count(kDegree)), 0);
  });
}

TEST(GeneratedProducts, AreConstantExpressions) {
  constexpr auto kSquare = [] {
    const std::array<double, 9> z{0, 0, 1};
    std::array<double, 9> out{};
    product<2>(z.data(), z.data(), out.data());
    return out;
  }();
  static_assert(kSquare[0] > 0.28 && kSquare[6] > 0.25 && kSquare[1] == 0);
  constexpr auto kIntegral = [] {
    const std::array<double, 4> y{1, 0, 0, 0};
    return triple<1>(y.data(), y.data(), y.data());
  }();
  static_assert(kIntegral > 0.2820947917738 && kIntegral < 0.2820947917739);
}

TEST(GeneratedProducts, WriteExactlyTheirOwnElements) {
  for_every_degree([]<int kDegree>() {
    const auto a = unit_vector(coefficient_count(kDegree), 10);
    expect_fills(a.size(), [&](double* out) { product<kDegree>(a.data(), a.data(), out); });
  });
}

}  // namespace
}  // namespace sh
