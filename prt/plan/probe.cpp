#include "prt/plan/probe.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sh::prt {

Probe choose_probe(const std::vector<double>& likely) {
  constexpr double kEvenPart = 0.5;
  const double sum = std::accumulate(likely.begin(), likely.end(), 0.0);
  const double even = 1.0 / static_cast<double>(likely.size());
  Probe probe;
  double before = 0.5;  // of the running sum of chances; where it passes a whole number, a vertex is chosen
  for (std::uint32_t v = 0; v < likely.size(); ++v) {
    const double weight = sum > 0.0 ? kEvenPart * even + (1.0 - kEvenPart) * likely[v] / sum : even;
    const double chance = std::min(1.0, static_cast<double>(Probe::kVertices) * weight);
    const double after = before + chance;
    if (std::floor(after) > std::floor(before)) {
      probe.vertices.push_back(v);
      probe.chances.push_back(chance);
    }
    before = after;
  }
  return probe;
}

double stated_error(const Probe& probe, const std::vector<double>& squares, std::size_t vertices,
                    const std::vector<double>& variances) {
  double sum = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double square = squares[i] / probe.chances[i];
    sum += square;
    variance += (1.0 - probe.chances[i]) * square * square;
    if (!variances.empty()) variance += variances[i] / probe.chances[i];
  }
  return std::sqrt((sum + Probe::kDeviations * std::sqrt(variance)) / static_cast<double>(vertices));
}

}  // namespace sh::prt
