#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "prt/mesh/primitives.hpp"

namespace sh::prt {

namespace {

std::uint32_t add_vertex(Soup& soup, const Eigen::Vector3f& position, const Eigen::Vector3f& normal) {
  soup.positions.emplace_back(position.cast<double>());
  soup.normals.push_back(normal);
  return static_cast<std::uint32_t>(soup.positions.size() - 1);
}

// The quadrilateral a b c d of vertices as two faces; a corner that coincides with the next one leaves one face.
void add_faces(Soup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const auto differ = [&](std::uint32_t i, std::uint32_t j) { return soup.positions[i] != soup.positions[j]; };
  if (differ(a, b)) soup.faces.push_back({a, b, c});
  if (differ(c, d)) soup.faces.push_back({a, c, d});
}

Eigen::Vector3f upright(const Eigen::Vector2f& point, float y) { return {point.x(), y, point.y()}; }

}  // namespace

void add_quad(Soup& soup, const std::array<Eigen::Vector3f, 4>& corners) {
  const Eigen::Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  std::array<std::uint32_t, 4> v{};
  for (std::size_t k = 0; k < 4; ++k) {
    v[k] = add_vertex(soup, corners[k], normal);
    soup.texture.emplace_back(k == 1 || k == 2 ? 1.0F : 0.0F, k >= 2 ? 1.0F : 0.0F);
  }
  add_faces(soup, v[0], v[1], v[2], v[3]);
}

Soup surface_of_revolution(int segments, const std::vector<Curve>& curves) {
  Soup soup;
  const auto turned = [&](const Curve& curve, std::size_t i, int segment) {
    const RingPoint& point = curve[i];
    soup.texture.emplace_back(static_cast<float>(segment) / static_cast<float>(segments),
                              static_cast<float>(i) / static_cast<float>(curve.size() - 1));
    const float angle =
        2.0F * std::numbers::pi_v<float> * static_cast<float>(segment % segments) / static_cast<float>(segments);
    // Points on the axis coincide to the bit.
    const float radius = point.radius < 1e-6F ? 0.0F : point.radius;
    const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0.0F);
    return add_vertex(soup, radius * out + point.z * Eigen::Vector3f::UnitZ(),
                      (point.normal_radius * out + point.normal_z * Eigen::Vector3f::UnitZ()).normalized());
  };
  for (const Curve& curve : curves) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      for (int segment = 0; segment < segments; ++segment) {
        const std::uint32_t a = turned(curve, i - 1, segment);
        const std::uint32_t b = turned(curve, i - 1, segment + 1);
        const std::uint32_t c = turned(curve, i, segment + 1);
        const std::uint32_t d = turned(curve, i, segment);
        add_faces(soup, a, b, c, d);
      }
    }
  }
  return soup;
}

Soup extrude(const Profile& profile) {
  Soup soup;
  for (const float y : {-0.5F, 0.5F}) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const Eigen::Vector2f& point : profile.points) {
      add_vertex(soup, upright(point, y), {0.0F, y > 0.0F ? 1.0F : -1.0F, 0.0F});
    }
    for (const Face& t : profile.triangles) {
      // Seen from -y the outline runs counterclockwise with x to the right and z up.
      soup.faces.push_back(y < 0.0F ? Face{t[0] + first, t[1] + first, t[2] + first}
                                    : Face{t[0] + first, t[2] + first, t[1] + first});
    }
  }
  for (std::size_t i = 0; i < profile.points.size(); ++i) {
    const Eigen::Vector2f& p = profile.points[i];
    const Eigen::Vector2f& q = profile.points[(i + 1) % profile.points.size()];
    const Eigen::Vector2f flat = Eigen::Vector2f(q.y() - p.y(), p.x() - q.x()).normalized();
    std::array<Eigen::Vector2f, 2> normals = {flat, flat};
    if (!profile.edge_normals.empty() && profile.edge_normals[i][0].norm() > 0.0F) normals = profile.edge_normals[i];
    const std::uint32_t a = add_vertex(soup, upright(p, -0.5F), upright(normals[0], 0.0F));
    const std::uint32_t b = add_vertex(soup, upright(p, 0.5F), upright(normals[0], 0.0F));
    const std::uint32_t c = add_vertex(soup, upright(q, 0.5F), upright(normals[1], 0.0F));
    const std::uint32_t d = add_vertex(soup, upright(q, -0.5F), upright(normals[1], 0.0F));
    add_faces(soup, a, b, c, d);
  }
  return soup;
}

}  // namespace sh::prt
