// Clustered rows under a light: the light meets the means and vectors of all clusters once a frame; then a vertex mixes
// what they give by its weights, with one multiplication and one addition for each vector and result. No row is ever
// made. Single precision, without contraction: the same bits on every machine.
#pragma once
#include <cstddef>
#include <vector>

#include "prt/transfer/clusters.hpp"

namespace sh::prt {

class LitClusters {
 public:
  /// `lit` (clusters, 1 + vectors, width): what the rows of clusters.basis give, any linear function of a row. `clusters`
  /// must outlive the result.
  LitClusters(const Clusters& clusters, const std::vector<float>& lit);

  /// Adds to `out` (width) what the row of a receiver gives.
  void add_to(std::size_t receiver, float* out) const;

 private:
  const Clusters& clusters_;
  std::size_t width_;
  std::size_t stride_;      // of a row in lit_: the width, rounded up to a whole register
  std::vector<float> lit_;  // vectors over Clusters::kSteps
};

}  // namespace sh::prt
