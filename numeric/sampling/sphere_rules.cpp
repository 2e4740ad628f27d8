// See sphere_rules.hpp.
#include "numeric/sampling/sphere_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "numeric/oracle/require.hpp"
#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::numeric {
namespace {

using Nodes = std::vector<SphereNode<double>>;

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
    {"lat_long_centre", "pixel centers, sin(theta) dtheta dphi", lat_long<LatLongWeight::kCentre>, false},
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
