// The form factors of the mesh: for every vertex, the share of each other vertex in its cosine-weighted hemisphere.
// Rays find them once, and every bounce uses them. They do not depend on light, albedo, color or degree.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "prt/bake/fill_closed.hpp"
#include "prt/bake/panel.hpp"
#include "prt/bake/ranks.hpp"

namespace sh::prt {

/// One entry of a row, made by merging the hits of one vertex at the corners of the hit faces. The light that leaves
/// `vertex` counts with `weight`, the sum over hits of (part of the cosine) * (barycentric coordinate). Weights are
/// positive; the sum of a row is at most 1 (to double rounding), and it is 1 if no ray leaves the scene. Single precision
/// would change the light of closed rooms by 1 / (1 - albedo) roundings.
struct [[gnu::packed]] FormFactor {
  std::uint32_t vertex;
  double weight;
};
using FormFactorRow = std::vector<FormFactor>;

/// Finds the row of one vertex. Only one thread at a time may use it.
using RowMaker = std::function<FormFactorRow(std::size_t vertex)>;

class FormFactors {
 public:
  /// Rows that do not fit into `most_bytes` are made again when needed; each task calls `make_maker` once for this.
  explicit FormFactors(std::size_t vertices, std::size_t most_bytes = SIZE_MAX,
                       std::function<RowMaker()> make_maker = {});

  /// From now on each process keeps and multiplies its own rows only; all of them call advance() together.
  void share_among(Ranks ranks) { ranks_ = std::move(ranks); }
  /// Keeps a row, or drops it if no memory is left; this changes times but no result. Any thread may call it, at the
  /// same time for different vertices.
  void keep(std::size_t vertex, FormFactorRow row);
  /// Closed vertices take the light of their neighbors: from now on K is F K, F of `fill`.
  void fill_with(Fill fill) { fill_ = std::move(fill); }

  /// y = K x: y_v = sum over the row of v of weight * x_vertex; both (vertices, columns); one process alone. The same bits for
  /// any number of threads.
  void apply(const Panel& x, Panel& y) const;
  /// x = K x, by way of `room`.
  void advance(Panel& x, OwnRows& room) const;

  /// The largest error of a number of y that apply() makes by rounding, over the largest number of x.
  [[nodiscard]] double rounding() const;

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const Ranks& ranks() const { return ranks_; }
  [[nodiscard]] bool is_kept(std::size_t vertex) const { return kept_[vertex] != 0; }
  [[nodiscard]] const FormFactorRow& row(std::size_t vertex) const { return rows_[vertex]; }  // empty if not kept

 private:
  std::vector<FormFactorRow> rows_;
  std::vector<std::uint8_t> kept_;
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;  // atomic access while rows are kept
  std::function<RowMaker()> make_maker_;
  Ranks ranks_;
  Fill fill_;

  template <class Rows>
  void multiply(const Panel& x, Rows& y) const;
};

}  // namespace sh::prt
