// See legendre_rings.hpp: checks, pairs of rings, powers of their sines; the inner loops are rings/kernels.cpp.
#include "numeric/oracle/legendre_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "numeric/oracle/legendre.hpp"
#include "numeric/oracle/require.hpp"
#include "numeric/oracle/rings/call.hpp"

namespace sh::numeric {
namespace {

using Wide = long double;           // of the powers, so that they round once
constexpr int kPowers = 64;         // sine^m = sine^(m % 64) sine^(64 (m / 64))
constexpr double kNothing = -1080;  // to base 2: below every double
constexpr std::size_t kWidest = 8;  // lanes

const rings::Kernels& kernels(RingLanes lanes) {
#if defined(SH_RINGS_X86)
  if (lanes == RingLanes::kAvx512) return rings::avx512::kKernels;
  if (lanes == RingLanes::kAvx2) return rings::avx2::kKernels;
#endif
  static_cast<void>(lanes);
  return rings::baseline::kKernels;
}

}  // namespace

bool available(RingLanes lanes) noexcept {
#if defined(SH_RINGS_X86)
  if (lanes == RingLanes::kAvx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (lanes == RingLanes::kAvx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("fma");
  }
#endif
  return lanes == RingLanes::kBaseline;
}

RingLanes widest_ring_lanes() noexcept {
  for (const RingLanes lanes : {RingLanes::kAvx512, RingLanes::kAvx2}) {
    if (available(lanes)) return lanes;
  }
  return RingLanes::kBaseline;
}

LegendreRings::LegendreRings(int max_degree, std::span<const double> z, std::span<const double> sine, RingLanes lanes)
    : max_degree_(max_degree), lanes_(lanes), ring_(z.size()) {
  require_range("LegendreRings: max_degree", max_degree, 0, kMaxDegree);
  require_size("LegendreRings: sine", std::ssize(sine), std::ssize(z));
  if (!available(lanes)) throw std::invalid_argument("LegendreRings: expected lanes that this machine has");
  for (std::size_t i = 0; i < z.size(); ++i) {
    const bool good = std::isfinite(z[i]) && std::isfinite(sine[i]) && sine[i] >= 0 &&
                      std::abs(z[i] * z[i] + sine[i] * sine[i] - 1) <= 16 * machine_epsilon<double>();
    if (good) continue;
    throw std::invalid_argument("LegendreRings: ring " + std::to_string(i) +
                                ": expected a point of the circle with sine >= 0, got z = " + std::to_string(z[i]) +
                                ", sine = " + std::to_string(sine[i]));
  }
  add_pairs(z, sine);
  add_powers();
}

// Pairs by rising sine, so that the lanes of a block are of similar size; rings with the same |z| and sine are one.
void LegendreRings::add_pairs(std::span<const double> z, std::span<const double> sine) {
  const auto key = [&](std::size_t i) { return std::pair(sine[i], std::abs(z[i])); };
  std::vector<std::size_t> by_sine(z.size());
  std::iota(by_sine.begin(), by_sine.end(), std::size_t{0});
  std::sort(by_sine.begin(), by_sine.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  const auto pad = [this] {
    while (z_.size() % rings::kPadding != 0) {
      z_.push_back(double{z_.back()});
      sine_.push_back(double{sine_.back()});
    }
  };
  for (const std::size_t i : by_sine) {
    const auto [s, absolute] = key(i);
    if (z_.empty() || z_.back() != absolute || sine_.back() != s) {
      const std::size_t block = z_.size() / rings::kPadding * rings::kPadding;
      if (absolute < rings::kNearEquator && block < z_.size() && sine_[block] < rings::kNearPole) pad();
      z_.push_back(absolute);
      sine_.push_back(s);
    }
    ring_[i] = {z_.size() - 1, std::signbit(z[i])};
  }
  pad();
}

void LegendreRings::add_powers() {
  const std::size_t pairs = z_.size();
  const int high = max_degree_ / kPowers + 1;
  low_mantissa_.resize(kPowers * pairs);
  low_exponent_.resize(kPowers * pairs);
  high_mantissa_.resize(high * pairs);
  high_exponent_.resize(high * pairs);
  const auto store = [pairs](const std::vector<Scaled<Wide>>& powers, int count, std::size_t pair,
                             std::vector<double>& mantissa, std::vector<double>& exponent) {
    for (int j = 0; j < count; ++j) {
      const Scaled<Wide> near = scaled(powers[j].mantissa);
      mantissa[j * pairs + pair] = static_cast<double>(near.mantissa);
      exponent[j * pairs + pair] = static_cast<double>(near.exponent + powers[j].exponent);
    }
  };
  for (std::size_t p = 0; p < pairs; ++p) {
    log_sine_.push_back(std::log2(sine_[p]));
    const auto low = scaled_powers(scaled(Wide{sine_[p]}), kPowers + 1);
    store(low, kPowers, p, low_mantissa_, low_exponent_);
    store(scaled_powers(low.back(), high), high, p, high_mantissa_, high_exponent_);
  }
  Wide square = 1 / (4 * pi<Wide>());
  for (int m = 0; m <= max_degree_; ++m) {
    if (m > 0) square = square * static_cast<Wide>(2 * m + 1) / static_cast<Wide>(2 * m);
    sectoral_.push_back(static_cast<double>(std::sqrt(square)));
  }
}

// P_lm / sine^m is largest at the pole and grows with l: sqrt((2l+1) / 4 pi (l+m)! / (l-m)!) / (2^m m!). Pairs whose
// sine leaves nothing of that need no work. [Szego75] theorem 7.33.1
std::size_t LegendreRings::first_pair(int degree, int order) const {
  if (order == 0) return 0;
  const double l = degree;
  const double m = order;
  const double largest =
      (0.5 * (std::lgamma(l + m + 1) - std::lgamma(l - m + 1)) - std::lgamma(m + 1)) / std::numbers::ln2 - m +
      0.5 * std::log2(2 * l + 1);
  std::size_t first = 0;
  while (first < z_.size() && largest + m * log_sine_[first + rings::kPadding - 1] < kNothing) first += rings::kPadding;
  return first;
}

// Memory of a call, kept from one call of a thread to the next.
struct LegendreRings::Work {
  std::vector<double> eps, alpha;
  std::vector<rings::Step> table;
  std::vector<rings::Growth> pole, equator;
  std::vector<double> sums;   // (4, pairs)
  std::vector<double> lanes;  // (steps + 1, 4, kWidest)

  static Work& of_this_thread() {
    thread_local Work work;
    return work;
  }

  rings::Column column(const LegendreRings& rings, int degree, int order) {
    const std::size_t steps = (degree - order) / 2 + 1;
    eps.resize(2 * steps + 8);
    alpha.resize(steps);
    table.resize(steps);
    pole.resize(steps);
    equator.resize(steps);
    sums.resize(4 * rings.z_.size());
    const double start = rings.sectoral_[order];
    return {degree, order, steps, start, eps.data(), alpha.data(), table.data(), pole.data(), equator.data()};
  }
};

rings::Pairs LegendreRings::pairs(int degree, int order) const {
  const std::size_t count = z_.size();
  const std::size_t low = order % kPowers * count;
  const std::size_t high = order / kPowers * count;
  return {first_pair(degree, order),
          count,
          z_.data(),
          sine_.data(),
          {low_mantissa_.data() + low, low_exponent_.data() + low},
          {high_mantissa_.data() + high, high_exponent_.data() + high}};
}

void LegendreRings::check(const char* what, int degree, int order, std::size_t coefficients, std::size_t values) const {
  const std::string where = std::string("LegendreRings: ") + what;
  require_range(where + ": degree", degree, 0, max_degree_);
  require_range(where + ": order", order, 0, degree);
  require_size(where + ": coefficients", static_cast<long>(coefficients), 2L * (degree - order + 1));
  require_size(where + ": values", static_cast<long>(values), 2 * std::ssize(ring_));
}

void LegendreRings::synthesis(int degree, int order, std::span<const double> coefficients,
                              std::span<double> values) const {
  check("synthesis", degree, order, coefficients.size(), values.size());
  Work& work = Work::of_this_thread();
  const rings::Column column = work.column(*this, degree, order);
  const rings::Pairs rings = pairs(degree, order);
  std::fill(work.sums.begin(), work.sums.end(), 0);  // of pairs that need no work
  const rings::Kernels& run = kernels(lanes_);
  run.prepare(column);
  run.spread(column, coefficients.data());
  run.synthesis(column, rings, work.sums.data());
  const double* const even = work.sums.data();
  const double* const odd = even + 2 * z_.size();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const auto [pair, south] = ring_[i];
    const double sign = south ? -1 : 1;
    values[2 * i] = even[pair] + sign * odd[pair];
    values[2 * i + 1] = even[z_.size() + pair] + sign * odd[z_.size() + pair];
  }
}

void LegendreRings::analysis(int degree, int order, std::span<const double> values,
                             std::span<double> coefficients) const {
  check("analysis", degree, order, coefficients.size(), values.size());
  Work& work = Work::of_this_thread();
  const rings::Column column = work.column(*this, degree, order);
  std::fill(work.sums.begin(), work.sums.end(), 0);
  double* const even = work.sums.data();
  double* const odd = even + 2 * z_.size();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const auto [pair, south] = ring_[i];
    const double sign = south ? -1 : 1;
    for (std::size_t c = 0; c < 2; ++c) {
      even[c * z_.size() + pair] += values[2 * i + c];
      odd[c * z_.size() + pair] += sign * values[2 * i + c];
    }
  }
  work.lanes.resize(4 * kWidest * (column.steps + 1));
  const rings::Kernels& run = kernels(lanes_);
  run.prepare(column);
  run.analysis(column, pairs(degree, order), work.sums.data(), work.lanes.data());
  run.gather(column, coefficients.data());
}

}  // namespace sh::numeric
