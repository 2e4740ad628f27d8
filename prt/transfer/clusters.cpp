#include "prt/transfer/clusters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "prt/arrays.hpp"
#include "prt/chunks.hpp"
#include "prt/transfer/clustering.hpp"

namespace sh::prt {

namespace {

void check(const std::vector<float>& rows, std::size_t length, ClusterCounts counts) {
  if (counts.clusters < 1 || counts.clusters > kMostClusters || counts.vectors > kMostVectors) {
    throw std::invalid_argument(fmt::format("{} clusters of {} vectors: expected 1 to {} of 0 to {}", counts.clusters,
                                            counts.vectors, kMostClusters, kMostVectors));
  }
  if (length == 0 || rows.empty() || rows.size() % length != 0) {
    throw std::invalid_argument(fmt::format("{} numbers: expected rows of {}, one or more", rows.size(), length));
  }
  if (!std::all_of(rows.begin(), rows.end(), [](float number) { return std::isfinite(number); })) {
    throw std::invalid_argument("clusters: a number is not finite");
  }
}

// A mean of the largest numbers may exceed single precision by a rounding.
float to_single(double number) {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return static_cast<float>(std::clamp(number, -kLargest, kLargest));
}

// The means and the vectors, as long as the largest weight along each.
std::vector<float> basis_of(const ClusteredPlanes& found, const Reduced& reduced, const std::vector<float>& rows,
                            std::size_t vectors) {
  const auto length = static_cast<std::size_t>(reduced.axes.cols());
  std::vector<float> basis(found.planes.size() * (1 + vectors) * length);
  in_parallel(std::size_t{0}, found.planes.size(), [&](std::size_t c) {
    const std::vector<std::uint32_t>& members = found.members[c];
    const Plane plane = in_all_dimensions(found.planes[c], reduced, rows, members);
    Eigen::VectorXd largest = Eigen::VectorXd::Zero(vectors);
    for (const std::uint32_t r : members) {
      const Eigen::Map<const Eigen::RowVectorXf> row(rows.data() + r * length, length);
      largest = largest.cwiseMax((plane.axes * (row.cast<double>() - plane.mean).transpose()).cwiseAbs());
    }
    DoubleRows own(1 + vectors, length);
    own << plane.mean, largest.asDiagonal() * plane.axes;
    std::transform(own.data(), own.data() + own.size(), basis.begin() + c * own.size(), to_single);
  });
  return basis;
}

// The weights of a row, and the squares of what it loses. The vectors are nearly at right angles.
double weigh(const float* row, Clusters& clusters, std::size_t receiver) {
  using Vector = Eigen::Map<const Eigen::VectorXf>;
  const auto length = static_cast<Eigen::Index>(clusters.length);
  const float* basis = clusters.basis_of(receiver);
  const Eigen::VectorXd x = Vector(row, length).cast<double>();
  Eigen::VectorXd left = x - Vector(basis, length).cast<double>();
  for (std::size_t k = 0; k < clusters.vectors; ++k) {
    const Eigen::VectorXd vector = Vector(basis + (1 + k) * clusters.length, length).cast<double>();
    const double squares = vector.squaredNorm();
    const double weight = squares > 0.0 ? Clusters::kSteps * (left.dot(vector) / squares) : 0.0;
    const auto steps = std::clamp<double>(std::round(weight), -Clusters::kSteps, Clusters::kSteps);
    clusters.weights[receiver * clusters.vectors + k] = static_cast<std::int8_t>(steps);
    left -= steps / Clusters::kSteps * vector;
  }
  return left.squaredNorm();
}

double sum_of_squares(const std::vector<float>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0, [](double sum, float number) {
    return sum + static_cast<double>(number) * static_cast<double>(number);
  });
}

}  // namespace

void Clusters::row(std::size_t receiver, float* out) const {
  const float* mean = basis_of(receiver);
  std::copy_n(mean, length, out);
  for (std::size_t k = 0; k < vectors; ++k) {
    const float weight = static_cast<float>(weights[receiver * vectors + k]) / static_cast<float>(kSteps);
    const float* vector = mean + (1 + k) * length;
    as_array(out, length) += weight * as_array(vector, length);
  }
}

std::vector<float> Clusters::rows() const {
  std::vector<float> out(receivers() * length);
  for_vertices(receivers(), [&](std::size_t r) { row(r, out.data() + r * length); });
  return out;
}

Clusters clustered(const std::vector<float>& rows, std::size_t length, ClusterCounts counts, const RoundBasis& round) {
  check(rows, length, counts);
  counts.vectors = static_cast<std::uint32_t>(std::min<std::size_t>(counts.vectors, length));
  const Reduced few = reduced(rows, length);
  const ClusteredPlanes found = cluster(few.coordinates, counts);
  Clusters clusters;
  clusters.length = length;
  clusters.vectors = counts.vectors;
  clusters.cluster = found.home;
  clusters.basis = basis_of(found, few, rows, counts.vectors);
  if (round) clusters.basis = round(clusters.basis);
  clusters.weights.resize(clusters.receivers() * clusters.vectors);
  std::vector<double> lost(clusters.receivers());
  for_vertices(clusters.receivers(), [&](std::size_t r) { lost[r] = weigh(rows.data() + r * length, clusters, r); });
  const double squares = sum_of_squares(rows);
  clusters.error = squares > 0.0 ? std::sqrt(std::accumulate(lost.begin(), lost.end(), 0.0) / squares) : 0.0;
  return clusters;
}

}  // namespace sh::prt
