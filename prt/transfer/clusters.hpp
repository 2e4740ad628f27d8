// Clustered principal components [SloanHallHartSnyder03]: rows of numbers as a mean and a few vectors of their cluster,
// mixed by 8-bit weights. The rows of a cluster lie near a plane of few dimensions, because neighbors see nearly the same
// scene. The run time multiplies the vectors of all clusters by the light once; then a vertex needs no more than its
// weights.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace sh::prt {

inline constexpr std::uint32_t kMostClusters = 4096;
inline constexpr std::uint32_t kMostVectors = 64;

/// Rows: number i of receiver r is basis[c][0][i] + sum_k weights[r][k] / 127 basis[c][1 + k][i], c = cluster[r].
struct Clusters {
  static constexpr int kSteps = 127;  // of a weight, from 0 to 1

  std::size_t length = 0;              // numbers of a receiver
  std::size_t vectors = 0;             // of a cluster, besides its mean
  std::vector<float> basis;            // (clusters, 1 + vectors, length): the mean, then vectors for weights of -1 to 1
  std::vector<std::uint16_t> cluster;  // (receivers)
  std::vector<std::int8_t> weights;    // (receivers, vectors), -127..127
  double error = 0.0;                  // rms of what the rows lost over the rms of the rows

  [[nodiscard]] std::size_t count() const { return basis.size() / ((1 + vectors) * length); }
  [[nodiscard]] std::size_t receivers() const { return cluster.size(); }
  [[nodiscard]] bool empty() const { return cluster.empty(); }
  /// The mean of a receiver's cluster, followed by the vectors.
  [[nodiscard]] const float* basis_of(std::size_t receiver) const {
    return basis.data() + cluster[receiver] * (1 + vectors) * length;
  }
  /// Writes the numbers of a receiver, (length).
  void row(std::size_t receiver, float* out) const;
  /// The numbers of all receivers, (receivers, length).
  [[nodiscard]] std::vector<float> rows() const;
};

/// How many clusters to make at most, 1..kMostClusters, and how many vectors in each, 0..kMostVectors.
struct ClusterCounts {
  std::uint32_t clusters = 0;
  std::uint32_t vectors = 0;
};

/// basis -> basis as a file will hold it: the weights are made for the rounded vectors.
using RoundBasis = std::function<std::vector<float>(const std::vector<float>& basis)>;

/// rows (receivers, length) -> clusters; fewer where the rows need no more. Splits the worst clusters until there are
/// enough, and after each split gives every row to the cluster whose plane is nearest; at last moves the least useful
/// clusters to where they are worth more. The same bytes for any number of
/// threads. Shows progress. Throws std::invalid_argument for counts out of range, rows of another length, no rows and
/// numbers that are not finite, output::Interrupted on request.
Clusters clustered(const std::vector<float>& rows, std::size_t length, ClusterCounts counts,
                   const RoundBasis& round = {});

}  // namespace sh::prt
