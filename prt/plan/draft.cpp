#include "prt/plan/draft.hpp"

#include <algorithm>
#include <cmath>

#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

Draft::Draft(const Scene& the_scene, const std::string& the_instruction_set)
    : scene(the_scene),
      instruction_set(the_instruction_set),
      options(scene.plan),
      asked(scene.bake),
      bake(asked),
      starts(ray_starts(scene.mesh)) {
  for (const Eigen::Vector3f& color : scene.mesh.albedo) albedo = std::max(albedo, color.maxCoeff());
  plan.open.assign(starts.size(), asked.kind->traces_rays() ? 0 : 1);
  start();
}

void Draft::start() { plan.asked = plan.planned = before_ = cost(); }

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

std::size_t Draft::traced() const { return std::count(plan.open.begin(), plan.open.end(), 0); }

double Draft::relative(double product, double factor) const {
  return factor * static_cast<double>(albedo) * product / plan.reference;
}

double Draft::error_of(const std::vector<double>& e) const {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, light->largest_product_of_errors(c, e));
  return relative(largest);
}

ProbeRows Draft::trace_probe(int directions) const {
  BakeOptions fewer = asked;
  fewer.directions = directions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::uint32_t> traced;
  std::vector<std::size_t> places;  // of the traced vertices in the probe
  for (const std::uint32_t v : probe) {
    if (plan.open[v] == 0) {
      traced.push_back(v);
      places.push_back(normals.size());
    }
    normals.push_back(scene.mesh.normals[v]);
  }
  ProbeRows found{unshadowed_transfer(asked.degree, normals), std::vector<double>(probe.size(), 0.0)};
  const std::size_t length = coefficient_count(asked.degree);
  gather_all(scene.mesh, starts, *tracer, SharedDirections(fewer), traced,
             [&](Gatherer& /*gatherer*/, const Gathered& seen, std::size_t i) {
               control_with_unshadowed(seen, length, found.transfer.data() + places[i] * length);
               found.blocked[places[i]] = 1.0 - static_cast<double>(seen.fraction());
             });
  return found;
}

double Draft::error_on_probe(const std::vector<float>& parts) const {
  const std::size_t length = light->coefficients().bands_squared();
  std::vector<double> errors;
  for (std::size_t k = 0; k < probe.size(); ++k) {
    const float* row = parts.data() + k * length;
    const std::vector<double> part(row, row + length);
    double largest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto own = static_cast<double>(scene.mesh.albedo[probe[k]][c]);
      largest = std::max(largest, own * light->largest_product(c, part));
    }
    errors.push_back(largest / plan.reference);
  }
  return rms(errors);
}

double rms(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return values.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace sh::prt
