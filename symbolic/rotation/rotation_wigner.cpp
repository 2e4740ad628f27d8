// The second derivation of turns about y: Wigner's d matrix in closed form, over CLN rationals.
#include <cln/integer.h>

#include "symbolic/number/derivation.hpp"
#include "symbolic/rotation/rotation.hpp"

namespace sh::symbolic {
namespace {

cln::cl_I factorial(int n) { return cln::factorial(static_cast<unsigned>(n)); }

// sum_k (-1)^(m'-m+k) c^(2l+m-m'-2k) s^(m'-m+2k) / ((l+m-k)! k! (m'-m+k)! (l-m'-k)!): d without its root
Polynomial wigner_sum(int l, int row, int column) {
  Polynomial sum;
  for (int k = std::max(0, column - row); k <= std::min(l + column, l - row); ++k) {
    const int lift = row - column + k;
    const cln::cl_I denominator = factorial(l + column - k) * factorial(k) * factorial(lift) * factorial(l - row - k);
    sum.add_term({2 * l + column - row - 2 * k, lift + k}, cln::cl_RA(lift % 2 == 0 ? 1 : -1) / denominator);
  }
  return sum;
}

int sign(int order) { return order % 2 == 0 ? 1 : -1; }

}  // namespace

WignerEntry wigner_d(int degree, int row, int column) {
  require_degree("axis rotation", degree, kMaxAxisDegree, "exact entries grow with the degree");
  const cln::cl_I square =
      factorial(degree + column) * factorial(degree - column) * factorial(degree + row) * factorial(degree - row);
  return {Surd::square_root(cln::cl_RA(square)), wigner_sum(degree, row, column)};
}

// Real functions from complex ones with the Condon-Shortley phase: cos = ((-1)^m Y_m + Y_-m) / sqrt 2, sin alike with
// i sqrt 2. With d_(-m,-n) = (-1)^(m-n) d_mn the four terms pair up: D = (-1)^(m+n) d_mn +- (-1)^m d_(m,-n), plus for
// cosines, minus for sines. The root of d times k_n/k_m is rational: (l+m)! (l-n)!, halved in column 0.
Matrix<Polynomial> rotation_about_y_by_wigner(int degree) {
  require_degree("axis rotation", degree, kMaxAxisDegree, "exact entries grow with the degree");
  const int l = degree;
  Matrix<Polynomial> t(2 * l + 1, 2 * l + 1);
  for (int m = 0; m <= l; ++m) {
    for (int n = 0; n <= l; ++n) {
      const Polynomial direct = cln::cl_RA(sign(m + n)) * wigner_sum(l, m, n);
      const Polynomial mirrored = cln::cl_RA(sign(m)) * wigner_sum(l, m, -n);
      const cln::cl_RA root = factorial(l + m) * factorial(l - n) / cln::cl_RA(n == 0 ? 2 : 1);
      t(l + m, l + n) = root * (direct + mirrored);
      if (m > 0 && n > 0) t(l - m, l - n) = root * (direct - mirrored);
    }
  }
  return t;
}

}  // namespace sh::symbolic
