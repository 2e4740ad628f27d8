#include "symbolic/rotation/quaternion_rotation.hpp"

#include "symbolic/basis/normalisation.hpp"

namespace sh::symbolic {

Matrix<Polynomial> quaternion_matrix() {
  return matrix_from_quaternion<Polynomial>(
      {Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2), Polynomial::variable(3)});
}

Matrix<cln::cl_RA> evaluate(const QuaternionRotation& rotation, const std::array<cln::cl_RA, 4>& q) {
  const int size = rotation.entries.rows();
  Matrix<cln::cl_RA> result(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) result(i, j) = rotation.entries(i, j).evaluate(q);
  }
  return result;
}

Matrix<Surd> surd_entries(int degree, const Matrix<cln::cl_RA>& rational) {
  Matrix<Surd> result(rational.rows(), rational.columns());
  for (int i = 0; i < rational.rows(); ++i) {
    for (int j = 0; j < rational.columns(); ++j) {
      result(i, j) = factor_ratio(degree, i - degree, j - degree) * Surd(rational(i, j));
    }
  }
  return result;
}

}  // namespace sh::symbolic
