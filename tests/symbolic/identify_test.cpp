// numeric/identify's conventions, written from the sources' documentation, against the exact ones of this folder: the
// same presets, the same places in arrays, the same values. Neither knows the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "numeric/identify/convention.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/error_stats.hpp"
#include "symbolic/convention/convention.hpp"

namespace sh {
namespace {

namespace id = numeric::identify;

using Direction = std::array<double, 3>;

id::Convention as_numeric(const symbolic::Convention& c) {
  id::Convention result;
  result.normalization = static_cast<id::Normalization>(c.normalization);
  result.condon_shortley = c.condon_shortley;
  result.complex = c.complex;
  result.order = static_cast<id::IndexOrder>(c.order);
  result.axes = id::parse_axes(c.axes.to_string());
  return result;
}

long double evaluate(const symbolic::Polynomial& p, const Direction& d) {
  long double sum = 0;
  for (const auto& [monomial, coefficient] : p.terms()) {
    auto term = static_cast<long double>(cln::double_approx(coefficient));
    for (int i = 0; i < 3; ++i) {
      term *= std::pow(static_cast<long double>(d[i]), monomial.exponent(i));
    }
    sum += term;
  }
  return sum;
}

std::vector<Direction> directions(int count) {
  std::vector<Direction> all = {{0, 0, 1}, {0.6, 0, 0.8}, {0, -0.6, 0.8}, {-0.8, 0.6, 0}};
  for (const auto& d : numeric::random_directions(count, 3)) all.push_back({d.x, d.y, d.z});
  return all;
}

// The largest difference of the two, in units of each function's largest value.
double largest_difference(const symbolic::Convention& exact, int degree, int count, double& places) {
  const id::Convention ours = as_numeric(exact);
  double largest = 0;
  for (const Direction& d : directions(count)) {
    const auto values = id::convention_values(ours, degree, d);
    const Direction own = ours.axes.apply(d);
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const auto f = symbolic::convention_function(exact, l, m);
        const double factor = cln::double_approx(f.factor.evaluate(20));
        const std::complex<double> expected(factor * static_cast<double>(evaluate(f.re, own)),
                                            factor * static_cast<double>(evaluate(f.im, own)));
        const int place = id::storage_position(ours.order, degree, l, m);
        places += std::abs(place - symbolic::storage_position(exact.order, degree, l, m));
        const double unit = std::abs(static_cast<double>(id::relative_size(ours, l, m))) * numeric::band_maximum(l);
        largest = std::max(largest, std::abs(values[place] - expected) / unit);
      }
    }
  }
  return largest;
}

TEST(IdentifyConventions, HaveTheExactValuesInEveryCombination) {
  double places = 0;
  for (int normalization = 0; normalization < 6; ++normalization) {
    for (int order = 0; order < 4; ++order) {
      for (const bool phase : {false, true}) {
        for (const bool complex : {false, true}) {
          if (complex && normalization >= 4) continue;
          symbolic::Convention c;
          c.normalization = static_cast<symbolic::Normalization>(normalization);
          c.order = static_cast<symbolic::IndexOrder>(order);
          c.condon_shortley = phase;
          c.complex = complex;
          EXPECT_LT(largest_difference(c, 5, 2, places), 4e-15) << id::describe(as_numeric(c));
        }
      }
    }
  }
  EXPECT_EQ(places, 0);
}

TEST(IdentifyConventions, HaveTheExactAxes) {
  double places = 0;
  for (const auto& axes : symbolic::all_signed_permutations()) {
    symbolic::Convention c;
    c.axes = axes;
    EXPECT_LT(largest_difference(c, 2, 1, places), 2e-15) << axes.to_string();
    const auto ours = id::parse_axes(axes.to_string());
    EXPECT_EQ(ours.determinant(), axes.determinant());
    for (int row = 0; row < 3; ++row) {
      EXPECT_EQ(ours.axis[row], axes.axis(row));
      EXPECT_EQ(ours.sign[row], axes.sign(row));
    }
  }
}

TEST(IdentifyConventions, HaveTheExactSizesToTheHighestDegree) {
  for (int normalization = 0; normalization < 6; ++normalization) {
    symbolic::Convention exact;
    exact.normalization = static_cast<symbolic::Normalization>(normalization);
    const auto ours = as_numeric(exact);
    for (int l = 0; l <= id::kMaxDegree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const double size = cln::double_approx(
            (symbolic::convention_factor(exact, l, m) / symbolic::convention_factor({}, l, m)).evaluate(20));
        EXPECT_NEAR(static_cast<double>(id::relative_size(ours, l, m)) / size, 1, 1e-15) << l << " " << m;
      }
    }
  }
}

TEST(IdentifyConventions, ListTheExactPresets) {
  ASSERT_EQ(id::presets().size(), symbolic::presets().size());
  for (std::size_t i = 0; i < id::presets().size(); ++i) {
    const auto& ours = id::presets()[i];
    const auto& exact = symbolic::presets()[i];
    EXPECT_EQ(ours.name, exact.name);
    EXPECT_EQ(ours.convention, as_numeric(exact.convention)) << ours.name;
    EXPECT_EQ(ours.world.to_string(), exact.world.to_string()) << ours.name;
    EXPECT_EQ(static_cast<int>(ours.coefficients_hold), static_cast<int>(exact.convention.folded)) << ours.name;
    double places = 0;
    const int degree = std::min(4, symbolic::largest_degree(exact.convention));
    EXPECT_LT(largest_difference(exact.in_world(), degree, 20, places), 4e-15) << ours.name;
  }
}

}  // namespace
}  // namespace sh
