// The domains that families share: directions and coefficient vectors, with the units of their errors.
#pragma once

#include <array>
#include <utility>

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// The domain of kernels with inputs x, y, z, |d| = 1, and with basis functions in order as outputs (output i belongs
/// to band floor(sqrt(i))).
Domain direction_domain();

/// `count` random vectors of `size` numbers scaled to length 1, the same in every run: coefficients to test with.
std::vector<std::vector<double>> unit_vectors(int count, int size, unsigned long seed);

/// Row by row: each row of `rows` and then the same row of `more`. The rows of `more` are vectors or directions; there
/// are at least as many as in `rows`.
template <class T, class Row>
std::vector<std::vector<T>> joined(std::vector<std::vector<T>> rows, const std::vector<Row>& more) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].insert(rows[i].end(), more[i].begin(), more[i].end());
  return rows;
}

/// The same with directions first.
template <class T, class Row>
std::vector<std::vector<T>> joined(const std::vector<std::array<T, 3>>& directions, const std::vector<Row>& more) {
  std::vector<std::vector<T>> rows;
  for (const auto& d : directions) rows.emplace_back(d.begin(), d.end());
  return joined(std::move(rows), more);
}

/// The Euclidean length.
double length(std::span<const double> vector);

/// A selection of `count` test directions. It contains axes, poles and directions near them.
std::vector<std::array<double, 3>> some_test_directions(std::size_t count);

/// `count` values of 1 - cos(half-angle) in (0, 2): a third near 0, a third near 2, the same in every run.
std::vector<double> cap_sizes(int count, unsigned long seed);

/// `count` exact vectors of `size` small rationals, the same in every run.
std::vector<std::vector<cln::cl_RA>> rational_vectors(int count, int size, unsigned long seed);

}  // namespace sh::codegen
