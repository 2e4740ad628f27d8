#include "prt/light/sphere_extremes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "generated/cpp/basis_gradient.hpp"
#include "generated/cpp/evaluate.hpp"
#include "numeric/sampling/sphere_nodes.hpp"
#include "prt/basis.hpp"
#include "prt/light/light_coefficients.hpp"

namespace sh::prt {
namespace {

constexpr int kStarts = 12;  // valleys that are searched

/// A function and its gradient along the sphere.
class Descent {
 public:
  Descent(std::vector<double> c, int degree) : c_(std::move(c)), degree_(degree) {}

  [[nodiscard]] SphereValue from(const Eigen::Vector3d& start) const {
    SphereValue best{value(start), start};
    const double reach = 0.5 / (degree_ + 1);
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3d step = newton_step(best.direction, reach);
      if (!lower(step, best)) break;
    }
    return best;
  }

 private:
  [[nodiscard]] double value(const Eigen::Vector3d& d) const {
    double sum = 0.0;
    at_degree(degree_, [&](auto known) { sum = sh::evaluate<known()>(c_.data(), d.x(), d.y(), d.z()); });
    return sum;
  }

  [[nodiscard]] Eigen::Vector3d gradient(const Eigen::Vector3d& d) const {
    BasisValues y, dx, dy, dz;
    at_degree(degree_, [&](auto known) {
      sh::basis_gradient<known()>(d.x(), d.y(), d.z(), y.data(), dx.data(), dy.data(), dz.data());
    });
    const auto sum = [&](const BasisValues& by) { return std::inner_product(c_.begin(), c_.end(), by.begin(), 0.0); };
    const Eigen::Vector3d full(sum(dx), sum(dy), sum(dz));
    return full - full.dot(d) * d;
  }

  /// A downhill step: Newton's step with positive curvatures, no longer than `reach`.
  [[nodiscard]] Eigen::Vector3d newton_step(const Eigen::Vector3d& d, double reach) const {
    constexpr double kDifference = 1e-5;
    Eigen::Matrix<double, 3, 2> frame;
    frame.col(0) = d.unitOrthogonal();
    frame.col(1) = d.cross(frame.col(0));
    Eigen::Matrix2d curvature;
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d ahead = (d + kDifference * frame.col(i)).normalized();
      const Eigen::Vector3d behind = (d - kDifference * frame.col(i)).normalized();
      curvature.col(i) = frame.transpose() * (gradient(ahead) - gradient(behind)) / (2.0 * kDifference);
    }
    const Eigen::Vector2d slope = frame.transpose() * gradient(d);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(0.5 * (curvature + curvature.transpose()));
    const Eigen::Vector2d along = solver.eigenvectors().transpose() * slope;
    const double least = 1e-6 * solver.eigenvalues().cwiseAbs().maxCoeff();
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    for (int i = 0; i < 2; ++i) {
      const double bend = std::max(std::abs(solver.eigenvalues()[i]), least);
      step[i] = bend > 0.0 ? -along[i] / bend : 0.0;
    }
    const double length = step.norm();
    return frame * solver.eigenvectors() * (length > reach ? Eigen::Vector2d(step * (reach / length)) : step);
  }

  /// Tries the step and up to ten halvings of it. True if one leads lower; then `best` is there.
  bool lower(Eigen::Vector3d step, SphereValue& best) const {
    for (int i = 0; i < 10; ++i, step *= 0.5) {
      const Eigen::Vector3d there = (best.direction + step).normalized();
      const double value_there = value(there);
      if (value_there < best.value) {
        best = {value_there, there};
        return step.norm() > 1e-9;
      }
    }
    return false;
  }

  std::vector<double> c_;
  int degree_;
};

/// The lowest points that are not near each other.
std::vector<Eigen::Vector3d> starts(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& values,
                                    double sign, int degree) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return sign * values[a] < sign * values[b]; });
  const double apart = std::cos(0.8 / (degree + 1));
  std::vector<Eigen::Vector3d> out;
  for (std::size_t k = 0; k < order.size() && out.size() < kStarts; ++k) {
    const Eigen::Vector3d& d = points[order[k]];
    if (std::none_of(out.begin(), out.end(), [&](const auto& other) { return other.dot(d) > apart; })) out.push_back(d);
  }
  return out;
}

}  // namespace

BandLimited::BandLimited(const double* coefficients, int degree)
    : degree_(degree), coefficients_(coefficients, coefficients + coefficient_count(degree)) {
  BasisValues y;
  for (const auto& node : numeric::fibonacci_nodes(64 * (degree + 1) * (degree + 1))) {
    points_.emplace_back(node.x, node.y, node.z);
    evaluate_basis(degree, node.x, node.y, node.z, y.data());
    for (int l = 0; l <= degree; ++l) {
      band_values_.push_back((band(coefficients_.data(), l) * band(y.data(), l)).sum());
    }
  }
}

std::vector<double> BandLimited::values(const std::vector<double>& factors) const {
  std::vector<double> out;
  out.reserve(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto bands = band_values_.begin() + static_cast<std::ptrdiff_t>(k * factors.size());
    out.push_back(std::inner_product(factors.begin(), factors.end(), bands, 0.0));
  }
  return out;
}

SphereValue BandLimited::extreme(const std::vector<double>& factors, double sign) const {
  std::vector<double> c = coefficients_;
  scale_bands(factors, c.data());
  as_array(c) *= sign;
  const Descent descent(std::move(c), degree_);
  SphereValue best{std::numeric_limits<double>::infinity()};
  for (const Eigen::Vector3d& start : starts(points_, values(factors), sign, degree_)) {
    const SphereValue found = descent.from(start);
    best = found.value < best.value ? found : best;
  }
  return {sign * best.value, best.direction};
}

}  // namespace sh::prt
