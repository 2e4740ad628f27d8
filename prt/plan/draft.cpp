#include "prt/plan/draft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/plan/views.hpp"

namespace sh::prt {

Draft::Draft(const Scene& the_scene, const std::string& the_instruction_set)
    : scene(the_scene),
      instruction_set(the_instruction_set),
      options(scene.plan),
      asked(scene.bake),
      bake(asked),
      starts(ray_starts(scene.mesh)),
      clusters(options.mode != PlanMode::kLossy ? asked.compress : ClusterCounts()) {
  for (const Eigen::Vector3f& color : scene.mesh.albedo) albedo = std::max(albedo, color.maxCoeff());
  if (asked.kind->is_glossy()) albedo = largest_reflectance(scene.mesh);
  plan.open.assign(starts.size(), asked.kind->traces_rays() ? 0 : 1);
  for (std::size_t v = 0; v < starts.size(); ++v) {
    const auto angle = static_cast<double>(angle_between(scene.mesh.normals[v], scene.mesh.geometric_normals[v]));
    upward_.push_back(asked.kind->is_glossy()             ? 0.5
                      : asked.sampler == Sampler::kCosine ? (1.0 + std::cos(angle)) / 4.0
                                                          : (1.0 - angle / std::numbers::pi) / 2.0);
  }
  start();
}

void Draft::start() {
  correction_ = 1.0;
  if (measurement) {
    const auto directions = static_cast<double>(bake.directions);
    const double expected = static_cast<double>(cost().rays) / directions;
    if (expected > 0.0) correction_ = measurement->rays_a_direction() / expected;
  }
  plan.asked = plan.planned = before_ = cost();
}

void Draft::take_reference() {
  many = measurement->rows(measurement->reference_options(asked));
  reference = measurement->own_radiances(many, traced_shape());
}

bool Draft::allows(std::string_view name) const {
  return std::find(options.without.begin(), options.without.end(), name) == options.without.end();
}

void Draft::decide(std::string_view name, std::string choice, std::string why, double error, std::string_view basis) {
  const PlanCost after = cost();
  plan.record.decisions.push_back({std::string(name), std::move(choice), std::move(why), before_.bytes - after.bytes,
                                   before_.rays - after.rays, error, std::string(basis)});
  plan.record.error += error;
  before_ = plan.planned = after;
  left -= error;
}

// A bake traces the directions above the horizons of both normals, and once more those that are blocked, if their closest
// hits matter. Bounces may have directions of their own; those between lobes trace theirs again.
PlanCost Draft::cost() const {
  const int fewer = bake.fewer_for_bounces();
  const bool always = (bake.kind->has_form_factors() && fewer == 0) || has_mirrors();
  const int apart = bake.kind->stores_matrices() && fewer == 0 ? bake.directions : fewer;
  double rays = 0.0;
  for (std::size_t v = 0; v < starts.size(); ++v) {
    if (plan.open[v] != 0 || !keeps(v)) continue;
    const double again = measurement ? 1.0 + measurement->blocked(v) : 1.0;
    const bool all_again = measurement && (always || measurement->is_nearly_dark(v));
    rays += upward_[v] * (static_cast<double>(bake.directions) * (all_again ? again : 1.0) + apart * again);
  }
  return {static_cast<std::int64_t>(stored_shape(clusters).stored_bytes(receivers())),
          std::llround(correction_ * rays)};
}

TransferShape Draft::shape() const {
  TransferShape shape = bake.kind->shape(bake.degree);
  shape.storage = plan.storage;
  return bake.kind->stores_visibility() ? with_bands(shape, bake.keep) : shape;
}

RowShape Draft::stored_shape(ClusterCounts counts) const {
  RowShape stored(*bake.kind, scene.mesh, bake.degree);
  if (stored.matrices) stored.matrices = with_bands(*stored.matrices, bake.keep);
  stored.numbers = shape();
  if (counts.clusters == 0) return stored;
  Element& element = stored.numbers.storage.element;
  if (!stored.matrices || element == Element::kSingle) element = Element::kHalf;
  TransferShape& rows = stored.matrices ? *stored.matrices : stored.numbers;
  rows.storage.clusters = static_cast<std::uint32_t>(std::min<std::size_t>(counts.clusters, receivers()));
  rows.storage.vectors = static_cast<std::uint32_t>(std::min<std::size_t>(counts.vectors, rows.length()));
  return stored;
}

std::size_t Draft::receivers() const {
  return plan.receivers.empty() ? starts.size() : std::count(plan.receivers.begin(), plan.receivers.end(), 1);
}

std::size_t Draft::traced() const {
  std::size_t count = 0;
  for (std::size_t v = 0; v < starts.size(); ++v) count += plan.open[v] == 0 && keeps(v) ? 1 : 0;
  return count;
}

double Draft::relative(double product) const { return static_cast<double>(albedo) * product / plan.reference; }

double Draft::gain() const {
  return asked.kind->has_bounces() ? 1.0 / std::max(1.0 - static_cast<double>(albedo), 1e-9) : 1.0;
}

BakeOptions Draft::along(int directions) const {
  BakeOptions other = bake;
  other.directions = directions;
  if (bounce_part > 1) other.bounces.directions = bounces_along(directions);
  return other;
}

int Draft::bounces_along(int directions) const {
  constexpr int kLeast = 16;
  constexpr int kOfCoefficient = 4;  // between lobes; fewer would see light that is not there
  const auto coefficients = static_cast<int>(coefficient_count(bake.degree));
  const int least = bake.kind->stores_matrices() ? kOfCoefficient * coefficients : kLeast;
  const int few = std::max(least, directions / bounce_part);
  return asked.bounces.directions > 0 ? std::min(few, asked.bounces.directions) : few;
}

int Draft::fewest_directions_within_limit() const {
  return fewest_directions([this](int directions) { return error_along(directions); }, asked.directions, options.error);
}

double Draft::blocked() const {
  double sum = 0.0;
  for (std::size_t v = 0; v < starts.size(); ++v) sum += measurement->blocked(v);
  return sum / static_cast<double>(starts.size());
}

double Draft::error_along(int directions) const {
  const auto radiances = [&](const std::vector<float>& rows, const RowShape& shape) {
    return measurement->radiances(rows, shape);
  };
  const std::vector<float> rows = measurement->rows(along(directions), plan.open);
  Measurement::Radiances error = radiances(measurement->kept(rows, row_shape()), row_shape());
  if (!allows("directions")) {
    BakeOptions same = asked;
    same.directions = directions;
    const Measurement::Radiances whole =
        measurement->own_radiances(measurement->rows(same), {*asked.kind, scene.mesh, asked.degree});
    for (std::size_t i = 0; i < error.size(); ++i) error[i] -= whole[i];
    return measurement->error(error) + loosened + room_for_clusters;
  }
  const double spread = bake.kind->has_bounces() ? measurement->spread() : 1.0;
  const Measurement::Radiances sampled = radiances(rows, traced_shape());
  const Measurement::Radiances converged = radiances(many, traced_shape());
  Measurement::Radiances sampling(error.size());
  for (std::size_t i = 0; i < error.size(); ++i) {
    sampling[i] = spread * (sampled[i] - converged[i]);
    error[i] += sampling[i] - sampled[i] + converged[i] - reference[i];
  }
  return measurement->error(error) + error_of_reference(directions, measurement->error(sampling)) + loosened +
         room_for_clusters;
}

double Draft::error_of_reference(int directions, double error) const {
  constexpr double kRate = 0.5;  // that of random directions; the other sets converge faster
  const double many_directions = measurement->reference_options(asked).directions;
  return std::max(unconverged, error * std::pow(directions / many_directions, kRate));
}

double Draft::error_of(const std::vector<double>& e) const {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, light->largest_product_of_errors(c, e));
  return relative(largest);
}

}  // namespace sh::prt
