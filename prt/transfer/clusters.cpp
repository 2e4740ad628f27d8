#include "prt/transfer/clusters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"
#include "prt/transfer/principal_axes.hpp"

namespace sh::prt {

namespace {

constexpr int kRoundsOfGrowth = 2;   // after each split
constexpr int kRounds = 40;          // at the end
constexpr int kMostSplits = 24;      // twice as many as double one cluster to kMostClusters
constexpr std::size_t kAround = 24;  // clusters to which a row may go from its own
constexpr std::size_t kBlock = 64;   // rows at once
constexpr int kMoves = 6;            // of clusters to places where they are worth more
constexpr int kRoundsOfMove = 6;
constexpr std::size_t kPartMoved = 8;  // of the clusters, at once
constexpr double kPartOfSplit = 0.5;   // of its error that a split may save
constexpr double kLittle = 5e-4;       // of the error: a round that gains less is the last

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

std::size_t most_rounds(std::uint32_t clusters) {
  return static_cast<std::size_t>(kRoundsOfGrowth * std::bit_width(clusters) + kRounds + kMoves * kRoundsOfMove);
}

// Finds the nearest of some planes.
class PlanesAround {
 public:
  PlanesAround(const std::vector<Plane>& planes, const std::vector<std::uint16_t>& some, std::size_t vectors)
      : some_(some), vectors_(some.size() * (1 + vectors), planes[0].mean.size()), of_mean_(some.size(), 1 + vectors) {
    const auto block = static_cast<Eigen::Index>(1 + vectors);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const Plane& plane = planes[some[i]];
      auto own = vectors_.middleRows(i * block, block);
      own.row(0) = plane.mean;
      own.bottomRows(vectors) = plane.axes;
      of_mean_.row(i) = own * plane.mean.transpose();
    }
  }

  void assign(const DoubleRows& rows, std::span<const std::uint32_t> members, std::vector<std::uint16_t>& home,
              std::vector<double>& gap) const {
    DoubleRows block(members.size(), rows.cols());
    for (std::size_t i = 0; i < members.size(); ++i) block.row(i) = rows.row(members[i]);
    const DoubleRows products = block * vectors_.transpose();
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Nearest found = nearest(products.row(i));
      home[members[i]] = some_[found.plane];
      gap[members[i]] = found.gap;
    }
  }

 private:
  struct Nearest {
    std::size_t plane;
    double gap;  // to the second, in squared distance
  };

  // Squared distances to the planes: |x - m|^2 - sum_k ((x - m) a_k)^2, less |x|^2.
  template <class Products>
  [[nodiscard]] Nearest nearest(const Products& products) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double least = kInfinity;
    double second = kInfinity;
    std::size_t best = 0;
    for (std::size_t i = 0; i < some_.size(); ++i) {
      const Eigen::Index first = i * of_mean_.cols();
      double distance = of_mean_(i, 0) - 2.0 * products[first];
      for (Eigen::Index k = 1; k < of_mean_.cols(); ++k) {
        const double along = products[first + k] - of_mean_(i, k);
        distance -= along * along;
      }
      if (distance < least) {
        second = std::exchange(least, distance);
        best = i;
      } else {
        second = std::min(second, distance);
      }
    }
    return {best, second - least};
  }

  const std::vector<std::uint16_t>& some_;
  DoubleRows vectors_;  // (some, 1 + vectors, columns)
  DoubleRows of_mean_;  // (some, 1 + vectors) products of the mean with itself and the axes
};

// Splits and reassigns clusters of rows in few dimensions.
class Clustering {
 public:
  Clustering(const DoubleRows& rows, ClusterCounts counts)
      : rows_(rows),
        counts_(counts),
        progress_("clusters", most_rounds(counts.clusters)),
        home_(rows.rows(), 0),
        gap_(rows.rows(), 0.0),
        members_(1),
        planes_(1) {
    counts_.clusters = static_cast<std::uint32_t>(std::min<std::size_t>(counts.clusters, rows.rows()));
    members_[0].resize(rows.rows());
    std::iota(members_[0].begin(), members_[0].end(), 0U);
    fit();
  }

  void run() {
    for (int time = 0; time < kMostSplits && planes_.size() < counts_.clusters && split_worst(); ++time) {
      for (int round = 0; round < kRoundsOfGrowth; ++round) improve();
    }
    converge(kRounds);
    move_least_useful();
    drop_empty();
    progress_.finish();
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

  void converge(int rounds) {
    double error = total_error();
    for (int round = 0; round < rounds; ++round) {
      split_worst();  // in place of empty clusters
      improve();
      const double before = std::exchange(error, total_error());
      if (error >= (1.0 - kLittle) * before) break;
    }
  }

  // Takes clusters away where their rows lose least and splits the worst ones instead, as long as the error falls.
  void move_least_useful() {
    double error = total_error();
    std::size_t count = planes_.size() / kPartMoved + 1;
    for (int time = 0; time < kMoves && count > 0; ++time) {
      const auto before = std::tuple(home_, members_, planes_, gap_);
      if (!dissolve_least_useful(count)) break;
      fit();
      converge(kRoundsOfMove);
      if (total_error() < error) {
        error = total_error();
      } else {
        std::tie(home_, members_, planes_, gap_) = before;
        count /= 2;
      }
    }
  }

  // Gives the rows of up to `count` clusters to the clusters next to them; false if none is less useful than a split.
  bool dissolve_least_useful(std::size_t count) {
    std::vector<std::pair<double, std::size_t>> useful;
    std::vector<double> errors;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      double gaps = 0.0;
      for (const std::uint32_t r : members_[c]) gaps += gap_[r];
      useful.emplace_back(gaps, c);
      errors.push_back(planes_[c].error);
    }
    std::sort(useful.begin(), useful.end());
    std::sort(errors.begin(), errors.end(), std::greater<>());
    bool any = false;
    for (std::size_t i = 0; i < std::min(count, useful.size() / 2); ++i) {
      const auto& [gaps, c] = useful[i];
      if (gaps >= kPartOfSplit * errors[i] || around_[c].size() < 2) break;
      std::vector<std::uint32_t>& next = members_[around_[c][1]];
      next.insert(next.end(), members_[c].begin(), members_[c].end());
      std::sort(next.begin(), next.end());
      members_[c].clear();
      any = true;
    }
    return any;
  }

  void improve() {
    find_around();
    assign();
    fit();
    progress_.advance();
  }

  // Gives every row to the cluster with the nearest plane among those around its own.
  void assign() {
    in_parallel(std::size_t{0}, planes_.size(), [&](std::size_t c) {
      output::check_interrupt();
      const PlanesAround around(planes_, around_[c], counts_.vectors);
      for (std::size_t first = 0; first < members_[c].size(); first += kBlock) {
        around.assign(rows_, std::span(members_[c]).subspan(first, std::min(kBlock, members_[c].size() - first)), home_,
                      gap_);
      }
    });
    for (std::vector<std::uint32_t>& members : members_) members.clear();
    for (std::size_t r = 0; r < home_.size(); ++r) members_[home_[r]].push_back(static_cast<std::uint32_t>(r));
  }

  // The clusters whose means are nearest to that of each, itself the first.
  void find_around() {
    around_.resize(planes_.size());
    in_parallel(std::size_t{0}, planes_.size(), [&](std::size_t c) {
      std::vector<std::pair<double, std::uint16_t>> apart;
      for (std::size_t other = 0; other < planes_.size(); ++other) {
        if (members_[other].empty()) continue;
        apart.emplace_back((planes_[other].mean - planes_[c].mean).squaredNorm(), static_cast<std::uint16_t>(other));
      }
      const std::size_t count = std::min(kAround, apart.size());
      std::partial_sort(apart.begin(), apart.begin() + count, apart.end());
      around_[c].clear();
      for (std::size_t i = 0; i < count; ++i) around_[c].push_back(apart[i].second);
    });
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
  output::Progress progress_;
  std::vector<std::uint16_t> home_;                  // (rows) the cluster of each
  std::vector<double> gap_;                          // (rows) what each would lose in the next best cluster
  std::vector<std::vector<std::uint32_t>> members_;  // rows of a cluster, ascending
  std::vector<Plane> planes_;
  std::vector<std::vector<std::uint16_t>> around_;
};

// A mean of the largest numbers may exceed single precision by a rounding.
float to_single(double number) {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return static_cast<float>(std::clamp(number, -kLargest, kLargest));
}

// The means and the vectors, as long as the largest weight along each.
std::vector<float> basis_of(const Clustering& clustering, const Reduced& reduced, const std::vector<float>& rows,
                            std::size_t vectors) {
  const auto length = static_cast<std::size_t>(reduced.axes.cols());
  std::vector<float> basis(clustering.planes().size() * (1 + vectors) * length);
  in_parallel(std::size_t{0}, clustering.planes().size(), [&](std::size_t c) {
    const std::vector<std::uint32_t>& members = clustering.members(c);
    const Plane plane = in_all_dimensions(clustering.planes()[c], reduced, rows, members);
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
  clusters.basis = basis_of(clustering, few, rows, counts.vectors);
  if (round) clusters.basis = round(clusters.basis);
  clusters.weights.resize(clusters.receivers() * clusters.vectors);
  std::vector<double> lost(clusters.receivers());
  for_vertices(clusters.receivers(), [&](std::size_t r) { lost[r] = weigh(rows.data() + r * length, clusters, r); });
  const double squares = sum_of_squares(rows);
  clusters.error = squares > 0.0 ? std::sqrt(std::accumulate(lost.begin(), lost.end(), 0.0) / squares) : 0.0;
  return clusters;
}

}  // namespace sh::prt
