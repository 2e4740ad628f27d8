// Reads directions and values from a table; see identify.hpp.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/identify/identify.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/sampling/directions.hpp"

namespace sh::numeric::identify {
namespace {

constexpr double kLengthTolerance = 1e-5;  // six printed digits, or float

std::array<double, 3> direction_of(const Table& table, const Row& row, bool normalize) {
  std::array<double, 3> d{};
  for (int i = 0; i < 3; ++i) {
    if (row.cells[i].imag() != 0) refuse(table.file, row.line, "expected a real direction, got complex numbers");
    d[i] = row.cells[i].real();
  }
  const double length = std::hypot(d[0], d[1], d[2]);
  if (length == 0) refuse(table.file, row.line, "expected a direction of length 1, got the zero vector");
  if (!normalize && !(std::abs(length - 1) <= kLengthTolerance)) {
    refuse(table.file, row.line,
           output::formatted("expected a direction of length 1 to within %g, got %.9g (--normalize scales directions)",
                             kLengthTolerance, length));
  }
  return normalized(d[0], d[1], d[2]);
}

// The degree with `count` functions, or -1.
int degree_with(std::size_t count) {
  for (int l = 0; l <= kMaxDegree; ++l) {
    if (count == static_cast<std::size_t>(coefficient_count(l))) return l;
  }
  return -1;
}

// How many of the functions of the degree the directions can tell apart.
int rank_of(const std::vector<std::array<double, 3>>& directions, int degree) {
  Eigen::MatrixXd values(coefficient_count(degree), static_cast<Eigen::Index>(directions.size()));
  Eigen::Index column = 0;
  for (const auto& [x, y, z] : directions) basis(degree, x, y, z, values.col(column++).data());
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(values);
  constexpr double kSmallest = 1e-6;  // relative to the largest pivot
  qr.setThreshold(kSmallest);
  return static_cast<int>(qr.rank());
}

void require_enough(const Samples& s) {
  const int needed = coefficient_count(s.degree);
  const int count = static_cast<int>(s.directions.size());
  const int rank = count < needed ? -1 : rank_of(s.directions, s.degree);
  if (rank == needed) return;
  refuse(s.file, 0,
         output::formatted("expected at least %d directions in general position to decide degree %d, such as `shcheck "
                           "identify --directions %d` prints, got %d",
                           needed, s.degree, 2 * needed + 16, count) +
             (rank < 0 ? "" : output::formatted(" that tell %d functions apart", rank)));
}

// The directions of the table, without values.
Samples directions_of(const Table& table, bool normalize) {
  Samples samples;
  samples.file = table.file;
  for (const Row& row : table.rows) {
    samples.lines.push_back(row.line);
    samples.directions.push_back(direction_of(table, row, normalize));
  }
  return samples;
}

// The columns after the direction; with `pairs`, two make one complex column.
Samples with_values(Samples samples, const Table& table, bool pairs) {
  for (std::size_t j = 3; j < table.rows.front().cells.size(); j += pairs ? 2 : 1) {
    auto& column = samples.columns.emplace_back();
    for (const Row& row : table.rows) {
      column.push_back(pairs ? std::complex<double>(row.cells[j].real(), row.cells[j + 1].real()) : row.cells[j]);
    }
  }
  return samples;
}

bool all_real(const Table& table) {
  return std::all_of(table.rows.begin(), table.rows.end(), [](const Row& row) {
    return std::all_of(row.cells.begin(), row.cells.end(), [](const auto& cell) { return cell.imag() == 0; });
  });
}

}  // namespace

std::vector<Samples> read_samples(const Table& table, bool normalize) {
  const std::size_t columns = table.rows.front().cells.size();
  const std::size_t values = columns < 3 ? 0 : columns - 3;
  const int whole = degree_with(values);
  const int half = values % 2 == 0 ? degree_with(values / 2) : -1;
  if (whole < 0 && half < 0) {
    refuse(table.file, table.rows.front().line,
           output::formatted("expected x,y,z and (L+1)^2 values, or 2 (L+1)^2 for an array with holes or for real and "
                             "imaginary parts, L from 0 to %d, got %zu columns",
                             kMaxDegree, columns));
  }
  Samples samples = directions_of(table, normalize);
  samples.degree = std::max(whole, half);
  require_enough(samples);
  if (whole >= 0) return {with_values(samples, table, false)};
  std::vector<Samples> ways;
  samples.is_array = true;
  ways.push_back(with_values(samples, table, false));
  samples.is_array = false;
  if (all_real(table)) ways.push_back(with_values(samples, table, true));
  return ways;
}

std::string suggested_directions(int count) {
  constexpr int kMost = 1'000'000;
  if (count < 1 || count > kMost) {
    throw std::invalid_argument(output::formatted("--directions: expected 1 to %d, got %d", kMost, count));
  }
  std::vector<Direction> special = axis_directions();
  for (const auto& d : diagonal_directions()) special.push_back(d);
  for (const auto& d : near_pole_directions()) {
    if (std::hypot(d.x, d.y) > 1e-12) special.push_back(d);
  }
  special.resize(std::min(special.size(), static_cast<std::size_t>(count) / 4));
  const int others = count - static_cast<int>(special.size());
  for (const auto& d : random_directions(others, 1)) special.push_back(d);
  const int degree = std::min(kMaxDegree, static_cast<int>(std::sqrt(others)) - 1);
  std::string text = "# directions for functions up to degree " + std::to_string(degree) +
                     "; append the values v0,v1,... of your functions to each line\nx,y,z\n";
  for (const auto& d : special) text += output::formatted("%.17g,%.17g,%.17g\n", d.x, d.y, d.z);
  return text;
}

}  // namespace sh::numeric::identify
