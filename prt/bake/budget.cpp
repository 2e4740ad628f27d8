#include "prt/bake/budget.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace sh::prt {

namespace {

constexpr double kUsed = 5.0 / 6.0;
constexpr double kOfBounces = 0.5;

}  // namespace

BakeOptions within_budget(const BakeOptions& wanted, const BakeEstimate& estimate, double seconds) {
  const double available = kUsed * seconds - estimate.setup_seconds;
  const double bounces = std::min(estimate.bounces * estimate.bounce_seconds, kOfBounces * available);
  const double part = (available - bounces) / std::max(estimate.pass_seconds, 1e-9);
  const int least = std::min(kLeastDirections, wanted.directions);
  BakeOptions options = wanted;
  if (part < 1.0) {
    options.directions = static_cast<int>(part * static_cast<double>(wanted.directions));
  }
  if (options.directions < least) {
    const double pass = estimate.pass_seconds * static_cast<double>(least) / static_cast<double>(wanted.directions);
    const double needed =
        (estimate.setup_seconds + pass + std::min(pass, estimate.bounces * estimate.bounce_seconds)) / kUsed;
    throw std::runtime_error(
        fmt::format("--budget-seconds {}: too short; {} directions, the least, take about {:.2g} s", seconds, least,
                    std::max(needed, 1.01 * seconds)));
  }
  return options;
}

Shortfall shortfall(const BakeOptions& wanted, const Transfer& transfer) {
  Shortfall missing;
  if (transfer.directions > 0 && static_cast<int>(transfer.directions) < wanted.directions) {
    missing.directions = static_cast<std::uint32_t>(wanted.directions);
  }
  if (transfer.kind == TransferKind::kInterreflected &&
      !(transfer.bounces.bound <= wanted.bounces.tolerance * transfer.bounces.largest)) {
    missing.tolerance = wanted.bounces.tolerance;
  }
  return missing;
}

}  // namespace sh::prt
