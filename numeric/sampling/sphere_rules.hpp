// Every quadrature rule on the sphere in one table, to compare them.
//
// Input: the approximate number of nodes, and a seed that only random rules use. Output: nodes whose weights sum
// to 4 pi (lat_long_centre: to 4 pi (1 + O(1/count))). Rules on grids take the nearest number of nodes that they can
// have; nodes(...).size() tells.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "numeric/oracle/quadrature.hpp"

namespace sh::numeric {

struct SphereRule {
  const char* name;    // "fibonacci"
  const char* source;  // to cite
  /// 1 <= count_hint <= kMaxSphereNodes (sphere_nodes.hpp); throws std::invalid_argument otherwise.
  std::vector<SphereNode<double>> (*nodes)(int count_hint, std::uint64_t seed);
  bool random;  // another seed gives other nodes
};

/// gauss_legendre, fibonacci, uniform, stratified, cube_map, cube_map_differential, lat_long, lat_long_centre.
std::span<const SphereRule> sphere_rules();

/// Throws std::invalid_argument listing the names if there is no such rule.
const SphereRule& sphere_rule_named(std::string_view name);

}  // namespace sh::numeric
