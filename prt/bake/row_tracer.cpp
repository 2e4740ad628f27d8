#include "prt/bake/row_tracer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>

#include "prt/basis.hpp"
#include "prt/mesh/corners.hpp"

namespace sh::prt {
namespace {

// The shares of the corners in a hit: not negative, with sum 1.
std::array<double, 3> barycentric(const Hit& hit) {
  const double u = std::max(0.0, static_cast<double>(hit.u));
  const double v = std::max(0.0, static_cast<double>(hit.v));
  const double rest = std::max(0.0, 1.0 - u - v);
  const double sum = rest + u + v;
  return {rest / sum, u / sum, v / sum};
}

}  // namespace

void RowTracer::meet(std::size_t vertex) {
  const std::vector<BlockedRay>& closest = gatherer_.closest_hits();
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

FormFactorRow RowTracer::row() {
  const Mesh& mesh = setup_.mesh;
  FormFactorRow row;
  for (const BlockedRay& ray : met_) {
    if (ray.hit.face == Hit::kNothing) continue;  // it just misses the face that the shadow ray hit; the light is lost
    const Face& face = mesh.faces[ray.hit.face];
    if (face_normal(mesh.positions, face).dot(ray.direction) >= 0.0F) continue;
    const std::array<double, 3> corners = barycentric(ray.hit);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(corners[k] > 0.0)) continue;
      double& sum = sums_[face[k]];
      if (sum == 0.0) row.push_back({face[k], 0.0});
      sum += ray.part * corners[k];
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
    tracer->gatherer().gather(vertex);
    tracer->meet(vertex);
    return tracer->row();
  };
}

}  // namespace sh::prt
