// Small dense matrices over any ring: rationals, surd sums, polynomials.
//
// T() must be the zero of the ring. Row-major; only the arithmetic of the derivations.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace sh::symbolic {

template <class T>
class Matrix {
 public:
  Matrix() = default;
  /// A zero matrix.
  Matrix(int rows, int columns)
      : rows_(rows),
        columns_(columns),
        entries_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), T()) {}
  /// Row by row; throws std::invalid_argument unless there are rows * columns entries.
  Matrix(int rows, int columns, std::vector<T> entries) : rows_(rows), columns_(columns), entries_(std::move(entries)) {
    if (entries_.size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)) {
      throw std::invalid_argument("Matrix: expected rows times columns entries, got another number");
    }
  }
  static Matrix identity(int size, const T& one) {
    Matrix result(size, size);
    for (int i = 0; i < size; ++i) result(i, i) = one;
    return result;
  }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  T& operator()(int row, int column) { return entries_[index(row, column)]; }
  const T& operator()(int row, int column) const { return entries_[index(row, column)]; }

  [[nodiscard]] Matrix transposed() const {
    Matrix result(columns_, rows_);
    for (int i = 0; i < rows_; ++i) {
      for (int j = 0; j < columns_; ++j) result(j, i) = (*this)(i, j);
    }
    return result;
  }

  /// f of every entry.
  template <class F>
  [[nodiscard]] auto mapped(const F& f) const {
    Matrix<std::decay_t<decltype(f(std::declval<const T&>()))>> result(rows_, columns_);
    for (int i = 0; i < rows_; ++i) {
      for (int j = 0; j < columns_; ++j) result(i, j) = f((*this)(i, j));
    }
    return result;
  }

  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    if (a.columns_ != b.rows_)
      throw std::invalid_argument("Matrix: product: expected as many columns as rows, got another number");
    Matrix result(a.rows_, b.columns_);
    for (int i = 0; i < a.rows_; ++i) {
      for (int j = 0; j < b.columns_; ++j) {
        T sum = T();
        for (int k = 0; k < a.columns_; ++k) sum = sum + a(i, k) * b(k, j);
        result(i, j) = std::move(sum);
      }
    }
    return result;
  }
  friend bool operator==(const Matrix& a, const Matrix& b) {
    return a.rows_ == b.rows_ && a.columns_ == b.columns_ && a.entries_ == b.entries_;
  }

 private:
  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  int rows_ = 0;
  int columns_ = 0;
  std::vector<T> entries_;
};

}  // namespace sh::symbolic
