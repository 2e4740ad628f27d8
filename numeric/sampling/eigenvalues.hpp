// Eigenvalues and singular values by Eigen, compiled once, since its solver takes long to compile.
#pragma once

#include <Eigen/Core>

namespace sh::numeric {

/// Of a symmetric matrix, rising.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// Of a square matrix, falling: the upper half of the eigenvalues of (0 A^T; A 0), with an error of a few epsilon times
/// the largest [GolubVanLoan13] 8.6.1.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

}  // namespace sh::numeric
