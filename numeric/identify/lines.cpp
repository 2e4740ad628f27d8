// What the lines of a table say before any convention is known: the values of each column are a sum of the functions of
// its degree, in whatever axes. See identify.hpp.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/identify/identify.hpp"
#include "numeric/oracle/basis.hpp"

namespace sh::numeric::identify {
namespace {

using Rows = std::vector<Eigen::Index>;

// The functions and the values at the rows; real and imaginary parts are columns of their own.
struct Tables {
  Eigen::MatrixXd functions;  // (rows, functions)
  Eigen::MatrixXd values;     // (rows, 2 columns)
};

Tables tables_of(const Samples& samples) {
  const auto rows = static_cast<Eigen::Index>(samples.directions.size());
  const auto columns = static_cast<Eigen::Index>(samples.columns.size());
  Tables tables{Eigen::MatrixXd(rows, coefficient_count(samples.degree)), Eigen::MatrixXd(rows, 2 * columns)};
  Eigen::VectorXd at(coefficient_count(samples.degree));
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto& [x, y, z] = samples.directions[static_cast<std::size_t>(row)];
    basis(samples.degree, x, y, z, at.data());
    tables.functions.row(row) = at;
    for (Eigen::Index j = 0; j < columns; ++j) {
      const auto& value = samples.columns[static_cast<std::size_t>(j)][static_cast<std::size_t>(row)];
      tables.values(row, 2 * j) = value.real();
      tables.values(row, 2 * j + 1) = value.imag();
    }
  }
  return tables;
}

// What remains of the values when the best sums of functions are subtracted.
struct Rest {
  Eigen::MatrixXd sums;      // (functions, 2 columns): the best sums
  Eigen::VectorXd left_out;  // of each row, the largest deviation from the sums that the other rows determine
  Eigen::VectorXd gain;      // of each row, the sum of squares that disappears without it
  double noise = 0;          // the root of the mean square in half of the columns, or less
};

// The median over the columns that hold anything; a wrong column says nothing about the others.
double noise_of(const Eigen::MatrixXd& rest, const Eigen::MatrixXd& values, Eigen::Index freedom) {
  std::vector<double> squares;
  for (Eigen::Index j = 0; j + 1 < values.cols(); j += 2) {
    if (values.middleCols(j, 2).cwiseAbs().maxCoeff() > 0) squares.push_back(rest.middleCols(j, 2).squaredNorm());
  }
  if (squares.empty()) return 0;
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return std::sqrt(*middle / static_cast<double>(freedom));
}

Rest rest_of(const Tables& tables, const Rows& rows) {
  const Eigen::MatrixXd functions = tables.functions(rows, Eigen::all);
  const Eigen::MatrixXd values = tables.values(rows, Eigen::all);
  const auto count = functions.cols();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(functions);
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(functions.rows(), count);
  const Eigen::MatrixXd rest = values - q * (q.transpose() * values);
  constexpr double kSmallest = 1e-6;  // a row that alone determines a function shows no deviation
  const Eigen::ArrayXd free = (1 - q.rowwise().squaredNorm().array()).max(kSmallest);
  return {qr.solve(values), rest.cwiseAbs().rowwise().maxCoeff().array() / free,
          rest.rowwise().squaredNorm().array() / free, noise_of(rest, values, functions.rows() - count)};
}

}  // namespace

Consistency consistency_of(const Samples& samples) {
  constexpr double kStandsOut = 8;      // times the noise of the other lines
  constexpr double kMostNoise = 0.01;   // of the largest value
  constexpr std::size_t kSpare = 3;     // lines beyond the functions, to judge by
  constexpr std::size_t kMostBad = 16;  // lines
  const Tables tables = tables_of(samples);
  const double largest = tables.values.cwiseAbs().maxCoeff();
  const std::size_t least = static_cast<std::size_t>(tables.functions.cols()) + kSpare;
  Rows rows(samples.directions.size());
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  Rows bad;
  while (rows.size() >= least && bad.size() <= kMostBad && 4 * bad.size() <= samples.directions.size()) {
    const Rest rest = rest_of(tables, rows);
    const double allowed = std::max(kRounded * largest, kStandsOut * rest.noise);
    if (rest.noise <= kMostNoise * largest && rest.left_out.maxCoeff() <= allowed) {
      Consistency result{rest.noise, {}};
      for (const Eigen::Index row : bad) {  // an early one may have been left out wrongly
        const auto off = tables.values.row(row) - tables.functions.row(row) * rest.sums;
        if (off.cwiseAbs().maxCoeff() > allowed) result.bad_rows.push_back(static_cast<std::size_t>(row));
      }
      return result;
    }
    Eigen::Index worst = 0;
    rest.gain.maxCoeff(&worst);
    bad.push_back(rows[static_cast<std::size_t>(worst)]);
    rows.erase(rows.begin() + worst);
  }
  return {};
}

Samples without_rows(const Samples& samples, std::vector<std::size_t> rows) {
  Samples result = samples;
  std::sort(rows.rbegin(), rows.rend());
  for (const std::size_t row : rows) {
    const auto at = static_cast<std::ptrdiff_t>(row);
    result.lines.erase(result.lines.begin() + at);
    result.directions.erase(result.directions.begin() + at);
    for (auto& column : result.columns) column.erase(column.begin() + at);
  }
  return result;
}

}  // namespace sh::numeric::identify
