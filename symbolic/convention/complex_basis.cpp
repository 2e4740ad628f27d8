#include "symbolic/convention/complex_basis.hpp"

namespace sh::symbolic {

Matrix<RadicalSum> real_from_complex(int degree, bool condon_shortley) {
  const RadicalSum root_half(Surd::square_root(cln::cl_RA(1) / 2));
  const RadicalSum minus_i = -RadicalSum::imaginary_unit();
  Matrix<RadicalSum> w(2 * degree + 1, 2 * degree + 1);
  w(degree, degree) = RadicalSum(cln::cl_RA(1));
  for (int m = 1; m <= degree; ++m) {
    const RadicalSum phased = condon_shortley && m % 2 != 0 ? -root_half : root_half;
    w(degree + m, degree + m) = phased;
    w(degree + m, degree - m) = root_half;
    w(degree - m, degree + m) = minus_i * phased;
    w(degree - m, degree - m) = -(minus_i * root_half);
  }
  return w;
}

Matrix<RadicalSum> adjoint(const Matrix<RadicalSum>& m) {
  Matrix<RadicalSum> result(m.columns(), m.rows());
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < m.columns(); ++j) result(j, i) = m(i, j).conjugate();
  }
  return result;
}

}  // namespace sh::symbolic
