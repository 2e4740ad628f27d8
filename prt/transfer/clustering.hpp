// The clusters of rows in few dimensions: which row belongs where, and the plane of each.
#pragma once
#include <cstdint>
#include <vector>

#include "prt/transfer/clusters.hpp"
#include "prt/transfer/principal_axes.hpp"

namespace sh::prt {

struct ClusteredPlanes {
  std::vector<Plane> planes;                        // (clusters)
  std::vector<std::uint16_t> home;                  // (rows) the cluster of each
  std::vector<std::vector<std::uint32_t>> members;  // (clusters) rows, ascending
};

/// Splits the worst clusters until there are enough, and after each split gives every row to the nearest plane among the
/// clusters around its own. At last moves the least useful clusters to where they are worth more. Shows progress.
ClusteredPlanes cluster(const DoubleRows& rows, ClusterCounts counts);

}  // namespace sh::prt
