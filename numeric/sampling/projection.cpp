// See projection.hpp.
#include "numeric/sampling/projection.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/require.hpp"
#include "numeric/sampling/eigenvalues.hpp"

namespace sh::numeric {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kUnitTolerance = 1e-3;

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

void require_sample(std::size_t number, const SphereSample& s) {
  const std::string name = "fit_samples: sample " + std::to_string(number);
  if (!std::isfinite(s.value)) fail(name + ": expected a finite value, got " + std::to_string(s.value));
  if (!(s.weight >= 0) || !std::isfinite(s.weight)) {
    fail(name + ": expected a finite weight >= 0, got " + std::to_string(s.weight));
  }
  const double length = std::hypot(s.x, s.y, s.z);
  if (!(std::abs(length - 1) <= kUnitTolerance)) {
    fail(name + ": expected a direction of length 1 to within 0.001, got " + std::to_string(length));
  }
}

// out (bands^2) = the basis at a sample.
void basis_at(int degree, const SphereSample& s, double* out) {
  const double length = std::hypot(s.x, s.y, s.z);
  basis(degree, s.x / length, s.y / length, s.z / length, out);
}

// The upper triangle of the rows taken in so far, each sqrt(weight) (Y_0 .. Y_n-1, value): n + 1 columns.
class Triangle {
 public:
  explicit Triangle(Index columns) : rows_(MatrixXd::Zero(columns + std::max<Index>(columns, 256), columns)) {}

  // A row of length columns to be filled in.
  auto next_row() {
    if (used_ == rows_.rows()) reduce();
    return rows_.row(used_++);
  }

  MatrixXd finish() {
    reduce();
    return rows_.topRows(rows_.cols());
  }

 private:
  void reduce() {
    const Index columns = rows_.cols();
    const Eigen::HouseholderQR<MatrixXd> qr(rows_);
    rows_.setZero();
    rows_.topRows(columns) = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
    used_ = columns;
  }

  MatrixXd rows_;
  Index used_ = 0;
};

double condition_number(int degree, const MatrixXd& triangle, int samples) {
  const VectorXd singular = singular_values(triangle);
  const double threshold = singular(0) * std::numeric_limits<double>::epsilon() * samples;
  const Index rank = (singular.array() > threshold).count();
  if (rank < singular.size()) {
    fail("fit_samples: expected directions that determine the " + std::to_string(singular.size()) +
         " coefficients of degree " + std::to_string(degree) + ", got rank " + std::to_string(rank) +
         "; spread them over more of the sphere or lower the degree");
  }
  return singular(0) / singular(singular.size() - 1);
}

void find_residuals(int degree, std::span<const SphereSample> samples, LeastSquaresFit& fit) {
  std::vector<double> y(fit.coefficients.size());
  double squares = 0;
  double weights = 0;
  fit.residual_max = 0;
  fit.worst_sample = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].weight == 0) continue;
    basis_at(degree, samples[i], y.data());
    double residual = samples[i].value;
    for (std::size_t k = 0; k < y.size(); ++k) residual -= y[k] * fit.coefficients[k];
    squares += samples[i].weight * residual * residual;
    weights += samples[i].weight;
    if (std::abs(residual) > fit.residual_max) {
      fit.residual_max = std::abs(residual);
      fit.worst_sample = i;
    }
  }
  fit.residual_rms = std::sqrt(squares / weights);
}

}  // namespace

std::vector<double> project(int degree, std::span<const SphereNode<double>> nodes,
                            const std::function<double(double, double, double)>& f) {
  require_range("project: degree", degree, 0);
  std::vector<double> y(coefficient_count(degree));
  std::vector<double> sum(y.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto& [x_n, y_n, z_n, weight] = nodes[n];
    const double value = f(x_n, y_n, z_n);
    if (!std::isfinite(value))
      fail("project: node " + std::to_string(n) + ": expected a finite value, got " + std::to_string(value));
    basis(degree, x_n, y_n, z_n, y.data());
    for (std::size_t i = 0; i < y.size(); ++i) sum[i] += weight * value * y[i];
  }
  return sum;
}

LeastSquaresFit fit_samples(int degree, std::span<const SphereSample> samples) {
  require_range("fit_samples: degree", degree, 0);
  int count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    require_sample(i, samples[i]);
    if (samples[i].weight > 0) ++count;
  }
  const int unknowns = coefficient_count(degree);
  require_range("fit_samples: samples of weight > 0 for degree " + std::to_string(degree), count, unknowns);
  Triangle triangle(unknowns + 1);
  std::vector<double> y(unknowns + 1);
  for (const SphereSample& s : samples) {
    if (s.weight == 0) continue;
    basis_at(degree, s, y.data());
    y.back() = s.value;
    triangle.next_row() = std::sqrt(s.weight) * Eigen::Map<const Eigen::RowVectorXd>(y.data(), unknowns + 1);
  }
  const MatrixXd all = triangle.finish();
  const MatrixXd r = all.topLeftCorner(unknowns, unknowns);
  LeastSquaresFit fit{};
  fit.condition = condition_number(degree, r, count);
  const VectorXd solution = r.triangularView<Eigen::Upper>().solve(all.col(unknowns).head(unknowns));
  if (!solution.allFinite())
    fail("fit_samples: expected coefficients in the range of double, got an overflow; scale the values down");
  fit.coefficients.assign(solution.begin(), solution.end());
  find_residuals(degree, samples, fit);
  return fit;
}

}  // namespace sh::numeric
