// Tables of numbers with one row a vertex: whole ones, and the rows that one process owns.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "prt/bake/ranks.hpp"

namespace sh::prt {

/// A table of numbers with one row a vertex; its columns are right sides of a linear system that are solved together.
/// (rows, columns) doubles, row-major; the number of columns is a multiple of kUnit, so that they fill whole SIMD
/// registers.
struct Panel {
  static constexpr std::size_t kUnit = 8;

  Panel(std::size_t row_count, std::size_t least_columns)
      : rows(row_count), columns((least_columns + kUnit - 1) / kUnit * kUnit), values(rows * columns, 0.0) {}
  double* row(std::size_t r) { return values.data() + r * columns; }
  [[nodiscard]] const double* row(std::size_t r) const { return values.data() + r * columns; }
  /// The rows first .. last - 1, transposed.
  Eigen::Map<Eigen::ArrayXXd> block(std::size_t first, std::size_t last) {
    return {row(first), Eigen::Index(columns), Eigen::Index(last - first)};
  }
  [[nodiscard]] Eigen::Map<const Eigen::ArrayXXd> block(std::size_t first, std::size_t last) const {
    return {row(first), Eigen::Index(columns), Eigen::Index(last - first)};
  }

  std::size_t rows;
  std::size_t columns;
  std::vector<double> values;
};

/// The rows of a panel that this process owns, one after the other: all of them where there is one process.
class OwnRows {
 public:
  /// All zeros. `ranks` must outlive this object.
  OwnRows(const Ranks& ranks, std::size_t rows, std::size_t columns)
      : ranks_(&ranks), rows_(rows), panel_(ranks.owned(rows), columns) {}
  /// Those of `whole`.
  OwnRows(const Ranks& ranks, const Panel& whole);

  /// Of all processes.
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return panel_.columns; }
  /// Row `v` of the panel, which this process must own; rows that are owned together are one after the other.
  double* row(std::size_t v) { return panel_.row(ranks_->place(v)); }
  [[nodiscard]] const double* row(std::size_t v) const { return panel_.row(ranks_->place(v)); }
  /// The rows first .. last - 1, transposed, no more than Ranks::kRowsAtOnce of them that are owned together.
  Eigen::Map<Eigen::ArrayXXd> block(std::size_t first, std::size_t last) {
    return panel_.block(ranks_->place(first), ranks_->place(first) + last - first);
  }
  [[nodiscard]] Eigen::Map<const Eigen::ArrayXXd> block(std::size_t first, std::size_t last) const {
    return panel_.block(ranks_->place(first), ranks_->place(first) + last - first);
  }
  /// The rows first .. last - 1 of all processes, which call it together. first: a multiple of Ranks::kRowsAtOnce.
  void gather(std::size_t first, std::size_t last, double* to) const;
  void gather(Panel& whole) const { gather(0, rows_, whole.values.data()); }
  /// Exchanges its numbers with a panel of one process.
  void swap(Panel& whole) noexcept { std::swap(whole.values, panel_.values); }

 private:
  const Ranks* ranks_;
  std::size_t rows_;
  Panel panel_;
};

}  // namespace sh::prt
