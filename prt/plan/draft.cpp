#include "prt/plan/draft.hpp"

#include <algorithm>
#include <cmath>

#include "prt/light/light_coefficients.hpp"

namespace sh::prt {

Draft::Draft(const Scene& the_scene, const PlanOptions& the_options)
    : scene(the_scene), options(the_options), asked(the_scene.bake), bake(asked) {
  starts = ray_starts(scene.mesh);
  for (const Eigen::Vector3f& colour : scene.mesh.albedo) albedo = std::max(albedo, colour.maxCoeff());
  plan.open.assign(starts.size(), asked.kind->traces_rays() ? 0 : 1);
  start();
}

void Draft::start() { plan.asked = plan.planned = before_ = cost(); }

bool Draft::takes(std::string_view name) {
  if (std::find(options.without.begin(), options.without.end(), name) == options.without.end()) return true;
  decide(name, "not taken", "by request", 0.0, "exact");
  return false;
}

void Draft::decide(std::string_view name, std::string choice, std::string why, double error, std::string_view basis) {
  const PlanCost after = cost();
  plan.record.decisions.push_back({std::string(name), std::move(choice), std::move(why), before_.bytes - after.bytes,
                                   before_.rays - after.rays, error, std::string(basis)});
  plan.record.error += error;
  before_ = plan.planned = after;
  left -= error;
}

PlanCost Draft::cost() const {
  const double upward = bake.sampler == Sampler::kCosine ? 1.0 : 0.5;
  const double rays = static_cast<double>(traced()) * static_cast<double>(bake.directions) * upward;
  return {static_cast<std::int64_t>(starts.size() * shape().stored_bytes()),
          std::llround(rays * (bake.kind->has_bounces() ? 1.0 + mean_blocked : 1.0))};
}

TransferShape Draft::shape() const {
  TransferShape shape = bake.kind->shape(bake.degree);
  shape.storage = plan.storage;
  return shape;
}

std::size_t Draft::traced() const {
  return static_cast<std::size_t>(std::count(plan.open.begin(), plan.open.end(), std::uint8_t{0}));
}

double Draft::error_of(const std::vector<double>& e) const {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, light->largest_product_of_errors(c, e));
  return static_cast<double>(albedo) * largest / plan.reference;
}

double Draft::error_on_probe(const std::vector<float>& parts) const {
  const std::size_t length = light->coefficients().bands_squared();
  std::vector<double> errors;
  std::vector<double> part(length);
  for (std::size_t k = 0; k < probe->vertices().size(); ++k) {
    std::copy_n(parts.begin() + static_cast<std::ptrdiff_t>(k * length), length, part.begin());
    double largest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float own = scene.mesh.albedo[probe->vertices()[k]][static_cast<Eigen::Index>(c)];
      largest = std::max(largest, static_cast<double>(own) * light->largest_product(c, part));
    }
    errors.push_back(largest / plan.reference);
  }
  return rms(errors);
}

}  // namespace sh::prt
