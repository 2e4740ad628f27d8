#include "prt/transfer/clustering.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"

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

  ClusteredPlanes run() {
    for (int time = 0; time < kMostSplits && planes_.size() < counts_.clusters && split_worst(); ++time) {
      for (int round = 0; round < kRoundsOfGrowth; ++round) improve();
    }
    converge(kRounds);
    move_least_useful();
    drop_empty();
    progress_.finish();
    return {std::move(planes_), std::move(home_), std::move(members_)};
  }

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

}  // namespace

ClusteredPlanes cluster(const DoubleRows& rows, ClusterCounts counts) { return Clustering(rows, counts).run(); }

}  // namespace sh::prt
