#include "prt/bake/trace_form_factors.hpp"

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "prt/bake/mirror_light.hpp"
#include "prt/mesh/corner_angle.hpp"

namespace sh::prt {

FormFactorRow RowMerger::merge(const std::vector<BlockedRay>& closest) {
  touched_.clear();
  for (const BlockedRay& ray : closest) {
    if (ray.hit.face == Hit::kNothing) {  // it just misses the face that the shadow ray hit; the light is lost
      continue;
    }
    const Face& face = mesh_.faces[ray.hit.face];
    if (face_normal(mesh_.positions, face).dot(ray.direction) >= 0.0F) continue;
    const auto u = static_cast<double>(ray.hit.u);
    const auto v = static_cast<double>(ray.hit.v);
    const std::array<double, 3> corners = {1.0 - u - v, u, v};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(corners[k] > 0.0)) continue;
      double& sum = sums_[face[k]];
      if (sum == 0.0) touched_.push_back(face[k]);
      sum += ray.part * corners[k];
    }
  }
  FormFactorRow row;
  row.reserve(touched_.size());
  for (const std::uint32_t vertex : touched_) {
    row.push_back({vertex, static_cast<float>(sums_[vertex])});
    sums_[vertex] = 0.0;
  }
  return row;
}

RowMaker make_row_maker(const Mesh& mesh, const std::vector<RayStart>& starts, const SharedDirections& directions,
                        const Tracer& tracer, const MirrorPaths& mirrors) {
  const auto gatherer = std::make_shared<Gatherer>(directions, tracer);
  const auto merger = std::make_shared<RowMerger>(mesh);
  const auto light = mirrors.any() ? std::make_shared<MirrorLight>(mirrors) : nullptr;
  return [&mesh, &starts, gatherer, merger, light](std::size_t v) {
    gatherer->gather(starts[v].origin, mesh.normals[v], mesh.geometric_normals[v]);
    const std::vector<BlockedRay>& closest = gatherer->closest_hits();
    return merger->merge(light != nullptr ? light->follow(starts[v].origin, closest) : closest);
  };
}

}  // namespace sh::prt
