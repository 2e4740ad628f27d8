#include "prt/bake/bounces.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "prt/arrays.hpp"
#include "prt/bake/bounce_system.hpp"

namespace sh::prt {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The largest absolute value in some columns.
struct Largest {
  double x = 0.0;
  double r = 0.0;

  void take(const double* xs, const double* rs, std::size_t count) {
    if (count == 0) return;
    x = std::max(x, as_array(xs, count).abs().maxCoeff<Eigen::PropagateNumbers>());
    r = std::max(r, as_array(rs, count).abs().maxCoeff<Eigen::PropagateNumbers>());
  }
};

// The extremes of a panel's columns of one channel.
struct Extremes {
  Largest reflected;
  Largest emitted;
  double largest_y = 0.0;
  double least_y = kInfinity;
  double least_s = kInfinity;  // (I - A) y = 1 - r
  double largest_ratio = 0.0;  // of A y over y [Collatz42]
};

// Of the rows of this process.
template <class R>
Extremes extremes(const Ranks& ranks, const OwnRows& x, const R& r, const BounceLayout& layout, std::size_t channel) {
  Extremes e;
  for (std::size_t v = 0; v < x.rows(); ++v) {
    if (!ranks.owns(v)) continue;
    const double* xs = x.row(v) + layout.channel(channel);
    const double* rs = r.row(v) + layout.channel(channel);
    const std::size_t reflected = layout.count - layout.emitted;
    e.reflected.take(xs, rs, reflected);
    e.emitted.take(xs + reflected, rs + reflected, layout.emitted);
    const double y = xs[layout.count];
    const double s = 1.0 - rs[layout.count];
    e.largest_y = std::max(e.largest_y, y);
    e.least_y = std::min(e.least_y, y);
    e.least_s = std::min(e.least_s, s);
    e.largest_ratio = std::max(e.largest_ratio, 1.0 - s / y);
  }
  return e;
}

// Of the rows of all processes.
void share(const Ranks& ranks, Extremes& e) {
  if (ranks.count < 2) return;
  const Extremes own = e;
  for (std::size_t root = 0; root < ranks.count; ++root) {
    std::array numbers = {own.reflected.x, own.reflected.r, own.emitted.x, own.emitted.r,
                          own.largest_y,   own.least_y,     own.least_s,   own.largest_ratio};
    ranks.broadcast(numbers.data(), numbers.size(), root);
    e.reflected.x = std::max(e.reflected.x, numbers[0]);
    e.reflected.r = std::max(e.reflected.r, numbers[1]);
    e.emitted.x = std::max(e.emitted.x, numbers[2]);
    e.emitted.r = std::max(e.emitted.r, numbers[3]);
    e.largest_y = std::max(e.largest_y, numbers[4]);
    e.least_y = std::min(e.least_y, numbers[5]);
    e.least_s = std::min(e.least_s, numbers[6]);
    e.largest_ratio = std::max(e.largest_ratio, numbers[7]);
  }
}

// The ratio of the worse bound to the tolerance.
double excess(const BounceReport& report, double tolerance) {
  const auto part = [tolerance](double bound, double largest) {
    return bound > 0.0 ? bound / (tolerance * largest) : 0.0;
  };
  return std::max(part(report.bound, report.largest), part(report.emitted_bound, report.emitted_largest));
}

// True if the series still needs more bounces than a Krylov solver.
bool is_slow(int applications, double before, double now) {
  constexpr int kFirst = 8;
  constexpr double kManyMore = 30.0;
  if (applications < kFirst) return false;
  const double rate = now / before;
  return !(rate < 1.0) || std::log(1.0 / now) / std::log(rate) > kManyMore;
}

// x is a partial sum and r the term after it, which is the residual of x. before: the excess of the sum before.
void sum_series(BounceSystem& system, const BounceOptions& options, double before, OwnRows& x, Panel& r,
                OwnRows& room) {
  while (true) {
    system.certify(x, r);
    const double now = excess(system.report, options.tolerance);
    if (system.is_solved() || !system.may_go_on() ||
        (options.solver == BounceSolver::kAutomatic && is_slow(system.report.applications, before, now))) {
      return;
    }
    before = now;
    for_own_rows(system.ranks(), r.rows,
                 [&](std::size_t first, std::size_t last) { x.block(first, last) += r.block(first, last); });
    system.advance(r, room);
    system.keep(BounceState::Phase::kSeries, before, x, r);
  }
}

void check_shapes(const FormFactors& factors, const std::vector<Eigen::Vector3f>& albedo, const BounceLayout& layout,
                  const Panel& x, const BounceOptions& options) {
  if (factors.size() != x.rows || albedo.size() != x.rows || x.columns < layout.columns()) {
    throw std::invalid_argument("bounces: form factors, albedo and light differ in their number of vertices");
  }
  if (!(options.tolerance > 0.0)) {
    throw std::invalid_argument(fmt::format("tolerance: expected a positive number, got {}", options.tolerance));
  }
}

}  // namespace

// y = albedo y, one more application of A.
void BounceSystem::scale(Panel& y) {
  for_rows(y.rows, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
        const auto albedo = static_cast<double>(albedo_[v][c]);
        as_array(y.row(v) + layout_.channel(c), layout_.count + 1) *= albedo;
      }
    }
  });
  ++report.applications;
}

void BounceSystem::advance(Panel& x, OwnRows& room) {
  factors_.advance(x, room);
  scale(x);
}

void BounceSystem::residual(const OwnRows& b, const OwnRows& x, Panel& r, OwnRows& room) {
  x.gather(r);
  advance(r, room);
  for_own_rows(ranks(), r.rows, [&](std::size_t first, std::size_t last) {
    r.block(first, last) += b.block(first, last) - x.block(first, last);
  });
}

// The bound counts the roundings of r: those of A x, and those of b and x, at most 4 u max |x|, u = 2^-53.
template <class R>
void BounceSystem::certify(const OwnRows& x, const R& r) {
  const double rounding = factors_.rounding() + 4.0 * 0x1p-53;
  report.bound = report.residual = report.largest = report.spectral_bound = 0.0;
  report.emitted_bound = report.emitted_largest = 0.0;
  for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) {
    Extremes e = extremes(ranks(), x, r, layout_, c);
    share(ranks(), e);
    const double least_s = e.least_s - rounding * e.largest_y;
    const bool proves = e.least_y > 0.0 && least_s > 0.0;
    const double norm = proves ? e.largest_y / least_s : kInfinity;  // of (I - A)^-1
    const auto bound = [&](const Largest& largest) {
      const double error = largest.r + rounding * largest.x;
      return error == 0.0 ? 0.0 : norm * error;
    };
    report.bound = std::max(report.bound, bound(e.reflected));
    report.residual = std::max(report.residual, e.reflected.r);
    report.largest = std::max(report.largest, e.reflected.x);
    report.emitted_bound = std::max(report.emitted_bound, bound(e.emitted));
    report.emitted_largest = std::max(report.emitted_largest, e.emitted.x);
    report.spectral_bound = std::max(report.spectral_bound, proves ? e.largest_ratio : 1.0);
  }
}

template void BounceSystem::certify(const OwnRows& x, const Panel& r);
template void BounceSystem::certify(const OwnRows& x, const OwnRows& r);

bool BounceSystem::may_go_on() const {
  return report.applications < options_.most_applications && std::chrono::steady_clock::now() < options_.deadline;
}

bool BounceSystem::is_solved() const {
  return report.bound <= options_.tolerance * report.largest &&
         report.emitted_bound <= options_.tolerance * report.emitted_largest;
}

// `light` is the only whole panel: what the operator is applied to, and at the end the sum, of which a process keeps its own
// rows.
BounceReport solve_bounces(const FormFactors& factors, const std::vector<Eigen::Vector3f>& albedo, BounceLayout layout,
                           Panel& light, const BounceOptions& options, BounceCheckpoint* checkpoint) {
  check_shapes(factors, albedo, layout, light, options);
  for (std::size_t v = 0; v < light.rows; ++v) {
    for (std::size_t c = 0; c < BounceLayout::kChannels; ++c) light.row(v)[layout.channel(c) + layout.count] = 1.0;
  }
  const Ranks& ranks = factors.ranks();
  BounceSystem system(factors, albedo, layout, options, checkpoint);
  BounceReport& report = system.report;
  const OwnRows b(ranks, light);
  OwnRows x = b;
  Panel& r = light;
  std::optional<OwnRows> room(std::in_place, ranks, light.rows, light.columns);
  const std::optional<BounceState> kept = checkpoint == nullptr ? std::nullopt : checkpoint->load(x, r);
  if (kept) {
    report.applications = static_cast<int>(kept->applications);
  } else {
    system.advance(r, *room);
  }
  const bool is_in_krylov = kept && kept->phase == BounceState::Phase::kKrylov;
  if (options.solver != BounceSolver::kKrylov && !is_in_krylov) {
    report.solver = "series";
    double before = kInfinity;
    if (kept) before = kept->before;
    sum_series(system, options, before, x, r, *room);
    if (system.is_solved() && report.applications > 1) {  // the last term is the residual up to the terms' roundings
      system.residual(b, x, r, *room);
      system.certify(x, r);
    }
  } else {
    system.certify(x, r);
  }
  room.reset();
  if (!system.is_solved() && options.solver != BounceSolver::kSeries) {
    report.solver = "bicgstab";
    solve_krylov(system, b, x, r);
  }
  x.gather(light);
  const bool is_late = std::chrono::steady_clock::now() >= options.deadline;
  report.certified = system.is_solved() || (is_late && std::isfinite(report.bound));
  return report;
}

}  // namespace sh::prt
