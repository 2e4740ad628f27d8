// Comparisons that the proofs about rotations share.
#pragma once

#include <string>

#include "symbolic/proofs/identities.hpp"

namespace sh::symbolic {

inline std::string entry_name(int degree, int row, int column) {
  return "l=" + std::to_string(degree) + " entry (" + std::to_string(row - degree) + ", " +
         std::to_string(column - degree) + ")";
}

// T K^-2 T^T = scale K^-2; K^-2 up to a common factor.
template <class T>
void require_orthogonal(int degree, const Matrix<T>& t, const T& scale) {
  const int size = 2 * degree + 1;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j <= i; ++j) {
      T sum = T();
      for (int k = 0; k < size; ++k) sum = sum + cln::recip(squared_factor(degree, k - degree)) * (t(i, k) * t(j, k));
      const T expected = i == j ? T(cln::recip(squared_factor(degree, i - degree)) * scale) : T();
      if (!(sum == expected)) throw Refuted(entry_name(degree, i, j) + " of D D^T is wrong");
    }
  }
}

// Both matrices of a band are the same. Returns the number of bands, which is 1.
template <class T>
int require_same(int degree, const Matrix<T>& first, const Matrix<T>& second, const std::string& otherwise) {
  for (int i = 0; i < first.rows(); ++i) {
    for (int j = 0; j < first.columns(); ++j) {
      if (!(first(i, j) == second(i, j))) throw Refuted(entry_name(degree, i, j) + ": " + otherwise);
    }
  }
  return 1;
}

}  // namespace sh::symbolic
