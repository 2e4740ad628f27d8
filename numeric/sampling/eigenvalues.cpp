// Eigenvalues and singular values: eigenvalues.hpp.
#include "numeric/sampling/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace sh::numeric {

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  const Eigen::Index n = matrix.rows();
  Eigen::MatrixXd twice = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  twice.bottomLeftCorner(n, n) = matrix;
  twice.topRightCorner(n, n) = matrix.transpose();
  return symmetric_eigenvalues(twice).tail(n).reverse();
}

}  // namespace sh::numeric
