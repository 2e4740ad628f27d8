// numeric/identify's map of coefficients against the exact one of this folder: every preset, in every axes, to degree
// 10 or as far as the preset goes. Neither knows the other.
#include "numeric/identify/coefficient_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "numeric/oracle/index.hpp"
#include "symbolic/convention/convention_map.hpp"

namespace sh {
namespace {

namespace id = numeric::identify;
using Complex = std::complex<long double>;
using Entries = std::vector<std::vector<double>>;  // [row][column]

// To long double: a double and what it leaves.
long double value(const cln::cl_R& number) {
  const auto& rational = cln::the<cln::cl_RA>(number);
  const double high = cln::double_approx(rational);
  const double low = cln::double_approx(rational - cln::rational(cln::cl_DF(high)));
  return static_cast<long double>(high) + static_cast<long double>(low);
}

Complex value(const symbolic::RadicalSum& number) {
  Complex sum = 0;
  for (const auto& [radical, coefficient] : number.terms()) {
    const long double real = value(cln::realpart(coefficient));
    const long double imaginary = value(cln::imagpart(coefficient));
    const auto root = std::sqrt(static_cast<long double>(cln::double_approx(radical.first)));
    sum += Complex(real, imaginary) * root * std::pow(std::numbers::pi_v<long double>, radical.second / 2.0L);
  }
  return sum;
}

// Our map's matrix, a column at a time.
template <class Apply>
Entries entries_of(const Apply& apply, int rows, int columns) {
  Entries entries(rows, std::vector<double>(columns));
  std::vector<double> in(columns), out(rows);
  for (int column = 0; column < columns; ++column) {
    std::ranges::fill(in, 0);
    in[column] = 1;
    apply(in.data(), out.data());
    for (int row = 0; row < rows; ++row) entries[row][column] = out[row];
  }
  return entries;
}

// The same of the exact map: a complex element is a row of real parts and one of imaginary parts. Back comes the real
// function, of c = E c': Re c = Re E Re c' - Im E Im c'.
struct Expected {
  Entries to, from;
};

Expected expected(const symbolic::Convention& convention, int degree) {
  const auto map = symbolic::convention_map({}, convention, degree);
  const int parts = convention.complex ? 2 : 1;
  const int ours = numeric::coefficient_count(degree);
  const int theirs = parts * symbolic::storage_size(convention.order, degree);
  Expected all{Entries(theirs, std::vector<double>(ours)), Entries(ours, std::vector<double>(theirs))};
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const int row = parts * symbolic::storage_position(convention.order, degree, l, m);
      for (int n = -l; n <= l; ++n) {
        const int column = numeric::coefficient_index(l, n);
        const Complex to = value(map.forward[l](l + m, l + n));
        const Complex from = value(map.backward[l](l + n, l + m));
        all.to[row][column] = static_cast<double>(to.real());
        all.from[column][row] = static_cast<double>(from.real());
        if (convention.complex) {
          all.to[row + 1][column] = static_cast<double>(to.imag());
          all.from[column][row + 1] = static_cast<double>(-from.imag());
        }
      }
    }
  }
  return all;
}

// The largest relative difference of entries; infinite where one is zero and the other is not.
double largest_difference(const Entries& a, const Entries& b) {
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t row = 0; row < a.size() && largest < HUGE_VAL; ++row) {
    for (std::size_t column = 0; column < a[row].size(); ++column) {
      if (a[row][column] == b[row][column]) continue;
      largest = std::max(largest, std::abs(a[row][column] / b[row][column] - 1));
    }
  }
  return largest;
}

void expect_exact(const id::CoefficientMap& map, const symbolic::Convention& exact, double limit) {
  const auto wanted = expected(exact, map.degree());
  const auto to = entries_of([&](const double* in, double* out) { map.to(in, out); }, map.their_size(), map.our_size());
  const auto from =
      entries_of([&](const double* in, double* out) { map.from(in, out); }, map.our_size(), map.their_size());
  EXPECT_LE(largest_difference(to, wanted.to), limit) << exact.axes.to_string();
  EXPECT_LE(largest_difference(from, wanted.from), limit) << exact.axes.to_string();
}

class ExactMaps : public testing::TestWithParam<int> {};

TEST_P(ExactMaps, HaveTheEntriesOfEveryPresetInItsAxesAtEveryDegree) {
  const auto& exact = symbolic::presets()[GetParam()];
  const auto& preset = id::presets()[GetParam()];
  for (int degree = 0; degree <= std::min(10, symbolic::largest_degree(exact.convention)); ++degree) {
    expect_exact(id::CoefficientMap(preset.convention, degree, preset.coefficients_hold), exact.convention, 2.3e-16);
    expect_exact(id::CoefficientMap(preset, degree), exact.in_world(), 4e-16);
  }
}

TEST_P(ExactMaps, HaveTheEntriesOfEveryPresetInAllAxes) {
  const auto& exact = symbolic::presets()[GetParam()];
  const auto& preset = id::presets()[GetParam()];
  const int degree = std::min(10, symbolic::largest_degree(exact.convention));
  for (const auto& axes : symbolic::all_signed_permutations()) {
    auto wanted = exact.convention;
    wanted.axes = axes;
    auto ours = preset.convention;
    ours.axes = id::parse_axes(axes.to_string());
    expect_exact(id::CoefficientMap(ours, degree, preset.coefficients_hold), wanted, 4e-16);
    if (HasFailure()) return;
  }
}

TEST(ExactMaps, ReachAsFarAsTheExactOnes) {
  for (std::size_t i = 0; i < id::presets().size(); ++i) {
    const auto& preset = id::presets()[i];
    EXPECT_EQ(id::largest_mapped_degree(preset.convention, preset.coefficients_hold),
              symbolic::largest_degree(symbolic::presets()[i].convention))
        << preset.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, ExactMaps, testing::Range(0, static_cast<int>(symbolic::presets().size())),
                         [](const auto& preset) {
                           std::string name = symbolic::presets()[preset.param].name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace sh
