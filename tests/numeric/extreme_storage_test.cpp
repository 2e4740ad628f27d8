// Coefficients stored as double, float and IEEE half (binary16): the effect on a function's values and on its
// rotation, by search for the worst coefficients, against the bounds of Cauchy's inequality. With u the unit roundoff
// (2^-53, 2^-24, 2^-11) a stored coefficient differs from c_i by d_i, |d_i| <= u |c_i|, so
//     |sum d_i Y_i| <= u |c| sqrt(sum Y_i^2) = u |c| (L+1) / sqrt(4 pi),    |D d| = |d| <= u |c|.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "generated/cpp/evaluate_l4.hpp"
#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/worst_input.hpp"
#include "tests/numeric/extreme.hpp"
#include "tests/numeric/extreme_kernels.hpp"

namespace sh::numeric {
namespace {

using Eigen::half;

template <class Stored>
long double stored(long double value) {
  if constexpr (std::is_same_v<Stored, half>) {
    return static_cast<long double>(static_cast<float>(half(static_cast<float>(value))));
  } else {
    return static_cast<long double>(static_cast<Stored>(value));
  }
}

// A coefficient with all digits of long double from one in double.
long double full(double c) { return static_cast<long double>(c) * std::numbers::pi_v<long double> / 3; }

struct Storage {
  long double unit;  // u
  long double (*store)(long double);
};

// in: coefficients, then a direction of length 1. |sum d_i Y_i| over its bound.
double value_error(int degree, const Storage& storage, const double* in) {
  const auto count = static_cast<std::size_t>(coefficient_count(degree));
  std::vector<long double> y(count);
  basis<long double>(degree, in[count], in[count + 1], in[count + 2], y.data());
  long double sum = 0, square = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const long double c = full(in[i]);
    sum += (storage.store(c) - c) * y[i];
    square += c * c;
  }
  const long double bound =
      storage.unit * std::sqrt(square) * (degree + 1) / std::sqrt(4 * std::numbers::pi_v<long double>);
  return static_cast<double>(std::abs(sum) / bound);
}

// in: coefficients. |d| over its bound; a rotation keeps it.
double length_error(int degree, const Storage& storage, const double* in) {
  long double sum = 0, square = 0;
  for (int i = 0; i < coefficient_count(degree); ++i) {
    const long double c = full(in[i]);
    const long double d = storage.store(c) - c;
    sum += d * d;
    square += c * c;
  }
  return static_cast<double>(std::sqrt(sum / square) / storage.unit);
}

std::vector<std::vector<double>> starts(int degree) {
  std::vector<std::vector<double>> all;
  for (const auto& input : combined(coefficient_inputs(degree, 20, 5), direction_inputs(20)))
    all.push_back(input.values);
  return all;
}

void report_storage(const std::string& name, const Storage& storage) {
  constexpr SearchEffort kEffort{2, 2000, 3};
  for (const int degree : {0, 4, 10}) {
    const auto count = static_cast<std::size_t>(coefficient_count(degree));
    SearchProblem<double> problem;
    problem.to_domain = [count](double* in) {
      // Within three binary orders, so that half storage has all its digits.
      for (std::size_t i = 0; i < count; ++i) in[i] = std::copysign(std::clamp(std::abs(in[i]), 0.125, 1.0), in[i]);
      const double r = std::hypot(in[count], in[count + 1], in[count + 2]);
      for (std::size_t i = count; i < count + 3; ++i) in[i] /= r;
      return r > 0;
    };
    auto points = starts(degree);
    for (auto& point : points) problem.to_domain(point.data());
    problem.error = [&](const double* in) { return value_error(degree, storage, in); };
    const auto value = worst_inputs(problem, points, kEffort)[0];
    const std::vector<double> d(value.input.end() - 3, value.input.end());
    test::report_extreme(fmt::format("stored as {}: a value, l={}, part of u |c| (L+1)/sqrt(4 pi)", name, degree),
                         value.error, 1, "at " + test::printed(d));
    problem.error = [&](const double* in) { return length_error(degree, storage, in); };
    const auto turned = worst_inputs(problem, points, kEffort)[0];
    test::report_extreme(fmt::format("stored as {}: rotated, l={}, part of u |c|", name, degree), turned.error, 1,
                         fmt::format("c[0] = {:.17g} pi/3", turned.input[0]));
  }
}

TEST(ExtremeStorage, OfCoefficientsKeepsTheBoundsOfItsDigits) {
  report_storage("double", {0x1p-53L, stored<double>});
  report_storage("float", {0x1p-24L, stored<float>});
  report_storage("half", {0x1p-11L, stored<half>});
}

// Half ends at 65504; from 65520 on numbers become infinite, and so must results of them.
TEST(ExtremeStorage, OfHalvesOverflowsToInfinityAndNotToANumber) {
  int silent = 0;
  std::string first = "none";
  for (const float big : {65520.0F, 1e5F, 1e30F}) {
    for (std::size_t i = 0; i < 25; ++i) {
      std::array<float, 25> c{};
      c[i] = static_cast<float>(half(big));
      const float value = evaluate_l4(c.data(), 0.48F, 0.6F, 0.64F);
      if (std::isfinite(value) && silent++ == 0) first = fmt::format("c[{}] = {}: {}", i, big, value);
    }
  }
  test::report_extreme("stored as half: coefficients from 65520, finite values of evaluate_l4", silent, 0, first);
  EXPECT_EQ(static_cast<float>(half(65519.99F)), 65504.0F);
}

// Below 2^-14 a half has fewer digits: the error of a coefficient stays at 2^-25, whatever its size.
TEST(ExtremeStorage, OfSmallCoefficientsAsHalvesLosesDigits) {
  test::Worst worst;
  for (const auto& input : vector_inputs(1000, 4, 9)) {
    for (const double c : input.values) {
      const double small = c * 1e-4;
      const auto error = static_cast<double>(std::abs(stored<half>(small) - static_cast<long double>(small)));
      worst.keep(error * 0x1p25, "c = {:.17g}", small);
    }
  }
  worst.report("stored as half: coefficients below 2^-14, absolute error / 2^-25", 1);
}

}  // namespace
}  // namespace sh::numeric
