// Measures errors of exit radiance on a probe of vertices (prt/plan/probe.hpp), for plans. Coarse bakes of the whole mesh
// (prt/plan/rehearsal.hpp) tell where errors are likely. What is stated is the error for the worst of some turns of the
// light. Glossy surfaces are seen from many sides (prt/plan/views.hpp); their error is the RMS over these, too.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prt/mesh/keep_vertices.hpp"
#include "prt/plan/bounds.hpp"
#include "prt/plan/color_rehearsal.hpp"
#include "prt/plan/probe.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// The light, and even turns of it, about z or about any axis.
std::vector<LightCoefficients> turns_of(const LightCoefficients& light, LightTurns turns);

/// The exit radiance that a row of a diffuse kind has under light of its degree: the albedo, unless the numbers hold it,
/// times numbers times light.
Eigen::Vector3d radiance_of(const float* row, const TransferShape& shape, const LightCoefficients& light,
                            const Eigen::Vector3f& albedo);

/// A bound on the exit radiance of a vertex in any channel, for any turn of the light: the albedo, unless the numbers of
/// the row hold it, times the sum of |t_l| |L_l| over the bands. Unlike the radiance itself it is hardly ever small by
/// accident.
double radiance_bound(const float* row, const TransferShape& shape, const TurningLight& light,
                      const Eigen::Vector3f& albedo);

/// RMS over the vertices, and the eyes of glossy transfer, of exit radiance in the largest channel, for the worst of these
/// lights, which may have a higher degree: an error, if the numbers are differences. Rows are complete.
double worst_radiance(const Transfer& transfer, const std::vector<LightCoefficients>& lights);

class Measurement {
 public:
  static constexpr int kReference = 8192;  // directions, at least

  /// Exit radiances of the probe, (turns, vertices of the probe, eyes, 3), over the unit of errors. Diffuse kinds have one
  /// eye.
  using Radiances = std::vector<double>;
  static constexpr std::size_t kTurnsOfSome = 4;  // for what takes long

  /// `light` has the asked degree; errors are relative to the radiance `unit`.
  Measurement(const Scene& scene, const LightCoefficients& light, LightTurns turns, double unit,
              const std::string& instruction_set);

  /// From now on the vertices of the mesh that are not kept are interpolated; `likely` (vertices) is how large the error
  /// of that may be, over the unit. The kind is diffuse. The probe is another one then. Empty marks keep all.
  void keep(const std::vector<std::uint8_t>& kept, const std::vector<double>& likely);

  /// The rows of the probe, and of the receivers that show it, as a bake with these options makes them, at the asked degree,
  /// in the RowShape of their kind.
  [[nodiscard]] std::vector<float> rows(const BakeOptions& options, const std::vector<std::uint8_t>& open = {}) const;
  /// The same numbers after a file has kept them in `shape`, whose degree may be lower, and lost the others.
  [[nodiscard]] std::vector<float> kept(const std::vector<float>& rows, const RowShape& shape) const;
  /// As they are shown: interpolated between receivers.
  [[nodiscard]] Radiances radiances(const std::vector<float>& rows, const RowShape& shape) const;
  /// Those of the vertices of the probe themselves, as if all were receivers.
  [[nodiscard]] Radiances own_radiances(const std::vector<float>& rows, const RowShape& shape) const;
  /// The stated error for differences of radiances.
  [[nodiscard]] double error(const Radiances& difference) const;
  /// The factor by which bounces spread differences that directions make (Rehearsal::spread); 1 without bounces.
  [[nodiscard]] double spread() const { return spread_; }

  /// Many directions, of which the asked ones are no part: their own error counts little.
  [[nodiscard]] BakeOptions reference_options(BakeOptions options) const;
  [[nodiscard]] const Probe& probe() const { return probe_; }
  [[nodiscard]] const ColorRehearsal& rehearsal() const { return rehearsal_; }
  [[nodiscard]] std::size_t turns() const { return lights_.size(); }
  [[nodiscard]] const std::vector<LightCoefficients>& lights() const { return lights_; }
  /// The mean over the coarse bakes of the part of the cosine that hits something.
  [[nodiscard]] double blocked(std::size_t vertex) const;
  /// True if a bake looks for the closest hits of this vertex, too.
  [[nodiscard]] bool is_nearly_dark(std::size_t vertex) const;
  /// Rays of a bake of the whole mesh for each direction.
  [[nodiscard]] double rays_a_direction() const;

 private:
  [[nodiscard]] std::vector<double> likely_errors(const TurningLight& light) const;
  [[nodiscard]] std::vector<double> likely_glossy_errors() const;
  [[nodiscard]] Radiances glossy_radiances(const std::vector<float>& rows, const RowShape& shape) const;
  [[nodiscard]] std::size_t eyes() const;
  [[nodiscard]] Radiances blended(const std::vector<float>& rows, const TransferShape& shape,
                                  const std::vector<Blend>& blends) const;
  // The first turns of the light, for what takes long.
  [[nodiscard]] std::vector<LightCoefficients> some_lights() const;

  const Scene& scene_;
  double unit_;
  std::vector<LightCoefficients> lights_;  // turned
  ColorRehearsal rehearsal_;
  std::vector<double> likely_;  // (vertices) how large the error of directions may be
  Probe probe_;
  std::optional<TracedPart> part_;  // the probe and the receivers that show it, and from which these take light
  std::vector<Blend> shown_;        // (probe) of what is wanted of the part; empty: the probe itself
  double spread_ = 1.0;
};

}  // namespace sh::prt
