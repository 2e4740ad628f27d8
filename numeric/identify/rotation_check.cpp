// See rotation_check.hpp.
#include "numeric/identify/rotation_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<long double>;
using Errors = std::vector<std::vector<double>>;  // [case][band]

double error_of(const Band& own, const Band& expected) {
  return static_cast<double>((own - expected).cwiseAbs().maxCoeff());
}

// The largest entry of D D* - 1.
double defect_of(const Band& d) { return error_of(d * d.adjoint(), Band::Identity(d.rows(), d.cols())); }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The true errors; the defects go into `result`.
Errors measure(const RotationReading& reading, RotationCheck& result) {
  const int degree = result.cases.degree;
  result.bands.resize(degree + 1);
  Errors errors;
  for (std::size_t i = 0; i < result.cases.cases.size(); ++i) {
    const RotationCase& one = result.cases.cases[i];
    const auto expected = expected_bands(reading, one, degree);
    errors.emplace_back();
    for (int l = 0; l <= degree; ++l) {
      const Band own = own_band(reading, one, l);
      BandErrors& band = result.bands[l];
      band.degree = l;
      band.defect = std::max(band.defect, defect_of(own));
      errors.back().push_back(error_of(own, expected[l]));
      if (errors.back().back() <= band.error && i > 0) continue;
      band.error = errors.back().back();
      band.worst = i;
    }
    result.between_bands = std::max(result.between_bands, one.between_bands);
  }
  return errors;
}

void set_limits(const Errors& errors, double tolerance, RotationCheck& result) {
  constexpr double kLooksDouble = 1e-11;
  constexpr double kEpsilons = 16;
  std::vector<double> largest;
  for (const auto& one : errors) largest.push_back(*std::max_element(one.begin(), one.end()));
  result.epsilon = median(largest) < kLooksDouble ? 0x1p-52 : 0x1p-23;
  for (auto& band : result.bands)
    band.limit = tolerance > 0 ? tolerance : kEpsilons * (band.degree + 1) * result.epsilon;
}

double polar_tilt(const RotationCheck& result, std::size_t i) {
  const double tilt = angles_of(result.cases.cases[i], result.readings.front().convention.axes).tilt;
  return std::min(tilt, std::numbers::pi - tilt);
}

void sort_by_tilt(const Errors& errors, RotationCheck& result) {
  constexpr int kDecades = 9;
  for (int decade = 0; decade < kDecades; ++decade) {
    TiltErrors tilts;
    tilts.to = decade == 0 ? std::numbers::pi / 2 : std::pow(10.0, -decade);
    tilts.from = decade == kDecades - 1 ? 0 : std::pow(10.0, -decade - 1);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double tilt = polar_tilt(result, i);
      if (tilt < tilts.from || (tilt >= tilts.to && decade > 0)) continue;
      ++tilts.cases;
      tilts.error = std::max(tilts.error, *std::max_element(errors[i].begin(), errors[i].end()));
    }
    if (tilts.cases > 0) result.tilts.push_back(tilts);
  }
}

// The common property of the failing cases, which the others do not have.
std::string diagnose(const RotationCheck& result) {
  constexpr double kSmall = 0.1;
  const auto all_fail_where_small = [&](const auto& angle) {
    std::size_t small = 0;
    for (std::size_t i = 0; i < result.cases.cases.size(); ++i) small += angle(i) < kSmall ? 1 : 0;
    return small < result.cases.cases.size() &&
           std::all_of(result.failing.begin(), result.failing.end(), [&](std::size_t i) { return angle(i) < kSmall; });
  };
  const auto angles = [&](std::size_t i) { return angles_of(result.cases.cases[i], Axes{}); };
  if (result.failing.empty()) return "";
  if (all_fail_where_small([&](std::size_t i) { return polar_tilt(result, i); })) {
    return "only rotations that hardly tilt the polar axis, or turn it over, fail: sin(beta) taken from "
           "sqrt(1 - cos^2(beta)), or beta from acos, loses digits there (near identity above all); take it from the "
           "third column of R, hypot(r02, r12)";
  }
  if (all_fail_where_small([&](std::size_t i) { return angles(i).from_half_turn; })) {
    return "only rotations near a half turn fail: a quaternion or an axis taken from 1 + trace(R) loses digits there; "
           "start from the largest component";
  }
  if (all_fail_where_small([&](std::size_t i) { return angles(i).from_identity; })) {
    return "only rotations near identity fail: an angle taken from its cosine loses digits there; take it from its "
           "sine";
  }
  return "the error does not depend on the angle";
}

// The signs whose flip makes the band right.
std::string sign_reason(const Band& own, const Band& expected, int l) {
  for (int m = -l; m <= l; ++m) {
    const std::string name = "m=" + std::to_string(m);
    Band row = own;
    Band column = own;
    row.row(m + l) *= -1;
    column.col(m + l) *= -1;
    Band both = row;
    both.col(m + l) *= -1;
    const auto limit = static_cast<double>(kFar);
    if (error_of(both, expected) <= limit) return "the function of " + name + " has the other sign";
    if (error_of(row, expected) <= limit) return "row " + name + " has the other sign";
    if (error_of(column, expected) <= limit) return "column " + name + " has the other sign";
  }
  return "";
}

std::string entry_reason(Complex found, Complex expected) {
  if (std::abs(found + expected) <= kFar) return "sign flipped";
  return std::abs(found) <= kFar ? "is zero" : "";
}

std::vector<WrongEntry> first_wrong_entry(const RotationReading& reading, const RotationCases& cases) {
  for (int l = 0; l <= cases.degree; ++l) {
    for (const RotationCase& one : cases.cases) {
      if (!is_general(one)) continue;
      const Band own = own_band(reading, one, l);
      const Band expected = expected_bands(reading, one, l).back();
      const auto wrong = ((own - expected).array().abs() > kFar).eval();
      if (!wrong.any()) continue;
      Eigen::Index row = 0;
      while (!wrong.row(row).any()) ++row;
      Eigen::Index column = 0;
      while (!wrong(row, column)) ++column;
      const Complex found = own(row, column);
      const Complex right = expected(row, column);
      return {{one.line, l, static_cast<int>(row) - l, static_cast<int>(column) - l, std::complex<double>(found),
               std::complex<double>(right),
               wrong.count() == 1 ? entry_reason(found, right) : sign_reason(own, expected, l)}};
    }
  }
  return {};
}

}  // namespace

RotationCheck check_rotations(const RotationCases& cases, double tolerance) {
  RotationCheck result;
  result.cases = cases;
  result.readings = best_rotation_readings(cases);
  const RotationReading& best = result.readings.front();
  result.wrong = first_wrong_entry(best, cases);
  result.fits = result.wrong.empty();
  const auto errors = measure(best, result);
  set_limits(errors, tolerance, result);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    bool fails = cases.cases[i].between_bands > result.bands.back().limit;
    for (std::size_t l = 0; l < errors[i].size(); ++l) fails = fails || !(errors[i][l] <= result.bands[l].limit);
    if (fails) result.failing.push_back(i);
  }
  sort_by_tilt(errors, result);
  if (result.fits) result.diagnosis = diagnose(result);
  return result;
}

}  // namespace sh::numeric::identify
