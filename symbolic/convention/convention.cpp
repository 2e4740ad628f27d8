#include "symbolic/convention/convention.hpp"

#include <cln/integer.h>

#include <cstdlib>
#include <stdexcept>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/derivation.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/zonal/convolution.hpp"

namespace sh::symbolic {
namespace {

// [Malham03] table 1: the functions of ambiX with W = 1 times 1/sqrt 2, 1, then for |m| = 0, 1, ... the roots of these.
Surd fuma_size(int degree, int order) {
  static const std::vector<std::vector<cln::cl_RA>> kSquares{
      {cln::cl_RA(1) / 2},
      {1, 1},
      {1, cln::cl_RA(4) / 3, cln::cl_RA(4) / 3},
      {1, cln::cl_RA(45) / 32, cln::cl_RA(9) / 5, cln::cl_RA(8) / 5}};
  const cln::cl_RA schmidt = squared_factor(degree, order) / (2 * degree + 1);
  return Surd::square_root(schmidt * kSquares.at(static_cast<std::size_t>(degree)).at(std::abs(order)));
}

// 4 pi times the square of the orthonormal factor is (2 - delta) (2l+1) (l-a)!/(l+a)!.
Surd size_of(const Convention& c, int degree, int order) {
  const cln::cl_RA square = squared_factor(degree, order) / (c.complex && order != 0 ? 2 : 1);
  switch (c.normalization) {
    case Normalization::kOrthonormal:
      return Surd::square_root(square / 4, -1);
    case Normalization::kFourPi:
      return Surd::square_root(square);
    case Normalization::kSchmidt:
      return Surd::square_root(square / (2 * degree + 1));
    case Normalization::kSn3d:
      return Surd::square_root(square / (4 * (2 * degree + 1)), -1);
    case Normalization::kUnnormalized:
      return Surd(1);
    case Normalization::kFuMa:
      return fuma_size(degree, order);
    case Normalization::kPrimitive: {
      const BasisFunction f = basis_function(degree, order);
      return Surd(cln::recip(content(f.axial * f.azimuthal)));
    }
  }
  throw std::invalid_argument("convention: unknown normalization");
}

// Y' over the orthonormal function of the same kind, real or complex.
RadicalSum relative_factor(const Convention& c, int degree, int order) {
  Convention orthonormal = c;
  orthonormal.normalization = Normalization::kOrthonormal;
  const Surd ratio = size_of(c, degree, order) / size_of(orthonormal, degree, order);
  const bool negative = c.condon_shortley && !c.complex && order % 2 != 0;  // W carries the complex phase
  return RadicalSum(negative ? -ratio : ratio);
}

Matrix<RadicalSum> axes_matrix(const SignedPermutation& axes, int degree) {
  return surd_entries(degree, axes_band(axes, degree)).mapped([](const Surd& entry) { return RadicalSum(entry); });
}

}  // namespace

int largest_degree(const Convention& convention) {
  if (convention.folded == Folded::kCosineOverPi) return 2;
  return convention.normalization == Normalization::kFuMa ? 3 : kMaxConventionDegree;
}

void require_convention(const Convention& convention, int degree) {
  require_degree("convention", degree, kMaxConventionDegree, "exact band matrices are kept to there");
  const bool has_no_complex_form = convention.normalization == Normalization::kUnnormalized ||
                                   convention.normalization == Normalization::kPrimitive ||
                                   convention.normalization == Normalization::kFuMa;
  if (convention.complex && has_no_complex_form) {
    throw std::invalid_argument(
        "convention: complex functions: expected an orthonormal, 4-pi, Schmidt or SN3D normalization, got another");
  }
  const int largest = largest_degree(convention);
  if (convention.folded == Folded::kCosineOverPi)
    require_degree("convention with the clamped cosine folded in", degree, largest, "A_3 = 0 cannot be undone");
  if (convention.normalization == Normalization::kFuMa)
    require_degree("convention with Furse-Malham weights", degree, largest, "the format defines no more channels");
}

int storage_size(IndexOrder order, int max_degree) {
  const int bands = max_degree + 1;
  return order == IndexOrder::kCosineSineArray ? 2 * bands * bands : bands * bands;
}

int storage_position(IndexOrder order, int max_degree, int degree, int order_m) {
  const int a = std::abs(order_m);
  const int bands = max_degree + 1;
  switch (order) {
    case IndexOrder::kFuMa:
      if (degree == 1) return order_m == 0 ? 3 : order_m > 0 ? 1 : 2;
      return storage_position(IndexOrder::kZeroFirst, max_degree, degree, order_m);
    case IndexOrder::kAcn:
      return degree * (degree + 1) + order_m;
    case IndexOrder::kZeroFirst:
      return degree * degree + (order_m > 0 ? 2 * a - 1 : 2 * a);
    case IndexOrder::kCosineSineBands:
      return degree * degree + (order_m < 0 ? degree + a : a);
    case IndexOrder::kCosineSineArray:
      return ((order_m < 0 ? bands : 0) + degree) * bands + a;
  }
  throw std::invalid_argument("convention: unknown index order");
}

Surd convention_factor(const Convention& convention, int degree, int order) {
  const bool phased = convention.condon_shortley && order % 2 != 0 && (order > 0 || !convention.complex);
  const Surd size = size_of(convention, degree, order);
  return phased ? -size : size;
}

Matrix<RadicalSum> basis_change(const Convention& convention, int degree) {
  require_convention(convention, degree);
  Matrix<RadicalSum> change = axes_matrix(convention.axes, degree);
  if (convention.complex) change = adjoint(real_from_complex(degree, convention.condon_shortley)) * change;
  for (int i = 0; i < change.rows(); ++i) {
    const RadicalSum factor = relative_factor(convention, degree, i - degree);
    for (int j = 0; j < change.columns(); ++j) change(i, j) = factor * change(i, j);
  }
  return change;
}

ConventionFunction convention_function(const Convention& convention, int degree, int order) {
  require_convention(convention, degree);
  const Surd factor = convention_factor(convention, degree, order);
  if (!convention.complex) return {factor, basis_function(degree, order).homogeneous, {}};
  const int a = std::abs(order);
  const Polynomial cosine = basis_function(degree, a).homogeneous;
  const Polynomial sine = a == 0 ? Polynomial() : basis_function(degree, -a).homogeneous;
  return {factor, cosine, cln::cl_RA(order < 0 ? -1 : 1) * sine};
}

// Each step is orthogonal, unitary or diagonal, so no system is solved.
Matrix<RadicalSum> basis_change_inverse(const Convention& convention, int degree) {
  require_convention(convention, degree);
  Matrix<RadicalSum> inverse = axes_matrix(convention.axes, degree).transposed();
  if (convention.complex) inverse = inverse * real_from_complex(degree, convention.condon_shortley);
  for (int j = 0; j < inverse.columns(); ++j) {
    const RadicalSum factor = relative_factor(convention, degree, j - degree).inverse();
    for (int i = 0; i < inverse.rows(); ++i) inverse(i, j) = inverse(i, j) * factor;
  }
  return inverse;
}

Surd folded_factor(Folded folded, int degree) {
  if (folded == Folded::kNothing) return Surd(1);
  return irradiance_factor(degree) * Surd::square_root(1, -2);
}

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
  return m.transposed().mapped([](const RadicalSum& entry) { return entry.conjugate(); });
}

}  // namespace sh::symbolic
