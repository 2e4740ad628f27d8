// A plan in progress: facts about the scene, the decisions so far, and the remaining budget.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/plan/bounds.hpp"
#include "prt/plan/plan.hpp"
#include "prt/rays/gather.hpp"

namespace sh::prt {

/// The transfer of the probe: a few vertices, spread evenly over those of the mesh.
struct ProbeRows {
  std::vector<float> transfer;  // (vertices of the probe, bands^2) without albedo
  std::vector<double> blocked;  // (vertices of the probe) blocked part of the cosine, 0..1
};

struct Draft {
  Draft(const Scene& the_scene, const std::string& the_instruction_set);

  const Scene& scene;
  const std::string& instruction_set;
  const PlanOptions& options;
  const BakeOptions& asked;
  BakeOptions bake;  // as lowered by the decisions so far
  std::vector<RayStart> starts;
  float albedo = 0.0F;  // the largest
  Plan plan;
  double left = 0.0;      // of the budget
  double reserved = 0.0;  // part of `left` that is reserved for directions
  // Only set for a plan with a budget:
  std::optional<TurningLight> light;  // of the asked degree
  std::unique_ptr<Tracer> tracer;
  std::vector<std::uint32_t> probe;  // its vertices
  ProbeRows rows;                    // of the probe, along a few directions
  double mean_blocked = 0.0;         // of `rows`
  double gain = 1.0;                 // of radiance by bounces: 1 / (1 - albedo * most blocked), measured

  /// Makes the current request the baseline for savings.
  void start();
  /// The fraction `part` of the unreserved budget.
  [[nodiscard]] double share(double part) const { return part * (left - reserved); }
  /// False if the user skips this decision.
  [[nodiscard]] bool allows(std::string_view name) const;
  /// Records a decision and its savings. Call it after bake, plan.open and plan.storage have been changed.
  void decide(std::string_view name, std::string choice, std::string why, double error = 0.0,
              std::string_view basis = "exact");

  [[nodiscard]] PlanCost cost() const;
  /// The shape of a vertex's numbers after the decisions so far; count() is per channel.
  [[nodiscard]] TransferShape shape() const;
  [[nodiscard]] std::size_t count() const { return shape().count(); }
  [[nodiscard]] std::size_t traced() const;  // vertices that need rays
  [[nodiscard]] bool has_mirrors() const { return !scene.mesh.mirror.empty(); }
  [[nodiscard]] bool shines() const { return !scene.mesh.emission.empty(); }
  /// The bound on band l of a transfer vector after the decisions so far.
  [[nodiscard]] double band_bound(int l) const { return transfer_band_bound(*bake.kind, has_mirrors(), l); }
  /// The relative exit radiance that a product of transfer and light causes; the product assumes albedo 1.
  [[nodiscard]] double relative(double product, double factor = 1.0) const;
  /// The relative error if the numbers are off by at most e (bands^2 of the requested degree); e assumes albedo 1.
  [[nodiscard]] double error_of(const std::vector<double>& e) const;
  /// Shadowed transfer of the probe with this many directions of the scene's sampler.
  [[nodiscard]] ProbeRows trace_probe(int directions) const;
  /// The RMS over the probe of the relative exit radiance that a part of each vertex's vector causes. parts (vertices
  /// of the probe, bands^2 of the requested degree), without albedo.
  [[nodiscard]] double error_on_probe(const std::vector<float>& parts) const;

 private:
  PlanCost before_;
};

/// The safety factor on errors that are measured on a probe.
inline constexpr double kProbeMargin = 1.25;

/// The root mean square; 0 if there are no values.
double rms(const std::vector<double>& values);

// The decisions, in the order in which they are taken.
void decide_analytic(Draft& draft);
void decide_bounces(Draft& draft);
void decide_channels(Draft& draft);
void decide_bands(Draft& draft);
void decide_symmetry(Draft& draft);
void decide_storage(Draft& draft);
/// The error of the requested number of directions alone, which the budget reserves; throws if it exceeds the budget.
double floor_of_directions(const Draft& draft);
void decide_directions(Draft& draft);

}  // namespace sh::prt
