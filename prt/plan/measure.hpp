// Measures errors of exit radiance on a probe of vertices, for plans. Coarse bakes of the whole mesh (prt/plan/rehearsal.hpp)
// tell where errors are likely. Half of the probe is chosen there, so that it meets rare vertices, too; the rest is spread
// evenly. A vertex v is chosen with a known probability p_v, so that
//   mean square error = 1/V * sum over the probe of e_v^2 / p_v            [HorvitzThompson52]
// has no bias, and its standard error is about
//   1/V * sqrt(sum over the probe of (1 - p_v) e_v^4 / p_v^2).
// What is stated is the root of the mean square plus kDeviations standard errors, for the worst of some turns of the light.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "prt/plan/rehearsal.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

class Measurement {
 public:
  static constexpr std::size_t kProbe = 512;   // vertices, about
  static constexpr int kReference = 8192;      // directions, at least
  static constexpr double kDeviations = 2.33;  // one-sided confidence
  static constexpr int kConfidence = 99;       // percent

  /// Exit radiances of the probe, (turns, vertices of the probe, 3), over the unit of errors.
  using Radiances = std::vector<double>;

  /// `light` has the asked degree; errors are relative to the radiance `unit`.
  Measurement(const Scene& scene, const LightCoefficients& light, LightTurns turns, double unit,
              const std::string& instruction_set);

  /// The numbers of the probe as a bake with these options makes them, at the asked degree, in the shape of their kind.
  [[nodiscard]] std::vector<float> rows(const BakeOptions& options, const std::vector<std::uint8_t>& open = {}) const;
  /// The same numbers after a file has kept them in `shape`, whose degree may be lower, and lost the others.
  [[nodiscard]] std::vector<float> kept(const std::vector<float>& rows, const TransferShape& shape) const;
  [[nodiscard]] Radiances radiances(const std::vector<float>& rows, const TransferShape& shape) const;
  /// The stated error for differences of radiances.
  [[nodiscard]] double error(const Radiances& difference) const;
  /// The factor by which bounces spread differences that directions make (Rehearsal::spread); 1 without bounces.
  [[nodiscard]] double spread() const { return spread_; }

  /// Many directions, of which the asked ones are no part: their own error counts little.
  [[nodiscard]] BakeOptions reference_options(BakeOptions options) const;
  [[nodiscard]] std::size_t probe() const { return part_->wanted(); }
  [[nodiscard]] std::size_t turns() const { return lights_.size(); }
  /// The mean over the coarse bakes of the part of the cosine that hits something.
  [[nodiscard]] double blocked(std::size_t vertex) const;
  /// True if a bake looks for the closest hits of this vertex, too.
  [[nodiscard]] bool is_nearly_dark(std::size_t vertex) const;
  /// Rays of a bake of the whole mesh for each direction.
  [[nodiscard]] double rays_a_direction() const;

 private:
  void choose_probe();
  [[nodiscard]] std::vector<double> likely_errors() const;
  [[nodiscard]] double size_of(const float* row, std::size_t vertex) const;

  const Scene& scene_;
  double unit_;
  std::vector<LightCoefficients> lights_;               // turned
  std::vector<std::unique_ptr<Rehearsal>> rehearsals_;  // one, or one a channel where mirrors have colors
  std::optional<TracedPart> part_;
  std::vector<double> chance_;                     // of the vertices of the probe
  std::array<std::vector<double>, 3> band_norms_;  // of the light, for each channel
  double spread_ = 1.0;
};

}  // namespace sh::prt
