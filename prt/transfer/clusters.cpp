#include "prt/transfer/clusters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"
#include "prt/transfer/principal_axes.hpp"

namespace sh::prt {

namespace {

constexpr int kRoundsOfGrowth = 3;  // after each split
constexpr int kRounds = 20;         // at the end
constexpr int kMostSplits = 24;     // twice as many as double one cluster to kMostClusters
constexpr double kLittle = 2e-3;    // of the error: a round that gains less is the last

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

// Splits and reassigns clusters of rows in few dimensions.
class Clustering {
 public:
  Clustering(const DoubleRows& rows, ClusterCounts counts)
      : rows_(rows), counts_(counts), home_(rows.rows(), 0), members_(1), planes_(1) {
    counts_.clusters = static_cast<std::uint32_t>(std::min<std::size_t>(counts.clusters, rows.rows()));
    members_[0].resize(rows.rows());
    std::iota(members_[0].begin(), members_[0].end(), 0U);
    fit();
  }

  void run() {
    output::Progress progress("clusters", counts_.clusters + kRounds);
    for (int time = 0; time < kMostSplits && planes_.size() < counts_.clusters && split_worst(); ++time) {
      for (int round = 0; round < kRoundsOfGrowth; ++round) improve();
    }
    progress.advance(counts_.clusters);
    double error = total_error();
    for (int round = 0; round < kRounds; ++round) {
      split_worst();  // in place of empty clusters
      improve();
      progress.advance();
      const double before = std::exchange(error, total_error());
      if (error >= (1.0 - kLittle) * before) break;
    }
    drop_empty();
    progress.finish();
  }

  [[nodiscard]] const std::vector<Plane>& planes() const { return planes_; }
  [[nodiscard]] const std::vector<std::uint16_t>& home() const { return home_; }
  [[nodiscard]] const std::vector<std::uint32_t>& members(std::size_t c) const { return members_[c]; }

 private:
  [[nodiscard]] double total_error() const {
    return std::accumulate(planes_.begin(), planes_.end(), 0.0,
                           [](double sum, const Plane& plane) { return sum + plane.error; });
  }

  void fit() {
    in_parallel(std::size_t{0}, planes_.size(), [&](std::size_t c) {
      output::check_interrupt();
      planes_[c] = nearest_plane(rows_, members_[c], counts_.vectors);
    });
  }

  void improve() {
    assign();
    fit();
  }

  // Gives every row to the cluster with the nearest plane, the first of equals.
  void assign() {
    const std::size_t count = planes_.size();
    const std::size_t block = 1 + counts_.vectors;
    DoubleRows vectors(count * block, rows_.cols());
    DoubleRows of_mean(count, block);  // products of the mean with the vectors
    for (std::size_t c = 0; c < count; ++c) {
      vectors.row(c * block) = planes_[c].mean;
      vectors.middleRows(c * block + 1, counts_.vectors) = planes_[c].axes;
      of_mean.row(c) = vectors.middleRows(c * block, block) * planes_[c].mean.transpose();
    }
    for_chunks(rows_.rows(), [&](std::size_t chunk) {
      const VertexRange range = chunk_range(chunk, rows_.rows());
      const DoubleRows products = rows_.middleRows(range.first, range.size()) * vectors.transpose();
      for (std::size_t r = 0; r < range.size(); ++r) home_[range.first + r] = nearest(products.row(r), of_mean);
    });
    for (std::vector<std::uint32_t>& members : members_) members.clear();
    for (std::size_t r = 0; r < home_.size(); ++r) members_[home_[r]].push_back(static_cast<std::uint32_t>(r));
  }

  // Squared distances to the planes: |x - m|^2 - sum_k ((x - m) a_k)^2, less |x|^2.
  template <class Products>
  [[nodiscard]] std::uint16_t nearest(const Products& products, const DoubleRows& of_mean) const {
    double least = std::numeric_limits<double>::infinity();
    std::uint16_t best = 0;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      if (members_[c].empty()) continue;
      const Eigen::Index first = c * of_mean.cols();
      double distance = of_mean(c, 0) - 2.0 * products[first];
      for (Eigen::Index k = 1; k < of_mean.cols(); ++k) {
        const double along = products[first + k] - of_mean(c, k);
        distance -= along * along;
      }
      if (distance < least) {
        least = distance;
        best = static_cast<std::uint16_t>(c);
      }
    }
    return best;
  }

  // Splits up to all clusters, the worst first, into empty and new ones; false if there is none to split or to fill.
  bool split_worst() {
    std::vector<std::size_t> free;
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      if (members_[c].empty()) {
        free.push_back(c);
      } else if (planes_[c].can_be_split()) {
        order.push_back(c);
      }
    }
    while (planes_.size() < counts_.clusters && free.size() < order.size()) {
      free.push_back(planes_.size());
      planes_.emplace_back();
      members_.emplace_back();
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return planes_[a].error > planes_[b].error; });
    const std::size_t splits = std::min(free.size(), order.size());
    for (std::size_t i = 0; i < splits; ++i) split(order[i], free[i]);
    if (splits > 0) fit();
    return splits > 0;
  }

  // Moves the rows on one side of the mean, along the longest axis, to another cluster.
  void split(std::size_t from, std::size_t to) {
    const Plane half = nearest_plane(rows_, members_[from], 1);
    std::vector<std::uint32_t> stay;
    for (const std::uint32_t r : members_[from]) {
      const bool goes = (rows_.row(r) - half.mean).dot(half.axes.row(0)) > 0.0;
      (goes ? members_[to] : stay).push_back(r);
    }
    members_[from] = std::move(stay);
  }

  void drop_empty() {
    std::size_t kept = 0;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      if (members_[c].empty()) continue;
      for (const std::uint32_t r : members_[c]) home_[r] = static_cast<std::uint16_t>(kept);
      if (kept != c) {
        planes_[kept] = std::move(planes_[c]);
        members_[kept] = std::move(members_[c]);
      }
      ++kept;
    }
    planes_.resize(kept);
    members_.resize(kept);
  }

  const DoubleRows& rows_;
  ClusterCounts counts_;
  std::vector<std::uint16_t> home_;                  // (rows) the cluster of each
  std::vector<std::vector<std::uint32_t>> members_;  // rows of a cluster, ascending
  std::vector<Plane> planes_;
};

// A mean of the largest numbers may exceed single precision by a rounding.
float to_single(double number) {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return static_cast<float>(std::clamp(number, -kLargest, kLargest));
}

// The means and the vectors, as long as the largest weight along each.
std::vector<float> basis_of(const Clustering& clustering, const Reduced& reduced, std::size_t vectors) {
  DoubleRows basis(clustering.planes().size() * (1 + vectors), reduced.axes.cols());
  in_parallel(std::size_t{0}, clustering.planes().size(), [&](std::size_t c) {
    const Plane& plane = clustering.planes()[c];
    Eigen::VectorXd largest = Eigen::VectorXd::Zero(vectors);
    for (const std::uint32_t r : clustering.members(c)) {
      largest = largest.cwiseMax((plane.axes * (reduced.coordinates.row(r) - plane.mean).transpose()).cwiseAbs());
    }
    basis.row(c * (1 + vectors)) = reduced.origin + plane.mean * reduced.axes;
    basis.middleRows(c * (1 + vectors) + 1, vectors) = largest.asDiagonal() * (plane.axes * reduced.axes);
  });
  std::vector<float> out(basis.size());
  std::transform(basis.data(), basis.data() + basis.size(), out.begin(), to_single);
  return out;
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
    for (std::size_t i = 0; i < length; ++i) out[i] += weight * vector[i];
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
  Clustering clustering(few.coordinates, counts);
  clustering.run();
  Clusters clusters;
  clusters.length = length;
  clusters.vectors = counts.vectors;
  clusters.cluster = clustering.home();
  clusters.basis = basis_of(clustering, few, counts.vectors);
  if (round) clusters.basis = round(clusters.basis);
  clusters.weights.resize(clusters.receivers() * clusters.vectors);
  std::vector<double> lost(clusters.receivers());
  for_vertices(clusters.receivers(), [&](std::size_t r) { lost[r] = weigh(rows.data() + r * length, clusters, r); });
  const double squares = sum_of_squares(rows);
  clusters.error = squares > 0.0 ? std::sqrt(std::accumulate(lost.begin(), lost.end(), 0.0) / squares) : 0.0;
  return clusters;
}

}  // namespace sh::prt
