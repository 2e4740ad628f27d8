#include "prt/light/light.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "prt/image/environment.hpp"
#include "prt/image/image.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/light/light_shapes.hpp"
#include "prt/say.hpp"

namespace sh::prt {
namespace {

/// The sun as a separate light; the environment keeps the rest. Empty if the picture has no sun.
std::optional<Light> split_sun(Light& environment) {
  SunSearch search = extract_sun(*environment.image, environment.spec.mapping, *environment.spec.extract_sun);
  say(fmt::format("{}: {}", environment.spec.file, search.sun ? describe(*search.sun) : "no sun: " + search.why_none));
  if (!search.sun) return std::nullopt;
  Light sun = environment;
  sun.spec.type = LightType::kCap;
  sun.spec.direction = search.sun->direction;
  sun.spec.one_minus_cos = search.sun->one_minus_cos;
  sun.spec.radiance = (static_cast<double>(environment.spec.scale) * search.sun->radiance).cast<float>();
  sun.image.reset();
  sun.share_of_picture = search.sun->energy_share;
  environment.image = std::make_shared<const Image>(std::move(search.sun->rest));
  return sun;
}

void load_light(const LightSpec& spec, OnFlaw on_flaw, std::vector<Light>& lights) {
  const auto degrees = static_cast<double>(spec.rotation_degrees);
  Light light{spec, rotation_about(spec.rotation_axis.cast<double>(), degrees), {}};
  if (spec.type == LightType::kEnvironment) {
    light.image = std::make_shared<const Image>(read_image(spec.file, on_flaw, spec.color_space));
    require_shape(spec.file, *light.image, spec.mapping);
    std::optional<Light> sun = spec.extract_sun ? split_sun(light) : std::nullopt;
    if (sun) lights.push_back(std::move(*sun));
  }
  lights.push_back(std::move(light));
}

Eigen::Vector3f radiance(const Light& light, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d local = light.rotation.transpose() * direction;
  switch (light.spec.type) {
    case LightType::kConstant:
      return light.spec.radiance;
    case LightType::kCieOvercast:
      return local.z() > 0.0 ? Eigen::Vector3f(light.spec.radiance * static_cast<float>((1.0 + 2.0 * local.z()) / 3.0))
                             : Eigen::Vector3f(Eigen::Vector3f::Zero());
    case LightType::kCieSky:
      return light.spec.radiance * static_cast<float>(sky_radiance(light.spec.sky, light.spec.direction, local));
    case LightType::kDirectional:
      return Eigen::Vector3f::Zero();  // nowhere but in one direction
    case LightType::kCap:
      return light.spec.radiance * (cap_covers(light.spec.direction, light.spec.one_minus_cos, local) ? 1.0F : 0.0F);
    case LightType::kPolygon:
      return light.spec.radiance * (polygon_covers(light.spec.corners, local) ? 1.0F : 0.0F);
    case LightType::kEnvironment:
      return light.spec.scale * lookup(*light.image, light.spec.mapping, local);
    case LightType::kCoefficients:
      return radiance(light.spec.coefficients, local).cast<float>();
  }
  return Eigen::Vector3f::Zero();
}

bool is_near(const Light& light) { return light.spec.near || light.spec.type == LightType::kPolygon; }

Light sphere_from(const Light& light, const Eigen::Vector3d& point) {
  const NearSphere& sphere = *light.spec.near;
  const Eigen::Vector3d towards = light.rotation * sphere.center - (point - light.spec.from);
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

std::vector<Light> load_lights(const std::vector<LightSpec>& specs, OnFlaw on_flaw) {
  std::vector<Light> lights;
  lights.reserve(specs.size());
  for (const LightSpec& spec : specs) load_light(spec, on_flaw, lights);
  return lights;
}

std::vector<Light> turned(const std::vector<Light>& lights, const Eigen::Matrix3d& r) {
  std::vector<Light> out = lights;
  for (Light& light : out) light.rotation = r * light.rotation;
  return out;
}

Eigen::Vector3f radiance(const std::vector<Light>& lights, const Eigen::Vector3d& direction) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const Light& light : lights) sum += radiance(light, direction);
  return sum;
}

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
