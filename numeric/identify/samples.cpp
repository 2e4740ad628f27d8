// See samples.hpp.
#include "numeric/identify/samples.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/identify/convention.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/sampling/directions.hpp"

namespace sh::numeric::identify {
namespace {

std::string format(double value) { return output::formatted("%.9g", value); }

std::array<double, 3> direction_of(const Table& table, const Row& row, bool normalise) {
  std::array<double, 3> d{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (row.cells[i].imag() != 0) refuse_line(table.file, row.line, "the direction is not real");
    d[i] = row.cells[i].real();
  }
  const double length = std::hypot(d[0], d[1], d[2]);
  if (length == 0) refuse_line(table.file, row.line, "the direction is the zero vector; its length should be 1");
  if (!normalise && !(std::abs(length - 1) <= kLengthTolerance)) {
    refuse_line(table.file, row.line,
                "the direction has length " + format(length) + "; it should be 1 to within " +
                    format(kLengthTolerance) + " (--normalise scales directions)");
  }
  return normalised(d[0], d[1], d[2]);
}

// The degree with `count` functions, or -1.
int degree_with(std::size_t count) {
  for (int l = 0; l <= kMaxDegree; ++l) {
    if (static_cast<std::size_t>(coefficient_count(l)) == count) return l;
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
  const int rank = static_cast<int>(s.directions.size()) < needed ? -1 : rank_of(s.directions, s.degree);
  if (rank == needed) return;
  refuse_file(s.file, std::to_string(s.directions.size()) + " directions are too few to decide degree " +
                          std::to_string(s.degree) + ": " +
                          (rank < 0 ? "it" : "they tell only " + std::to_string(rank) + " functions apart; it") +
                          " should be at least " + std::to_string(needed) +
                          " in general position, such as `shcheck identify --directions " +
                          std::to_string(2 * needed + 16) + "` prints");
}

Samples without_values(const Table& table, bool normalise) {
  Samples samples;
  samples.file = table.file;
  for (const Row& row : table.rows) {
    samples.lines.push_back(row.line);
    samples.directions.push_back(direction_of(table, row, normalise));
  }
  return samples;
}

// The columns after the direction; with `pairs`, two make one complex column.
Samples with_values(Samples samples, const Table& table, bool pairs) {
  const std::size_t step = pairs ? 2 : 1;
  for (std::size_t j = 3; j < table.rows.front().cells.size(); j += step) {
    std::vector<std::complex<double>> column;
    for (const Row& row : table.rows) {
      column.push_back(pairs ? std::complex<double>(row.cells[j].real(), row.cells[j + 1].real()) : row.cells[j]);
    }
    samples.columns.push_back(std::move(column));
  }
  return samples;
}

bool all_real(const Table& table) {
  return std::all_of(table.rows.begin(), table.rows.end(), [](const Row& row) {
    return std::all_of(row.cells.begin(), row.cells.end(), [](const auto& cell) { return cell.imag() == 0; });
  });
}

}  // namespace

std::vector<Samples> read_samples(const Table& table, bool normalise) {
  const std::size_t columns = table.rows.front().cells.size();
  const std::size_t values = columns < 3 ? 0 : columns - 3;
  const int whole = degree_with(values);
  const int half = values % 2 == 0 ? degree_with(values / 2) : -1;
  if (whole < 0 && half < 0) {
    refuse_line(table.file, table.rows.front().line,
                std::to_string(columns) +
                    " columns; it should be x,y,z and (L+1)^2 values, or 2 (L+1)^2 for an array " +
                    "with holes or for real and imaginary parts, with L from 0 to " + std::to_string(kMaxDegree));
  }
  Samples samples = without_values(table, normalise);
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
    throw std::invalid_argument("--directions: " + std::to_string(count) + "; it should be 1 to " +
                                std::to_string(kMost));
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
