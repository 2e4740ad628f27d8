// Form factors as an operator: the same bits as plain sums for any number of columns, whatever memory keeps of them.
#include "prt/bake/form_factors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace sh::prt::test {
namespace {

constexpr std::size_t kVertices = 70;  // more than two tasks

// Rows of 0 to 6 entries whose weights sum to less than 1.
std::vector<FormFactorRow> random_rows() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(0.0, 1.0 / 6.0);
  std::vector<FormFactorRow> rows(kVertices);
  for (std::size_t v = 0; v < kVertices; ++v) {
    for (std::size_t i = 0; i < v % 7; ++i)
      rows[v].push_back({static_cast<std::uint32_t>(random() % kVertices), weight(random)});
  }
  return rows;
}

Panel random_panel(std::size_t columns) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Panel x(kVertices, columns);
  for (double& number : x.values) number = value(random);
  return x;
}

template <class Number>
Number sum_of(const FormFactorRow& row, const Panel& x, std::size_t column) {
  Number sum = 0;
  for (const FormFactor& factor : row) {
    const double weight = factor.weight;
    sum += Number{weight} * Number{x.row(factor.vertex)[column]};
  }
  return sum;
}

void keep_all(FormFactors& factors, const std::vector<FormFactorRow>& rows) {
  for (std::size_t v = 0; v < rows.size(); ++v) factors.keep(v, rows[v]);
}

TEST(FormFactors, AreTheSameSumsForAnyNumberOfColumns) {
  const std::vector<FormFactorRow> rows = random_rows();
  FormFactors factors(kVertices);
  keep_all(factors, rows);
  for (std::size_t columns = 8; columns <= 128; columns += 8) {
    const Panel x = random_panel(columns);
    Panel y(kVertices, columns);
    factors.apply(x, y);
    for (std::size_t v = 0; v < kVertices; ++v) {
      for (std::size_t c = 0; c < columns; ++c) ASSERT_EQ(y.row(v)[c], sum_of<double>(rows[v], x, c)) << columns;
    }
  }
}

TEST(FormFactors, ThatDoNotFitAreMadeAgainAndSmallerOnesStillFit) {
  const std::vector<FormFactorRow> rows = random_rows();
  const auto make_maker = [&] { return [&](std::size_t v) { return rows[v]; }; };
  const Panel x = random_panel(8);
  Panel all(kVertices, 8);
  FormFactors whole(kVertices);
  keep_all(whole, rows);
  whole.apply(x, all);
  for (const std::size_t entries : {0U, 3U, 20U, 100U, 1000U}) {
    FormFactors factors(kVertices, entries * sizeof(FormFactor), make_maker);
    std::size_t kept = 0;
    for (std::size_t v = 0; v < kVertices; ++v) {
      factors.keep(v, rows[v]);
      const bool fits = kept + rows[v].size() <= entries;
      ASSERT_EQ(factors.is_kept(v), fits) << v << " of " << entries;
      ASSERT_EQ(factors.row(v).size(), fits ? rows[v].size() : 0);
      kept += fits ? rows[v].size() : 0;
    }
    Panel y(kVertices, 8);
    factors.apply(x, y);
    EXPECT_EQ(y.values, all.values) << entries;
  }
  FormFactors kept(kVertices, 0);
  keep_all(kept, rows);
  EXPECT_TRUE(kept.is_kept(6)) << "without a way to make rows again all of them are kept";
}

// Two vertices that are closed in part, between sound ones.
std::vector<ClosedVertex> closed_vertices_of_a_test() { return {{10, 0.25F, {1, 2, 3, 4}}, {20, 1.0F, {4, 5}}}; }

TEST(FormFactors, OfClosedVerticesAreThoseOfTheirNeighbors) {
  const std::vector<FormFactorRow> rows = random_rows();
  FormFactors factors(kVertices);
  keep_all(factors, rows);
  const Panel x = random_panel(16);
  Panel expected(kVertices, 16);
  factors.apply(x, expected);
  const Panel own = expected;
  Fill(closed_vertices_of_a_test()).apply(expected.values.data(), expected.columns, expected.columns);
  factors.fill_with(Fill(closed_vertices_of_a_test()));
  Panel y(kVertices, 16);
  factors.apply(x, y);
  EXPECT_EQ(y.values, expected.values);
  for (std::size_t c = 0; c < y.columns; ++c) {
    const double mean = (own.row(1)[c] + own.row(2)[c] + own.row(3)[c] + own.row(4)[c]) / 4.0;
    EXPECT_NEAR(y.row(10)[c], 0.75 * own.row(10)[c] + 0.25 * mean, 1e-15);
    EXPECT_NEAR(y.row(20)[c], 1e-4 * own.row(20)[c] + (1.0 - 1e-4) * (own.row(4)[c] + own.row(5)[c]) / 2.0, 1e-15);
  }
}

TEST(FormFactors, RoundByNoMoreThanTheySay) {
  const std::vector<FormFactorRow> rows = random_rows();
  FormFactors factors(kVertices);
  keep_all(factors, rows);
  const Panel x = random_panel(128);  // numbers up to 1
  const double plain = factors.rounding();
  for (const bool filled : {false, true}) {
    if (filled) factors.fill_with(Fill({{10, 0.25F, {1, 2, 3, 4}}}));
    Panel y(kVertices, x.columns);
    factors.apply(x, y);
    long double worst = 0.0L;
    for (std::size_t c = 0; c < x.columns; ++c) {
      std::vector<long double> exact(kVertices);
      for (std::size_t v = 0; v < kVertices; ++v) exact[v] = sum_of<long double>(rows[v], x, c);
      if (filled) exact[10] = 0.75L * exact[10] + (exact[1] + exact[2] + exact[3] + exact[4]) / 16.0L;
      for (std::size_t v = 0; v < kVertices; ++v) {
        worst = std::max(worst, std::abs(exact[v] - static_cast<long double>(y.row(v)[c])));
      }
    }
    EXPECT_GT(worst, 0.0L);
    EXPECT_LE(worst, static_cast<long double>(factors.rounding()));
  }
  EXPECT_GT(plain, 0.0);
  EXPECT_GT(factors.rounding(), plain) << "filling rounds, too";
  EXPECT_LT(plain, 1e-13) << "a bound far off tells nothing";
}

// One entry: its product rounds, however short the sum.
TEST(FormFactors, OfOneVertexRoundByNoMoreThanTheySay) {
  FormFactors factors(1);
  factors.keep(0, {{0, 1.0 / 3.0}});
  Panel x(1, 1), y(1, 1);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    x.row(0)[0] = 1.0 - 0.003 * i;
    factors.apply(x, y);
    const long double exact = static_cast<long double>(1.0 / 3.0) * static_cast<long double>(x.row(0)[0]);
    worst = std::max(worst, std::abs(static_cast<double>(static_cast<long double>(y.row(0)[0]) - exact)));
  }
  EXPECT_GT(worst, 0.0);
  EXPECT_LE(worst, factors.rounding());
}

}  // namespace
}  // namespace sh::prt::test
