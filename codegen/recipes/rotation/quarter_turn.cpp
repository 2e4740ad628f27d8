#include "codegen/recipes/rotation/quarter_turn.hpp"

#include <cln/real.h>

#include "codegen/recipes/rotation/rotation_parts.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Matrix;
using symbolic::Surd;
using Rationals = Matrix<cln::cl_RA>;

// Smaller classes need fewer operations without this form.
constexpr int kSmallestReflection = 3;

// A row may be divided by an entry whose square is at least this, relative to the square of the largest entry.
const cln::cl_RA kNearlyAsLarge = cln::cl_RA(3) / 4;

int largest_entry(const Matrix<Surd>& matrix, int row) {
  const auto square = [&](int j) { return (matrix(row, j) * matrix(row, j)).rational(); };
  int largest = 0;
  for (int j = 1; j < matrix.columns(); ++j) {
    if (square(j) > square(largest)) largest = j;
  }
  return largest;
}

// All ways to choose `count` of the numbers 0 .. size - 1, in lexical order.
std::vector<std::vector<int>> choices(int size, int count) {
  if (count == 0) return {{}};
  std::vector<std::vector<int>> all;
  for (int first = 0; first <= size - count; ++first) {
    for (std::vector<int> rest : choices(size - first - 1, count - 1)) {
      for (int& item : rest) item += first + 1;
      rest.insert(rest.begin(), first);
      all.push_back(std::move(rest));
    }
  }
  return all;
}

// Transforms columns `pivots` of the matrix to columns of the identity. Returns the determinant of that square part.
cln::cl_RA eliminate(Rationals& rows, const std::vector<int>& pivots) {
  cln::cl_RA determinant = 1;
  for (int step = 0; step < rows.rows(); ++step) {
    const int pivot = pivots[step];
    const cln::cl_RA head = rows(step, pivot);
    determinant = determinant * head;
    // A principal minor of a projector is positive, or the whole choice of pivots is useless.
    if (cln::zerop(head)) return 0;
    for (int j = 0; j < rows.columns(); ++j) rows(step, j) = rows(step, j) / head;
    for (int i = 0; i < rows.rows(); ++i) {
      const cln::cl_RA factor = rows(i, pivot);
      for (int j = 0; i != step && j < rows.columns(); ++j) rows(i, j) = rows(i, j) - factor * rows(step, j);
    }
  }
  return determinant;
}

Rationals chosen_rows(const Rationals& matrix, const std::vector<int>& rows) {
  Rationals result(static_cast<int>(rows.size()), matrix.columns());
  for (int i = 0; i < result.rows(); ++i) {
    for (int j = 0; j < result.columns(); ++j) result(i, j) = matrix(rows[i], j);
  }
  return result;
}

}  // namespace

QuarterTurnClass::QuarterTurnClass(int degree, const Rationals& turn, const std::vector<int>& rows,
                                   const std::vector<int>& columns)
    : entries_(static_cast<int>(rows.size()), static_cast<int>(columns.size())), scales_(rows.size(), Surd(1)) {
  if (rows == columns && entries_.rows() >= kSmallestReflection) {
    reflection_ = find_reflection(degree, turn, rows);
    return;
  }
  for (int i = 0; i < entries_.rows(); ++i) {
    for (int j = 0; j < entries_.columns(); ++j) {
      const int m = rows[i];
      const int n = columns[j];
      entries_(i, j) = symbolic::factor_ratio(degree, m, n) * Surd(turn(degree + m, degree + n));
    }
  }
  for (std::size_t row = 0; row < rows.size(); ++row) divide_row(row, largest_entry(entries_, static_cast<int>(row)));
}

void QuarterTurnClass::divide_row(std::size_t row, int column) {
  const int i = static_cast<int>(row);
  const Surd entry = entries_(i, column);
  scales_[row] = scales_[row] * entry;
  for (int j = 0; j < entries_.columns(); ++j) entries_(i, j) = entries_(i, j) / entry;
}

void QuarterTurnClass::prefer_scale(std::size_t row, std::multiset<Surd>& squares) {
  if (reflection_) return;
  const Surd square = scales_[row] * scales_[row];
  squares.erase(squares.find(square));
  const int i = static_cast<int>(row);
  int chosen = -1;
  std::size_t most = squares.count(square);
  for (int j = 0; j < entries_.columns(); ++j) {
    const Surd ratio = entries_(i, j) * entries_(i, j);
    if (ratio.rational() < kNearlyAsLarge || squares.count(square * ratio) <= most) continue;
    chosen = j;
    most = squares.count(square * ratio);
  }
  if (chosen >= 0) divide_row(row, chosen);
  squares.insert(scales_[row] * scales_[row]);
}

// With T^2 = 1, E = (1 -+ T) / 2 is a projector, and E = E(:,p) E(p,p)^-1 E(p,:) for as many pivots p as its rank.
QuarterTurnClass::Reflection QuarterTurnClass::find_reflection(int degree, const Rationals& turn,
                                                               const std::vector<int>& orders) {
  const int size = static_cast<int>(orders.size());
  cln::cl_RA trace = 0;
  for (const int m : orders) trace = trace + turn(degree + m, degree + m);
  Reflection result;
  result.negative = cln::minusp(trace);
  Rationals projector(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const cln::cl_RA& entry = turn(degree + orders[i], degree + orders[j]);
      projector(i, j) = ((i == j ? 1 : 0) - (result.negative ? -entry : entry)) / 2;
    }
  }
  const int rank = static_cast<int>(cln::cl_I_to_long(cln::numerator((size - cln::abs(trace)) / 2)));
  // The largest determinant gives the best-conditioned form.
  cln::cl_RA largest = 0;
  for (const std::vector<int>& pivots : choices(size, rank)) {
    Rationals reduce = chosen_rows(projector, pivots);
    const cln::cl_RA determinant = eliminate(reduce, pivots);
    if (determinant <= largest) continue;
    largest = determinant;
    result.expand = Surds(size, rank);
    result.reduce = Surds(rank, size);
    for (int i = 0; i < size; ++i) {
      for (int k = 0; k < rank; ++k) {
        const int pivot = pivots[k];
        const Surd ratio = symbolic::factor_ratio(degree, orders[i], orders[pivot]);
        result.expand(i, k) = ratio * Surd(2 * projector(i, pivot));
        result.reduce(k, i) = ratio.inverse() * Surd(reduce(k, i));
      }
    }
  }
  return result;
}

std::vector<Value> QuarterTurnClass::forward(SignedBuilder& build, const std::vector<Value>& v) const {
  if (!reflection_) return times(build, entries_, v);
  const std::vector<Value> reduced = times(build, reflection_->reduce, v);
  std::vector<Value> result;
  for (int i = 0; i < reflection_->expand.rows(); ++i) {
    std::vector<Value> terms{v[i]};
    for (int k = 0; k < reflection_->expand.columns(); ++k) {
      terms.push_back(build.times(-reflection_->expand(i, k), reduced[k]));
    }
    const Value moved = build.sum(terms);
    result.push_back(reflection_->negative ? -moved : moved);
  }
  return result;
}

std::vector<Value> QuarterTurnClass::backward(SignedBuilder& build, const std::vector<Value>& v) const {
  return reflection_ ? forward(build, v) : times(build, entries_.transposed(), v);
}

}  // namespace sh::codegen::recipes
