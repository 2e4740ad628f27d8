#include "prt/runtime/kept_coefficients.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sh::prt {

void require_kept(const Transfer& transfer, const LightCoefficients& light) {
  constexpr double kRounding = 1e-6;
  const std::vector<std::uint32_t>& kept = transfer.storage.kept;
  if (kept.empty() || light.values.empty()) {
    return;
  }
  const auto louder = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double largest = std::abs(*std::max_element(light.values.begin(), light.values.end(), louder));
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i % light.bands_squared());
    if (std::abs(light.values[i]) > kRounding * largest && !std::binary_search(kept.begin(), kept.end(), index)) {
      throw std::invalid_argument(fmt::format(
          "the transfer keeps {} of {} coefficients, those of its plan's lights (turned: {}); this light also has "
          "number {}: bake with --without symmetry",
          kept.size(), light.bands_squared(), transfer.plan.light_turns.empty() ? "any" : transfer.plan.light_turns,
          index));
    }
  }
}

}  // namespace sh::prt
