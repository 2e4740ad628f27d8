// The form factors of the mesh: the part of the cosine-weighted hemisphere of every vertex that sees each other vertex.
// Rays find them once, and every bounce uses them. They do not depend on light, albedo, color or degree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace sh::prt {

/// A table of numbers, one row a vertex: the columns of a linear system that are solved side by side.
/// (rows, columns) doubles, row-major; the columns are whole SIMD registers (a multiple of kUnit).
struct Panel {
  static constexpr std::size_t kUnit = 8;

  Panel(std::size_t row_count, std::size_t least_columns)
      : rows(row_count), columns((least_columns + kUnit - 1) / kUnit * kUnit), values(rows * columns, 0.0) {}
  double* row(std::size_t r) { return values.data() + r * columns; }
  [[nodiscard]] const double* row(std::size_t r) const { return values.data() + r * columns; }

  std::size_t rows;
  std::size_t columns;
  std::vector<double> values;
};

/// The hits of one vertex, merged by the corners of the faces they lie on: the light that `vertex` sends out counts
/// with `weight`, the sum over hits of (part of the cosine) * (barycentric coordinate). Weights are positive; a row's
/// sum is at most 1 and 1 where everything is closed.
struct FormFactor {
  std::uint32_t vertex;
  float weight;
};
using FormFactorRow = std::vector<FormFactor>;

/// Finds the row of one vertex; used by one thread at a time.
using RowMaker = std::function<FormFactorRow(std::size_t vertex)>;

class FormFactors {
 public:
  /// `make_maker` is called once a task where rows that did not fit into `most_bytes` are needed again.
  explicit FormFactors(std::size_t vertices, std::size_t most_bytes = SIZE_MAX,
                       std::function<RowMaker()> make_maker = {});

  /// Keeps a row, or forgets it where memory is spent: whether it is kept changes times but no result. Calls for
  /// different vertices may come from any thread at once.
  void keep(std::size_t vertex, FormFactorRow row);
  /// The vertex sees what the mean of `sources` sees. Always kept. Not while keep() runs.
  void keep_mean(std::size_t vertex, const std::vector<std::uint32_t>& sources);

  /// y = K x: y_v = sum over the row of v of weight * x_vertex; both (vertices, columns). The same bits for any number
  /// of threads.
  void apply(const Panel& x, Panel& y) const;

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] bool is_kept(std::size_t vertex) const { return kept_[vertex] != 0; }
  [[nodiscard]] const FormFactorRow& row(std::size_t vertex) const { return rows_[vertex]; }  // empty if not kept
  [[nodiscard]] std::size_t bytes() const;           // of the rows that are kept
  [[nodiscard]] std::size_t made_each_time() const;  // rows that are not

 private:
  [[nodiscard]] bool fits(std::size_t bytes);

  std::vector<FormFactorRow> rows_;
  std::vector<std::uint8_t> kept_;
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;  // atomic access while rows are kept
  std::function<RowMaker()> make_maker_;
};

}  // namespace sh::prt
