// See sphere_nodes.hpp.
#include "numeric/sampling/sphere_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "numeric/oracle/require.hpp"
#include "numeric/sampling/directions.hpp"
#include "numeric/sampling/random.hpp"
#include "numeric/sampling/solid_angle.hpp"

namespace sh::numeric {
namespace {

constexpr double kPi = std::numbers::pi;
using Nodes = std::vector<SphereNode<double>>;

// No nodes yet, where factor * value * value of them (or factor * value, for power 1) are not too many.
Nodes nodes_for(const std::string& argument, int value, std::int64_t factor, int power = 2) {
  const std::int64_t most = kMaxSphereNodes / factor;
  const auto limit = static_cast<double>(most);
  require_range(argument, value, 1, static_cast<long>(power == 2 ? std::sqrt(limit) : limit));
  return {};
}

void scale_to_sphere(Nodes& nodes) {
  double sum = 0;
  for (const auto& node : nodes) sum += node.weight;
  for (auto& node : nodes) node.weight *= 4 * kPi / sum;
}

// z = 1 - 2x, azimuth 2 pi turn: equal areas of (x, turn) are equal areas of the sphere.
SphereNode<double> node_at(double x, double turn, double weight) {
  const double angle = 2 * kPi * turn;
  const double radius = 2 * std::sqrt(x * (1 - x));
  return {radius * std::cos(angle), radius * std::sin(angle), 1 - 2 * x, weight};
}

double texel_weight(double u, double v, int size, TexelWeight weight) {
  return weight == TexelWeight::kExact ? texel_solid_angle(u, v, size) : texel_solid_angle_estimate(u, v, size);
}

}  // namespace

Nodes fibonacci_nodes(int count) {
  constexpr double kGoldenAngle = 2.0 * kPi * (2.0 - std::numbers::phi);
  Nodes nodes = nodes_for("fibonacci_nodes: count", count, 1, 1);
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double radius = std::sqrt(1.0 - z * z);
    const double azimuth = i * kGoldenAngle;
    nodes.push_back({radius * std::cos(azimuth), radius * std::sin(azimuth), z, 4 * kPi / count});
  }
  return nodes;
}

Nodes uniform_nodes(int count, std::uint64_t seed) {
  Nodes nodes = nodes_for("uniform_nodes: count", count, 1, 1);
  for (const Direction& d : random_directions(count, seed)) nodes.push_back({d.x, d.y, d.z, 4 * kPi / count});
  return nodes;
}

Nodes stratified_nodes(int side, std::uint64_t seed) {
  Nodes nodes = nodes_for("stratified_nodes: side", side, 1);
  Random random(seed);
  const auto jittered = [&](int cell) { return (cell + 0.5 * (random.next() + 1)) / side; };
  const double weight = 4 * kPi / side / side;
  for (int a = 0; a < side; ++a) {
    for (int b = 0; b < side; ++b) {
      const double x = jittered(a);
      nodes.push_back(node_at(x, jittered(b), weight));
    }
  }
  return nodes;
}

Nodes zone_nodes(int count, std::uint64_t seed) {
  Nodes nodes = nodes_for("zone_nodes: count", count, 1, 1);
  Random random(seed);
  const auto uniform = [&] { return 0.5 * (random.next() + 1); };
  const int zones = std::max(1, static_cast<int>(std::lround(0.5 * std::sqrt(kPi * count))));
  int before = 0;  // cells nearer to +z
  for (int zone = 1; zone <= zones; ++zone) {
    const int upto = static_cast<int>(std::lround(0.5 * count * (1 - std::cos(kPi * zone / zones))));
    const double start = uniform();
    for (int cell = 0; cell < upto - before; ++cell) {
      const double x = (before + (upto - before) * uniform()) / count;
      nodes.push_back(node_at(x, start + (cell + uniform()) / (upto - before), 4 * kPi / count));
    }
    before = upto;
  }
  return nodes;
}

Nodes sobol_nodes(int count, std::uint64_t seed) {
  Nodes nodes = nodes_for("sobol_nodes: count", count, 1, 1);
  for (const auto& [u, v] : sobol_points(count, seed)) nodes.push_back(node_at(u, v, 4 * kPi / count));
  return nodes;
}

Nodes cube_map_nodes(int size, TexelWeight weight) {
  Nodes nodes = nodes_for("cube_map_nodes: size", size, 6);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      const double v = (2.0 * row + 1) / size - 1;
      for (int column = 0; column < size; ++column) {
        const double u = (2.0 * column + 1) / size - 1;
        const double scale = 1 / std::sqrt(1 + u * u + v * v);
        std::array<double, 3> d{};
        d[face % 3] = face < 3 ? scale : -scale;
        d[(face + 1) % 3] = u * scale;
        d[(face + 2) % 3] = v * scale;
        nodes.push_back({d[0], d[1], d[2], texel_weight(u, v, size, weight)});
      }
    }
  }
  if (weight == TexelWeight::kDifferentialScaled) scale_to_sphere(nodes);
  return nodes;
}

Nodes lat_long_nodes(int height, LatLongWeight weight) {
  Nodes nodes = nodes_for("lat_long_nodes: height", height, 2);
  const int width = 2 * height;
  const double step = kPi / height;
  for (int row = 0; row < height; ++row) {
    const double theta = (row + 0.5) * step;
    const double area =
        weight == LatLongWeight::kExact ? lat_long_solid_angle(row, width, height) : std::sin(theta) * step * step;
    for (int column = 0; column < width; ++column) {
      const double phi = (column + 0.5) * step;
      nodes.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta), area});
    }
  }
  return nodes;
}

namespace {

// n >= 1 with factor * n * n nearest to count.
int side_of(int count, int factor) {
  require_range("sphere rule: nodes", count, 1, kMaxSphereNodes);
  const auto most = static_cast<int>(std::sqrt(static_cast<double>(kMaxSphereNodes) / factor));
  return std::clamp(static_cast<int>(std::lround(std::sqrt(static_cast<double>(count) / factor))), 1, most);
}

// degree / 2 + 1 rings of degree + 1 nodes: for odd degrees 2 n n nodes of n rings, exact to degree 2n - 1.
Nodes gauss_legendre_grid(int count, std::uint64_t /*seed*/) { return sphere_rule<double>(2 * side_of(count, 2) - 1); }
Nodes fibonacci(int count, std::uint64_t /*seed*/) { return fibonacci_nodes(count); }
Nodes stratified(int count, std::uint64_t seed) { return stratified_nodes(side_of(count, 1), seed); }
template <TexelWeight kWeight>
Nodes cube_map(int count, std::uint64_t /*seed*/) {
  return cube_map_nodes(side_of(count, 6), kWeight);
}
template <LatLongWeight kWeight>
Nodes lat_long(int count, std::uint64_t /*seed*/) {
  return lat_long_nodes(side_of(count, 2), kWeight);
}

constexpr std::array<SphereRule, 8> kRules{{
    {"gauss_legendre", "Gauss-Legendre in z, equidistant azimuths", gauss_legendre_grid, false},
    {"fibonacci", "Swinbank and Purser 2006", fibonacci, false},
    {"uniform", "Monte Carlo, Green 2003 Eq. 3", uniform_nodes, true},
    {"stratified", "jittered cells, Green 2003", stratified, true},
    {"cube_map", "texel centers, exact solid angle, Driscoll 2012", cube_map<TexelWeight::kExact>, false},
    {"cube_map_differential", "texel centers, area element scaled to 4 pi, Sloan 2008",
     cube_map<TexelWeight::kDifferentialScaled>, false},
    {"lat_long", "pixel centers, exact solid angle", lat_long<LatLongWeight::kExact>, false},
    {"lat_long_centre", "pixel centers, sin(theta) dtheta dphi", lat_long<LatLongWeight::kCenter>, false},
}};

}  // namespace

std::span<const SphereRule> sphere_rules() { return kRules; }

const SphereRule& sphere_rule_named(std::string_view name) {
  std::string names;
  for (const SphereRule& rule : kRules) {
    if (name == rule.name) return rule;
    names += (names.empty() ? "" : ", ") + std::string(rule.name);
  }
  throw std::invalid_argument("sphere rule: expected one of " + names + ", got " + std::string(name));
}

}  // namespace sh::numeric
