// The worst input of a function by search: hill climbing from many starts, in the type that the function computes in.
//
// Input: an error to be made large, starting points, a map back to the domain. Output: the tops reached, worst first.
// Errors of floating-point code jump from one input to the next, so there is no slope to follow: each step changes the
// present point at random, by ulps in one coordinate or relatively in all of them, at scales from one ulp to the whole
// value, and stays there if the error is larger. Changes that keep magnitudes (signs, copies, zeros) are tried as well.
// The search starts at the worst of the sampled inputs; measured on the generated kernels (README.md) it finds errors
// 1.1 to 2 times as large. Deterministic: the same bits for the same arguments on every IEEE machine.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

#include "numeric/sampling/random.hpp"

namespace sh::numeric {

/// T: float or double.
template <class T>
struct SearchProblem {
  std::function<double(const T* in)> error;  // >= 0; not a number counts as infinite
  std::function<bool(T* in)> to_domain;      // moves a point back to the domain, rounded; false if there is no way back
  std::vector<bool> fixed;                   // coordinates that are never changed; empty: none
};

struct SearchEffort {
  std::size_t climbs = 4;         // from the starts with the largest errors
  std::size_t evaluations = 500;  // a climb
  std::uint64_t seed = 1;
};

template <class T>
struct FoundInput {
  std::vector<T> input;
  double error = 0;
};

namespace detail {

template <class T>
class Climber {
 public:
  Climber(const SearchProblem<T>& problem, std::uint64_t seed) : problem_(problem), random_(seed) {}

  [[nodiscard]] double error(const std::vector<T>& input) const {
    const double value = problem_.error(input.data());
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }

  void climb(FoundInput<T>& point, std::size_t evaluations) {
    for (std::size_t i = 0; i < evaluations; ++i) {
      std::vector<T> next = point.input;
      change(next);
      if (problem_.to_domain && !problem_.to_domain(next.data())) continue;
      const double found = error(next);
      if (found > point.error) point = {next, found};
    }
  }

 private:
  static constexpr int kDigits = std::numeric_limits<T>::digits;

  // 0 .. n-1
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>((random_.next() + 1) / 2 * static_cast<double>(n));
  }
  T relative() {  // 1 +- 2^-k, k = 0 .. kDigits - 1
    const auto places = static_cast<int>(below(kDigits));
    return static_cast<T>(1 + std::ldexp(random_.next(), -places));
  }
  [[nodiscard]] bool is_fixed(std::size_t i) const { return !problem_.fixed.empty() && problem_.fixed[i]; }

  // The number `steps` places further in the order of all numbers, at most the largest.
  static T moved(T value, std::int64_t steps) {
    using Bits = std::conditional_t<sizeof(T) == sizeof(float), std::int32_t, std::int64_t>;
    const auto magnitude = static_cast<std::int64_t>(std::bit_cast<Bits>(std::abs(value)));
    const std::int64_t place = (std::signbit(value) ? -magnitude : magnitude) + steps;
    const auto largest = static_cast<std::int64_t>(std::bit_cast<Bits>(std::numeric_limits<T>::max()));
    const T result = std::bit_cast<T>(static_cast<Bits>(std::min(std::abs(place), largest)));
    return place < 0 ? -result : result;
  }

  void change(std::vector<T>& point) {
    const double kind = random_.next();
    if (kind < -0.4) {
      for (std::size_t n = 0, count = 1 + below(3); n < count; ++n) change_by_ulps(point);
    } else if (kind < 0.3) {
      const T scale = relative() - 1;
      for (std::size_t i = 0; i < point.size(); ++i) {
        if (!is_fixed(i)) point[i] += point[i] * scale * static_cast<T>(random_.next());
      }
    } else {
      change_one(point, kind);
    }
  }

  void change_by_ulps(std::vector<T>& point) {
    const std::size_t i = below(point.size());
    const std::int64_t steps = std::int64_t{1} << below(kDigits);
    if (!is_fixed(i)) point[i] = moved(point[i], random_.next() < 0 ? -steps : steps);
  }

  void change_one(std::vector<T>& point, double kind) {
    const std::size_t i = below(point.size());
    if (is_fixed(i)) return;
    if (kind < 0.7) {
      point[i] *= relative();
    } else if (kind < 0.8) {
      point[i] = -point[i];
    } else if (kind < 0.9) {
      point[i] = point[below(point.size())];
    } else {
      point[i] = kind < 0.95 ? T(0) : static_cast<T>(random_.next());
    }
  }

  const SearchProblem<T>& problem_;
  Random random_;
};

}  // namespace detail

/// One point a climb, the worst first. The starts have to be in the domain, and at least one.
template <class T>
std::vector<FoundInput<T>> worst_inputs(const SearchProblem<T>& problem, const std::vector<std::vector<T>>& starts,
                                        const SearchEffort& effort) {
  detail::Climber<T> climber(problem, effort.seed);
  std::vector<FoundInput<T>> points;
  points.reserve(starts.size());
  for (const auto& start : starts) points.push_back({start, climber.error(start)});
  const auto worse = [](const FoundInput<T>& a, const FoundInput<T>& b) { return a.error > b.error; };
  std::stable_sort(points.begin(), points.end(), worse);
  points.resize(std::min(points.size(), effort.climbs));
  for (auto& point : points) climber.climb(point, effort.evaluations);
  std::stable_sort(points.begin(), points.end(), worse);
  return points;
}

}  // namespace sh::numeric
