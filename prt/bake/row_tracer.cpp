#include "prt/bake/row_tracer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>

#include "prt/basis.hpp"

namespace sh::prt {
namespace {

// The shares of receivers in a hit: not negative, with sum 1.
std::array<double, 4> shares_of(const Hit& hit, const ReceiversAt& place) {
  std::array<double, 4> shares = {0.0, std::max(0.0, static_cast<double>(hit.u)),
                                  std::max(0.0, static_cast<double>(hit.v)), 0.0};
  shares[0] = std::max(0.0, 1.0 - shares[1] - shares[2]);
  if (place.count > 3) std::copy(place.part.begin(), place.part.end(), shares.begin());
  const double sum = shares[0] + shares[1] + shares[2] + shares[3];
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace

std::optional<SharedDirections> RaySetup::for_bounces(BakeOptions options) {
  const int fewer = options.fewer_for_bounces();
  if (fewer == 0) return std::nullopt;
  options.directions = fewer;
  options.degree = 0;
  return SharedDirections(options);
}

void RowTracer::follow(Gatherer& gatherer, std::size_t vertex) {
  const std::vector<BlockedRay>& closest = gatherer.closest_hits();
  met_ = closest;
  if (!setup_.mirrors.any()) return;
  legs_.clear();
  for (std::uint32_t i = 0; i < closest.size(); ++i) {
    legs_.push_back({setup_.starts[vertex].origin, closest[i].direction, closest[i].hit, i});
  }
  setup_.mirrors.follow(legs_);
  sky_.clear();
  cut_ = 0.0;
  for (const Leg& leg : legs_) {
    const double part = closest[leg.ray].part * static_cast<double>(leg.throughput.x());
    cut_ += leg.is_cut ? part : 0.0;
    if (leg.mirrors > 0) (leg.hit.face == Hit::kNothing ? sky_ : met_).push_back({leg.direction, leg.hit, part});
  }
}

float RowTracer::add_sky(int degree, float* transfer) const {
  double whole = 0.0;
  for (const BlockedRay& ray : sky_) {
    add_basis(degree, ray.direction.x(), ray.direction.y(), ray.direction.z(), static_cast<float>(ray.part), transfer);
    whole += ray.part;
  }
  return static_cast<float>(whole);
}

FormFactorRow RowTracer::row(std::size_t vertex) {
  const Mesh& mesh = setup_.mesh;
  if (apart_) {
    apart_->gather(vertex);
    follow(*apart_, vertex);
  }
  sums_.resize(mesh.positions.size(), 0.0);
  FormFactorRow row;
  for (const BlockedRay& ray : met_) {
    if (ray.hit.face == Hit::kNothing) continue;  // it just misses the face that the shadow ray hit; the light is lost
    if (ray.hit.from_behind) continue;
    const ReceiversAt place = setup_.receivers.at(ray.hit);
    const std::array<double, 4> shares = shares_of(ray.hit, place);
    for (std::size_t k = 0; k < place.count; ++k) {
      if (!(shares[k] > 0.0)) continue;
      double& sum = sums_[place.receiver[k]];
      if (sum == 0.0) row.push_back({place.receiver[k], 0.0});
      sum += ray.part * shares[k];
    }
  }
  for (FormFactor& factor : row) {
    factor.weight = sums_[factor.vertex];
    sums_[factor.vertex] = 0.0;
  }
  return row;
}

RowMaker make_row_maker(const RaySetup& setup) {
  return [tracer = std::make_shared<RowTracer>(setup)](std::size_t vertex) {
    if (!tracer->has_own_directions()) {
      tracer->gatherer().gather(vertex);
      tracer->meet(vertex);
    }
    return tracer->row(vertex);
  };
}

}  // namespace sh::prt
