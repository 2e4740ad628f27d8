#include "prt/mesh/primitives.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sh::prt {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSteps = 5;  // of the stairs

Soup make_plane(int /*segments*/) {
  Soup soup;
  add_quad(soup, {{{-0.5F, -0.5F, 0.0F}, {0.5F, -0.5F, 0.0F}, {0.5F, 0.5F, 0.0F}, {-0.5F, 0.5F, 0.0F}}});
  return soup;
}

Soup make_box(int /*segments*/) {
  Soup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5F, 0.5F}) {
      std::array<Eigen::Vector3f, 4> corners;
      for (std::size_t k = 0; k < 4; ++k) {
        Eigen::Vector3f& corner = corners[side > 0.0F ? k : 3 - k];
        corner[axis] = side;
        corner[(axis + 1) % 3] = k == 1 || k == 2 ? 0.5F : -0.5F;
        corner[(axis + 2) % 3] = k >= 2 ? 0.5F : -0.5F;
      }
      add_quad(soup, corners);
    }
  }
  return soup;
}

Soup make_sphere(int segments) {
  const int steps = segments / 2;
  Curve curve;
  for (int step = 0; step <= steps; ++step) {
    const float polar = kPi * (1.0F - static_cast<float>(step) / static_cast<float>(steps));
    curve.push_back({0.5F * std::sin(polar), 0.5F * std::cos(polar), std::sin(polar), std::cos(polar)});
  }
  return surface_of_revolution(segments, {curve});
}

Soup make_torus(int segments) {
  constexpr float kTube = 0.14F;
  const int steps = segments / 2;
  Curve curve;
  for (int step = 0; step < steps; ++step) {
    const float angle = 2.0F * kPi * (static_cast<float>(step) / static_cast<float>(steps));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    curve.push_back({0.5F - kTube + kTube * c, kTube * s, c, s});
  }
  curve.push_back(RingPoint(curve.front()));
  return surface_of_revolution(segments, {curve});
}

Soup make_cylinder(int segments) {
  const Curve bottom = {{0.0F, -0.5F, 0.0F, -1.0F}, {0.5F, -0.5F, 0.0F, -1.0F}};
  const Curve side = {{0.5F, -0.5F, 1.0F, 0.0F}, {0.5F, 0.5F, 1.0F, 0.0F}};
  const Curve top = {{0.5F, 0.5F, 0.0F, 1.0F}, {0.0F, 0.5F, 0.0F, 1.0F}};
  return surface_of_revolution(segments, {bottom, side, top});
}

// A cylinder with a hole; its sides are smooth, its edges sharp.
Soup make_ring(int segments) {
  constexpr float kInner = 0.43F;
  const Curve bottom = {{kInner, -0.5F, 0.0F, -1.0F}, {0.5F, -0.5F, 0.0F, -1.0F}};
  const Curve outside = {{0.5F, -0.5F, 1.0F, 0.0F}, {0.5F, 0.5F, 1.0F, 0.0F}};
  const Curve top = {{0.5F, 0.5F, 0.0F, 1.0F}, {kInner, 0.5F, 0.0F, 1.0F}};
  const Curve inside = {{kInner, 0.5F, -1.0F, 0.0F}, {kInner, -0.5F, -1.0F, 0.0F}};
  return surface_of_revolution(segments, {bottom, outside, top, inside});
}

Soup make_cone(int segments) {
  const float slope = 1.0F / std::sqrt(5.0F);
  const Curve bottom = {{0.0F, -0.5F, 0.0F, -1.0F}, {0.5F, -0.5F, 0.0F, -1.0F}};
  const Curve side = {{0.5F, -0.5F, 2.0F * slope, slope}, {0.0F, 0.5F, 2.0F * slope, slope}};
  return surface_of_revolution(segments, {bottom, side});
}

Soup make_stairs(int /*segments*/) {
  Profile profile;
  profile.points.emplace_back(-0.5F, -0.5F);
  profile.points.emplace_back(0.5F, -0.5F);
  for (int step = kSteps; step > 0; --step) {
    const float height = static_cast<float>(step) / kSteps - 0.5F;
    profile.points.emplace_back(static_cast<float>(step) / kSteps - 0.5F, height);
    profile.points.emplace_back(static_cast<float>(step - 1) / kSteps - 0.5F, height);
  }
  // Every tread and the riser below it see the lower right corner.
  const auto count = static_cast<std::uint32_t>(profile.points.size());
  for (std::uint32_t i = 2; i + 1 < count; ++i) profile.triangles.push_back({1, i, i + 1});
  profile.triangles.push_back({1, count - 1, 0});
  return extrude(profile);
}

// A slab with a round-headed opening: its half-circle has radius 0.3 about the middle of the slab.
Soup make_arch(int segments) {
  constexpr float kRadius = 0.3F;
  Profile profile;
  profile.points = {{-0.5F, 0.5F}, {-0.5F, -0.5F}, {-kRadius, -0.5F}};
  const int sides = segments / 2;
  for (int i = 0; i <= sides; ++i) {
    const float angle = kPi * (1.0F - static_cast<float>(i) / static_cast<float>(sides));
    profile.points.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle) + 0.1F);
  }
  const auto last = static_cast<std::uint32_t>(profile.points.size()) - 1;
  profile.points.insert(profile.points.end(), {{kRadius, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}});
  profile.edge_normals.resize(profile.points.size(), {Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()});
  for (std::uint32_t i = 3; i < last; ++i) {
    const Eigen::Vector2f middle(0.0F, 0.1F);
    profile.edge_normals[i] = {(middle - profile.points[i]).normalized(),
                               (middle - profile.points[i + 1]).normalized()};
  }
  // Legs, then a fan from each upper corner to its half of the opening, then the wedge between them.
  profile.triangles = {{0, 1, 2}, {0, 2, 3}, {last + 3, last, last + 1}, {last + 3, last + 1, last + 2}};
  const std::uint32_t top = 3 + static_cast<std::uint32_t>(sides) / 2;
  for (std::uint32_t i = 3; i < last; ++i) profile.triangles.push_back({i < top ? 0 : last + 3, i, i + 1});
  profile.triangles.push_back({0, top, last + 3});
  return extrude(profile);
}

struct Maker {
  std::string_view name;
  Soup (*make)(int segments);
};

constexpr Maker kMakers[] = {{"arch", make_arch},         {"box", make_box},       {"cone", make_cone},
                             {"cylinder", make_cylinder}, {"hills", make_hills},   {"plane", make_plane},
                             {"ring", make_ring},         {"sphere", make_sphere}, {"stairs", make_stairs},
                             {"torus", make_torus},       {"wing", make_wing}};

}  // namespace

std::vector<std::string_view> primitive_names() {
  std::vector<std::string_view> names;
  for (const Maker& maker : kMakers) names.push_back(maker.name);
  return names;
}

Soup make_primitive(std::string_view name, int segments) {
  for (const Maker& maker : kMakers) {
    if (maker.name != name) continue;
    Soup soup = maker.make(segments);
    soup.albedo.assign(soup.positions.size(), Eigen::Vector3f::Constant(0.5F));
    return soup;
  }
  throw std::invalid_argument(
      fmt::format("primitive {}: expected one of {}", name, fmt::join(primitive_names(), ", ")));
}

}  // namespace sh::prt
