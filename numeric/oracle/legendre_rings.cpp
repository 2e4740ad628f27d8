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

using Wide = long double;       // of the powers, so that they round once
constexpr int kPowers = 64;     // sine^m = sine^(m % 64) sine^(64 (m / 64))
constexpr int kMostKept = 200;  // max_degree of which the tables of all orders are kept

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

LegendreRings::LegendreRings(int max_degree, std::span<const double> z, std::span<const double> sine, RingLanes lanes,
                             RingTail tail)
    : max_degree_(max_degree), lanes_(lanes), tail_(tail), place_(z.size()) {
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
  for (int m = 0; max_degree <= kMostKept && m <= max_degree; ++m) {
    const std::size_t steps = static_cast<std::size_t>(max_degree - m) / 2 + 1;
    kept_tables_.push_back(std::make_unique<double[]>(rings::kArrays * rings::size_of_tables(steps)));
    fill(m, rings::tables_in(kept_tables_.back().get(), steps));
  }
}

void LegendreRings::fill(int order, const rings::Tables& tables) const {
  kernels(lanes_).prepare(order, tables, plain_ > 0, equator_ < z_.size());
}

// Pairs by rising sine, so that the lanes of a register are of similar size; rings with the same |z| and sine are one.
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
      const std::size_t group = z_.size() / rings::kPadding * rings::kPadding;
      if (absolute < rings::kNearEquator && group < z_.size() && sine_[group] < rings::kNearPole) pad();
      z_.push_back(absolute);
      sine_.push_back(s);
    }
    place_[i] = 4 * (z_.size() - 1) + (std::signbit(z[i]) ? 2 : 0);
  }
  pad();
  while (plain_ < z_.size() && sine_[plain_] < rings::kNearPole) plain_ += rings::kPadding;
  equator_ = z_.size();
  while (equator_ > plain_ && z_[equator_ - 1] < rings::kNearEquator) equator_ -= rings::kPadding;
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
  log_factorial_.push_back(0);
  for (int n = 1; n <= 2 * max_degree_; ++n) log_factorial_.push_back(log_factorial_.back() + std::log2(n));
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
  const double nothing = tail_ == RingTail::kAll ? -1080 : -rings::kLevel / 2;  // to base 2
  const double largest = 0.5 * (log_factorial_[degree + order] - log_factorial_[degree - order]) -
                         log_factorial_[order] - order + 0.5 * std::log2(2.0 * degree + 1);
  std::size_t first = 0;
  while (first < z_.size() && largest + order * log_sine_[first + rings::kPadding - 1] < nothing) {
    first += rings::kPadding;
  }
  return first;
}

// Memory of a call, kept from one call of a thread to the next.
struct LegendreRings::Work {
  std::vector<double> tables;
  std::vector<rings::Terms> terms;
  std::vector<double> values;  // (pairs, 4): of both components at z, then at -z

  static Work& of_this_thread() {
    thread_local Work work;
    return work;
  }

  rings::Column column(const LegendreRings& rings, int degree, int order) {
    const std::size_t steps = static_cast<std::size_t>(degree - order) / 2 + 1;
    values.assign(4 * rings.z_.size(), 0.0);
    terms.resize(rings::size_of_tables(steps));
    return {degree,
            order,
            steps,
            rings.sectoral_[order],
            rings.tail_ == RingTail::kAll ? rings::Tail{-1, std::ldexp(1.0, -rings::kLevel)} : rings::Tail{0, 0},
            filled(rings, order, steps),
            terms.data()};
  }

 private:
  rings::Tables filled(const LegendreRings& rings, int order, std::size_t steps) {
    if (!rings.kept_tables_.empty()) {
      const std::size_t kept_steps = static_cast<std::size_t>(rings.max_degree_ - order) / 2 + 1;
      rings::Tables all = rings::tables_in(rings.kept_tables_[order].get(), kept_steps);
      all.size = rings::size_of_tables(steps);
      return all;
    }
    tables.resize(rings::kArrays * rings::size_of_tables(steps));
    const rings::Tables all = rings::tables_in(tables.data(), steps);
    rings.fill(order, all);
    return all;
  }
};

rings::Pairs LegendreRings::pairs(int degree, int order) const {
  const std::size_t count = z_.size();
  const std::size_t low = order % kPowers * count;
  const std::size_t high = order / kPowers * count;
  return {first_pair(degree, order),
          plain_,
          equator_,
          count,
          z_.data(),
          sine_.data(),
          {low_mantissa_.data() + low, low_exponent_.data() + low},
          {high_mantissa_.data() + high, high_exponent_.data() + high}};
}

void LegendreRings::check(const char* what, int degree, int order, std::size_t coefficients, std::size_t values) const {
  const bool good = 0 <= order && order <= degree && degree <= max_degree_ &&
                    coefficients == 2 * (static_cast<std::size_t>(degree - order) + 1) && values == 2 * place_.size();
  if (good) return;
  const std::string where = std::string("LegendreRings: ") + what;
  require_range(where + ": degree", degree, 0, max_degree_);
  require_range(where + ": order", order, 0, degree);
  require_size(where + ": coefficients", static_cast<long>(coefficients), 2L * (degree - order + 1));
  require_size(where + ": values", static_cast<long>(values), 2 * std::ssize(place_));
}

void LegendreRings::synthesis(int degree, int order, std::span<const double> coefficients,
                              std::span<double> values) const {
  check("synthesis", degree, order, coefficients.size(), values.size());
  Work& work = Work::of_this_thread();
  const rings::Column column = work.column(*this, degree, order);
  const rings::Kernels& run = kernels(lanes_);
  run.spread(column, coefficients.data());
  run.synthesis(column, pairs(degree, order), work.values.data());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    std::copy_n(work.values.data() + place_[i], 2, values.data() + 2 * i);
  }
}

void LegendreRings::analysis(int degree, int order, std::span<const double> values,
                             std::span<double> coefficients) const {
  check("analysis", degree, order, coefficients.size(), values.size());
  Work& work = Work::of_this_thread();
  const rings::Column column = work.column(*this, degree, order);
  for (std::size_t i = 0; i < place_.size(); ++i) {
    double* const to = work.values.data() + place_[i];
    to[0] += values[2 * i];
    to[1] += values[2 * i + 1];
  }
  const rings::Kernels& run = kernels(lanes_);
  run.analysis(column, pairs(degree, order), work.values.data());
  run.gather(column, coefficients.data());
}

}  // namespace sh::numeric
