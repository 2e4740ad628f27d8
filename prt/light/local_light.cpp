#include "prt/light/local_light.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "prt/light/cap_light.hpp"
#include "prt/light/polygon_light.hpp"
#include "prt/light/project.hpp"

namespace sh::prt {
namespace {

bool is_near(const Light& light) { return light.spec.near || light.spec.type == LightType::kPolygon; }

Light sphere_from(const Light& light, const Eigen::Vector3d& point) {
  const NearSphere& sphere = *light.spec.near;
  const Eigen::Vector3d towards = light.rotation * sphere.centre - (point - light.spec.from);
  if (!(towards.norm() > sphere.radius)) {
    throw std::runtime_error(
        fmt::format("the light is sampled at ({:.4g}, {:.4g}, {:.4g}), inside a sphere light of radius {:.4g}; near "
                    "lights must stay "
                    "outside of the mesh",
                    point.x(), point.y(), point.z(), sphere.radius));
  }
  Light out = light;
  out.rotation.setIdentity();
  out.spec.direction = towards.normalized();
  out.spec.one_minus_cos =
      std::max(sphere_one_minus_cos(sphere.radius, towards.norm()), std::numeric_limits<double>::min());
  return out;
}

std::optional<Light> polygon_from(const Light& light, const Eigen::Vector3d& point) {
  Light out = light;
  out.rotation.setIdentity();
  for (Eigen::Vector3d& corner : out.spec.corners) corner = light.rotation * corner - (point - light.spec.from);
  return polygon_flaw(out.spec.corners).empty() ? std::optional<Light>(out) : std::nullopt;
}

}  // namespace

bool varies(const std::vector<Light>& lights) { return std::any_of(lights.begin(), lights.end(), is_near); }

std::vector<Light> seen_from(const std::vector<Light>& lights, const Eigen::Vector3d& point) {
  std::vector<Light> out;
  for (const Light& light : lights) {
    if (light.spec.near) {
      out.push_back(sphere_from(light, point));
    } else if (!is_near(light)) {
      out.push_back(light);
    } else if (std::optional<Light> polygon = polygon_from(light, point)) {
      out.push_back(std::move(*polygon));
    }
  }
  return out;
}

std::vector<LightCoefficients> project_at(const std::vector<Light>& lights, const std::vector<Eigen::Vector3d>& points,
                                          int degree) {
  std::vector<Light> far;
  std::vector<Light> near;
  for (const Light& light : lights) (is_near(light) ? near : far).push_back(light);
  const LightCoefficients background = project(far, degree);  // projects pictures once, not for each point
  std::vector<LightCoefficients> out;
  for (const Eigen::Vector3d& point : points) {
    LightCoefficients sum = background;
    accumulate(sum, project(seen_from(near, point), degree));
    out.push_back(std::move(sum));
  }
  return out;
}

}  // namespace sh::prt
