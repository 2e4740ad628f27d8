// See rotation_check.hpp.
#include "numeric/identify/rotation_check.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace sh::numeric::identify {
namespace {

using Complex = std::complex<long double>;

// Largest entry of D D* - 1.
double defect_of(const Band& band, std::size_t width) {
  long double largest = 0;
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      Complex sum = i == k ? -1.0L : 0.0L;
      for (std::size_t n = 0; n < width; ++n) sum += band[i * width + n] * std::conj(band[k * width + n]);
      largest = std::max(largest, std::abs(sum));
    }
  }
  return static_cast<double>(largest);
}

double error_of(const Band& own, const Band& expected) {
  long double largest = 0;
  for (std::size_t i = 0; i < own.size(); ++i) largest = std::max(largest, std::abs(own[i] - expected[i]));
  return static_cast<double>(largest);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// True errors, [case][band], and the defects in `result`.
std::vector<std::vector<double>> measure(const RotationReading& reading, RotationCheck& result) {
  const int degree = result.cases.degree;
  result.bands.resize(static_cast<std::size_t>(degree) + 1);
  std::vector<std::vector<double>> errors;
  for (std::size_t i = 0; i < result.cases.cases.size(); ++i) {
    const RotationCase& one = result.cases.cases[i];
    const auto own = own_bands(reading, one, degree);
    const auto expected = expected_bands(reading, one, degree);
    errors.emplace_back();
    for (std::size_t l = 0; l < own.size(); ++l) {
      BandErrors& band = result.bands[l];
      band.degree = static_cast<int>(l);
      band.defect = std::max(band.defect, defect_of(own[l], 2 * l + 1));
      errors.back().push_back(error_of(own[l], expected[l]));
      if (errors.back().back() <= band.error && i > 0) continue;
      band.error = errors.back().back();
      band.worst = i;
    }
    result.between_bands = std::max(result.between_bands, one.between_bands);
  }
  return errors;
}

void set_limits(const std::vector<std::vector<double>>& errors, double tolerance, RotationCheck& result) {
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

void sort_by_tilt(const std::vector<std::vector<double>>& errors, RotationCheck& result) {
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

// What the failing cases have in common that the others have not.
std::string diagnose(const RotationCheck& result) {
  constexpr double kSmall = 0.1;
  const auto all_fail_where = [&](const std::function<double(std::size_t)>& angle) {
    const auto is_small = [&](std::size_t i) { return angle(i) < kSmall; };
    std::vector<std::size_t> all(result.cases.cases.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return std::all_of(result.failing.begin(), result.failing.end(), is_small) &&
           !std::all_of(all.begin(), all.end(), is_small);
  };
  if (result.failing.empty()) return "";
  if (all_fail_where([&](std::size_t i) { return polar_tilt(result, i); })) {
    return "only rotations that hardly tilt the polar axis, or turn it over, fail: sin(beta) taken from "
           "sqrt(1 - cos^2(beta)), or beta from acos, loses digits there (near identity above all); take it from the "
           "third column of R, hypot(r02, r12)";
  }
  const Axes axes = result.readings.front().convention.axes;
  if (all_fail_where([&](std::size_t i) { return angles_of(result.cases.cases[i], axes).from_half_turn; })) {
    return "only rotations near a half turn fail: a quaternion or an axis taken from 1 + trace(R) loses digits there; "
           "start from the largest component";
  }
  if (all_fail_where([&](std::size_t i) { return angles_of(result.cases.cases[i], axes).from_identity; })) {
    return "only rotations near identity fail: an angle taken from its cosine loses digits there; take it from its "
           "sine";
  }
  return "the error does not depend on the angle";
}

struct Spoiler {
  std::string reason;
  bool row = false, column = false;
};

// Signs whose flip makes the band right.
std::string sign_reason(const Band& own, const Band& expected, int l) {
  const auto width = static_cast<std::size_t>(2 * l + 1);
  for (std::size_t m = 0; m < width; ++m) {
    const std::string name = "m=" + std::to_string(static_cast<int>(m) - l);
    for (const Spoiler& spoiler : {Spoiler{"the function of " + name + " has the other sign", true, true},
                                   Spoiler{"row " + name + " has the other sign", true, false},
                                   Spoiler{"column " + name + " has the other sign", false, true}}) {
      Band flipped = own;
      for (std::size_t k = 0; k < width; ++k) {
        if (spoiler.row) flipped[m * width + k] *= -1;
        if (spoiler.column) flipped[k * width + m] *= -1;
      }
      if (error_of(flipped, expected) <= static_cast<double>(kFar)) return spoiler.reason;
    }
  }
  return "";
}

std::string entry_reason(Complex found, Complex expected) {
  if (std::abs(found + expected) <= kFar) return "sign flipped";
  if (std::abs(found) <= kFar) return "is zero";
  return "";
}

std::vector<WrongEntry> first_wrong_entry(const RotationReading& reading, const RotationCases& cases) {
  for (int l = 0; l <= cases.degree; ++l) {
    for (const RotationCase& one : cases.cases) {
      if (!is_general(one)) continue;
      const auto own = own_bands(reading, one, l).back();
      const auto expected = expected_bands(reading, one, l).back();
      const auto is_wrong = [&](std::size_t i) { return std::abs(own[i] - expected[i]) > kFar; };
      int count = 0;
      std::size_t first = own.size();
      for (std::size_t i = own.size(); i-- > 0;) {
        if (!is_wrong(i)) continue;
        ++count;
        first = i;
      }
      if (count == 0) continue;
      const int place = static_cast<int>(first);
      const auto reason = count == 1 ? entry_reason(own[first], expected[first]) : sign_reason(own, expected, l);
      return {{one.line, l, place / (2 * l + 1) - l, place % (2 * l + 1) - l, std::complex<double>(own[first]),
               std::complex<double>(expected[first]), reason}};
    }
  }
  return {};
}

}  // namespace

RotationCheck check_rotations(const RotationCases& cases, double tolerance) {
  const auto candidates = ranked_rotation_readings(cases);
  RotationCheck result;
  result.cases = cases;
  for (const auto& c : candidates) {
    if (c.wrong == candidates.front().wrong) result.readings.push_back(c.reading);
  }
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
