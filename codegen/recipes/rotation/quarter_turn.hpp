// Writes the quarter turn about x, D_l(Rx(90)), one parity class at a time, in forms that need few operations.
//
// Y_lm has parities (+-1) under x -> -x, y -> -y, z -> -z. The quarter turn exchanges the parities of y and z, so it
// maps the columns of one class to the rows of one class. If it maps a class to itself, the matrix is symmetric and its
// square is 1. Then the matrix is +-(1 - U W) with U of low rank. In all other matrices each row is divided by its
// largest entry; the recipe puts these scales elsewhere.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "codegen/recipes/signed_builder.hpp"
#include "symbolic/number/matrix.hpp"

namespace sh::codegen::recipes {

/// Rows (orders m) and columns (orders n) of one class of D_l(Rx(90)).
class QuarterTurnClass {
 public:
  /// turn: T of symbolic::rotation_x90(degree). Rows may be fewer than columns (row m = 0 left out).
  QuarterTurnClass(int degree, const symbolic::Matrix<cln::cl_RA>& turn, const std::vector<int>& rows,
                   const std::vector<int>& columns);

  /// Divides the row by another entry, nearly as large, if `squares` holds the square of that entry more often than the
  /// square of scale(row). Then replaces the old square in `squares` by the new one.
  void prefer_scale(std::size_t row, std::multiset<symbolic::Surd>& squares);
  /// A row of the class is scale(row) times the row that `forward` and `backward` use.
  [[nodiscard]] const symbolic::Surd& scale(std::size_t row) const { return scales_[row]; }
  /// Maps columns to rows.
  [[nodiscard]] std::vector<Value> forward(SignedBuilder& build, const std::vector<Value>& v) const;
  /// Maps rows to columns by the transposed matrix.
  [[nodiscard]] std::vector<Value> backward(SignedBuilder& build, const std::vector<Value>& v) const;

 private:
  using Surds = symbolic::Matrix<symbolic::Surd>;

  // sign * (1 - expand * reduce)
  struct Reflection {
    bool negative = false;
    Surds expand;  // (orders, rank)
    Surds reduce;  // (rank, orders)
  };

  void divide_row(std::size_t row, int column);
  static Reflection find_reflection(int degree, const symbolic::Matrix<cln::cl_RA>& turn,
                                    const std::vector<int>& orders);

  Surds entries_;  // (rows, columns)
  std::vector<symbolic::Surd> scales_;
  std::optional<Reflection> reflection_;
};

}  // namespace sh::codegen::recipes
