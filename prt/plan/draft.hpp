// A plan while it is made: facts about the scene, decisions so far, and the budget that is left.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "prt/plan/plan.hpp"
#include "prt/plan/probe.hpp"
#include "prt/plan/turning_light.hpp"

namespace sh::prt {

struct Draft {
  Draft(const Scene& the_scene, const PlanOptions& the_options);

  const Scene& scene;
  const PlanOptions& options;
  const BakeOptions asked;
  BakeOptions bake;  // as decided so far
  std::vector<RayStart> starts;
  float albedo = 0.0F;  // the largest
  Plan plan;
  double left = 0.0;      // of the budget
  double reserved = 0.0;  // of it, for directions
  // Of a plan with a budget only:
  std::unique_ptr<TurningLight> light;  // of the asked degree
  std::unique_ptr<Probe> probe;
  ProbeRows rows;             // of the probe, along a few directions
  double mean_blocked = 0.0;  // of `rows`
  double gain = 1.0;          // by bounces: 1 / (1 - albedo * most blocked), measured

  /// Makes the current request the baseline for savings.
  void start();
  /// That part of the budget, of what is not reserved.
  [[nodiscard]] double share(double part) const { return part * (left - reserved); }
  /// The decision may be taken; else it is noted as not taken.
  bool takes(std::string_view name);
  /// Notes a decision once bake, plan.open and plan.storage follow it, with its savings against before.
  void decide(std::string_view name, std::string choice, std::string why, double error, std::string_view basis);

  [[nodiscard]] PlanCost cost() const;
  /// Of a vertex's numbers as decided so far, and their count a channel.
  [[nodiscard]] TransferShape shape() const;
  [[nodiscard]] std::size_t count() const { return shape().count(); }
  [[nodiscard]] std::size_t traced() const;  // vertices that need rays
  [[nodiscard]] bool has_mirrors() const { return !scene.mesh.mirror.empty(); }
  [[nodiscard]] bool shines() const { return !scene.mesh.emission.empty(); }
  /// Relative error of numbers off by at most e (bands^2 of the asked degree), albedo 1 assumed in them.
  [[nodiscard]] double error_of(const std::vector<double>& e) const;
  /// RMS over the probe of the relative exit radiance that a part of each vertex's vector makes; parts (vertices of the
  /// probe, bands^2 of the asked degree), without albedo.
  [[nodiscard]] double error_on_probe(const std::vector<float>& parts) const;

 private:
  PlanCost before_;
};

/// Measured numbers are of a probe: they are taken this much larger.
inline constexpr double kProbeMargin = 1.25;

// The decisions, in the order in which they are taken.
void decide_analytic(Draft& draft);
void decide_bounces(Draft& draft);
void decide_channels(Draft& draft);
void decide_bands(Draft& draft);
void decide_symmetry(Draft& draft);
void decide_storage(Draft& draft);
/// What the asked number of directions costs by itself, for the budget to set aside; throws where it is too much.
double floor_of_directions(Draft& draft);
void decide_directions(Draft& draft);

}  // namespace sh::prt
