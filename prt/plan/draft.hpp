// A plan in progress: facts about the scene, the decisions so far, and the remaining budget.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prt/plan/bounds.hpp"
#include "prt/plan/measure.hpp"
#include "prt/plan/plan.hpp"

namespace sh::prt {

struct Draft {
  Draft(const Scene& the_scene, const std::string& the_instruction_set);

  const Scene& scene;
  const std::string& instruction_set;
  const PlanOptions& options;
  const BakeOptions& asked;
  BakeOptions bake;  // as lowered by the decisions so far
  std::vector<RayStart> starts;
  float albedo = 0.0F;  // the largest; of glossy kinds the largest reflectance
  Plan plan;
  double left = 0.0;      // of the budget
  double reserved = 0.0;  // part of `left` that is reserved for directions
  bool needs_all_receivers = false;
  // Only set for a plan with a budget:
  std::optional<TurningLight> light;  // of the asked degree
  std::optional<Measurement> measurement;
  std::vector<float> many;           // rows of the probe along many directions, for the current kind
  Measurement::Radiances reference;  // of the probe after the asked bake along many directions
  double unconverged = 0.0;          // error of `reference` itself, as the asked directions tell
  double loosened = 0.0;             // bound on the error of a looser tolerance than asked
  int bounce_part = 1;               // directions of the bake for each that bounces have
  double room_for_clusters = 0.0;    // error that the bake may make by clusters
  ClusterCounts clusters;            // as far as decided: the most that a bake may make

  /// Makes the current request the baseline for savings.
  void start();
  /// Measures the asked bake along many directions, on the probe as it is.
  void take_reference();
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
  /// The shape of rows after the decisions so far, and as a file stores them in so many clusters, if any.
  [[nodiscard]] RowShape row_shape() const { return stored_shape({}); }
  [[nodiscard]] RowShape stored_shape(ClusterCounts counts) const;
  [[nodiscard]] bool keeps(std::size_t vertex) const { return plan.receivers.empty() || plan.receivers[vertex] != 0; }
  [[nodiscard]] std::size_t receivers() const;  // vertices that the bake keeps
  [[nodiscard]] std::size_t traced() const;     // of these, those that need rays
  [[nodiscard]] bool has_mirrors() const { return !scene.mesh.mirror.empty(); }
  [[nodiscard]] bool shines() const { return !scene.mesh.emission.empty(); }
  /// The bound on band l of the numbers after the decisions so far.
  [[nodiscard]] double band_bound(int l) const { return transfer_band_bound(*bake.kind, has_mirrors(), l); }
  /// The same of what a vertex makes of the light: of the vector itself, or of any vector that gains no energy.
  [[nodiscard]] double exit_band_bound(int l) const {
    return bake.kind->is_glossy() ? transfer_band_bound(kInterreflected, true, l) : band_bound(l);
  }
  /// The relative exit radiance that a product of transfer and light causes; the product assumes albedo 1.
  [[nodiscard]] double relative(double product) const;
  /// The relative error if the numbers are off by at most e (bands^2 of the requested degree); e assumes albedo 1.
  [[nodiscard]] double error_of(const std::vector<double>& e) const;
  /// The most that bounces add to an error of direct light, 1 / (1 - largest albedo): no more than all light comes back.
  [[nodiscard]] double gain() const;
  /// The shape of rows along directions: of the current kind, the asked degree and plain storage.
  [[nodiscard]] RowShape traced_shape() const { return {*bake.kind, scene.mesh, asked.degree}; }
  /// The current bake, along other directions.
  [[nodiscard]] BakeOptions along(int directions) const;
  /// The directions of its bounces then.
  [[nodiscard]] int bounces_along(int directions) const;
  /// The stated error of the plan so far with this many directions; that of the directions themselves counts only if the
  /// user does not skip this decision.
  [[nodiscard]] double error_along(int directions) const;
  /// The fewest directions, at most the asked ones, for which that error is within the plan's; the asked ones if none is.
  [[nodiscard]] int fewest_directions_within_limit() const;
  /// The part of the cosine that is blocked, the mean of the vertices.
  [[nodiscard]] double blocked() const;
  /// The error of the reference itself: what remains of that of fewer directions, by the rate at which they converge, or
  /// of the asked ones, if that is more.
  [[nodiscard]] double error_of_reference(int directions, double error) const;

 private:
  PlanCost before_;
  std::vector<double> upward_;  // (vertices) part of the directions that a bake traces
  double correction_ = 1.0;     // of the count of rays, measured
};

// The decisions, in the order in which they are taken.
/// Only where faces were halved and vertices are the receivers (prt/plan/decide_receivers.cpp).
void decide_receivers(Draft& draft);
void decide_analytic(Draft& draft);
void decide_bounces(Draft& draft);
void decide_channels(Draft& draft);
void decide_bands(Draft& draft);
void decide_matrices(Draft& draft);
void decide_visibility(Draft& draft);
void decide_symmetry(Draft& draft);
void decide_storage(Draft& draft);
/// The error that a file makes that keeps the rows so far in this shape, measured.
double measured_error_of(const Draft& draft, const RowShape& stored);
/// The same of an element of the numbers.
double measured_error_of(const Draft& draft, Element element);
/// Only where the scene asks for clusters: makes room for their error, if they take fewer bytes than rows. The bake finds
/// the error of each of the counts.
void decide_clusters(Draft& draft);
/// Fewer directions for the bounces, a part of those for shadows, if the bake then costs less for the same error.
void decide_hits(Draft& draft);
/// The error of the requested number of directions alone, which the budget reserves; throws if it exceeds the budget.
double floor_of_directions(Draft& draft);
/// The fewest directions for which the error is within the limit, `asked` at most: doubled until it is, then between the
/// last two by a power law, rounded up to a multiple of 64. `asked` if no number of them will do.
int fewest_directions(const std::function<double(int directions)>& error_along, int asked, double limit);
void decide_directions(Draft& draft);
/// Replaces the sum of the errors by the stated error of all decisions together, if any of them is measured.
void state_error(Draft& draft);

}  // namespace sh::prt
