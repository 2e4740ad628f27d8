// Puts clusters in place of rows (prt/transfer/clusters.hpp), after a bake.
#pragma once
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Clusters the matrices of a kind that has them, and has files keep its visibility in half precision or less; else
/// clusters the numbers of the vertices. The vectors are kept in half precision, or single where that cannot hold them.
/// Shows progress; throws like clustered().
void compress(Transfer& transfer, ClusterCounts counts);

}  // namespace sh::prt
