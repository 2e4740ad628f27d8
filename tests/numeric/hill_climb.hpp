// The worst input of a function of one variable, by search: from several starts across [low, high], steps to either
// side whose size shrinks, kept where the error grows. Rounding errors jump from one input to the next, so late steps
// are as small as the number's own spacing: the search ends among neighbors of a bad input.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

namespace sh::test {

struct WorstInput {
  double input = 0;
  double error = -1;
};

// error(input) >= 0 or NaN, which counts as infinite; starts * (steps + 1) calls. The same result every time.
template <class Error>
WorstInput hill_climb(double low, double high, int starts, int steps, const Error& error) {
  const auto size_of = [&](double input) {
    const double e = error(input);
    return std::isnan(e) ? HUGE_VAL : e;
  };
  std::mt19937_64 random(1);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  WorstInput worst;
  for (int start = 0; start < starts; ++start) {
    WorstInput best;
    best.input = low + (high - low) * (start + uniform()) / starts;
    best.error = size_of(best.input);
    for (int step = 0; step < steps; ++step) {
      // From a whole start's share of the interval down to the spacing of doubles there.
      const double reach = (high - low) / starts * std::exp2(-44.0 * step / steps);
      const double input = std::clamp(best.input + (2 * uniform() - 1) * reach, low, high);
      const double e = size_of(input);
      if (e > best.error) best = {input, e};
    }
    if (best.error > worst.error) worst = best;
  }
  return worst;
}

}  // namespace sh::test
