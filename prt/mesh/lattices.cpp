// Smooth shapes over a lattice of two parameters: hills, and the wing of a glider.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "prt/mesh/primitives.hpp"

namespace sh::prt {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Lattice {
  int columns;  // steps of u
  int rows;     // steps of v
};

// Adds point(u, v), u and v from 0 to 1; u to the right and v up as seen from outside, or the reverse if `turned`. Normals
// come from differences of the surface.
template <class Point>
void add_surface(Soup& soup, const Lattice& lattice, bool turned, const Point& point) {
  constexpr float kStep = 1e-3F;
  const auto first = static_cast<std::uint32_t>(soup.positions.size());
  for (int row = 0; row <= lattice.rows; ++row) {
    for (int column = 0; column <= lattice.columns; ++column) {
      const float u = static_cast<float>(column) / static_cast<float>(lattice.columns);
      const float v = static_cast<float>(row) / static_cast<float>(lattice.rows);
      const auto inside = [](float x) { return std::clamp(x, 2.0F * kStep, 1.0F - 2.0F * kStep); };
      const float a = inside(u);
      const float b = inside(v);
      const Eigen::Vector3f across = point(a + kStep, b) - point(a - kStep, b);
      const Eigen::Vector3f up = point(a, b + kStep) - point(a, b - kStep);
      soup.positions.emplace_back(point(u, v).template cast<double>());
      soup.normals.push_back((turned ? up.cross(across) : across.cross(up)).normalized());
      soup.texture.emplace_back(u, v);
    }
  }
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const auto& p = soup.positions;
    if (p[i] != p[j] && p[j] != p[k] && p[i] != p[k]) soup.faces.push_back({i, turned ? k : j, turned ? j : k});
  };
  const auto width = static_cast<std::uint32_t>(lattice.columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(lattice.rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      const std::uint32_t at = first + row * width + column;
      add(at, at + 1, at + 1 + width);
      add(at, at + 1 + width, at + width);
    }
  }
}

// Waves in several directions whose heights add up to at most 1/8.
float hill_height(float x, float y) {
  struct Wave {
    float x, y, phase, height;
  };
  constexpr Wave kWaves[] = {{1.3F, 0.4F, 0.7F, 0.05F},
                             {-0.9F, 1.7F, 2.1F, 0.0375F},
                             {2.9F, 2.3F, 4.0F, 0.025F},
                             {3.7F, -4.1F, 1.2F, 0.0125F}};
  float height = 0.0F;
  for (const Wave& wave : kWaves) height += wave.height * std::sin(2.0F * kPi * (wave.x * x + wave.y * y) + wave.phase);
  return height;
}

// The sail: nose at +x, tips at -x and +-y; two bulging panels on both sides of the keel. u runs along the chord from
// the front edge, v from one tip to the other. side: 1 for the upper face, -1 for the lower; both meet at the edges.
Eigen::Vector3f sail(float u, float v, float side) {
  constexpr float kKeel = 0.65F;  // length
  constexpr float kBulge = 0.06F;
  constexpr float kRise = 0.06F;  // of the tips
  constexpr float kThickness = 0.012F;
  const float span = 2.0F * v - 1.0F;
  const float out = std::abs(span);
  const float front = 0.5F - out;
  const float chord = kKeel * (1.0F - out);
  const float bulge = 16.0F * kBulge * out * (1.0F - out) * u * (1.0F - u);
  const float half = 4.0F * kThickness * u * (1.0F - u) * (1.0F - out * out);
  return {front - u * chord, 0.5F * span, kRise * out + bulge + side * half};
}

}  // namespace

Soup make_hills(int segments) {
  Soup soup;
  add_surface(soup, {segments, segments}, false,
              [](float u, float v) { return Eigen::Vector3f(u - 0.5F, v - 0.5F, hill_height(u, v)); });
  return soup;
}

Soup make_wing(int segments) {
  Soup soup;
  const Lattice lattice{(segments + 2) / 3, 2 * ((segments + 1) / 2)};  // the keel is on a row
  for (const float side : {1.0F, -1.0F}) {
    add_surface(soup, lattice, side > 0.0F, [side](float u, float v) { return sail(u, v, side); });
  }
  return soup;
}

}  // namespace sh::prt
