// Definitions of gradient.hpp, for who instantiates them on a Real of his own.
#pragma once

#include "numeric/basis_impl.hpp"
#include "numeric/gradient.hpp"

namespace sh::numeric {
namespace detail {

// Values of one degree as functions of cos(m phi) and sin(m phi), m >= 0, all in the scale of m > 0; 0 beyond the
// degree.
template <class Real>
class BandValues {
 public:
  BandValues(const Real* values, int degree) : values_(values), degree_(degree), root_two_(root(2)) {}

  [[nodiscard]] Real cosine(int m) const {
    if (m > degree_) return Real(0);
    return m == 0 ? Real(root_two_ * at(0)) : at(m);
  }
  [[nodiscard]] Real sine(int m) const { return m == 0 || m > degree_ ? Real(0) : at(-m); }

 private:
  static Real root(int n) {
    using std::sqrt;
    return sqrt(Real(n));
  }
  [[nodiscard]] const Real& at(int m) const { return values_[coefficient_index(degree_, m)]; }

  const Real* values_;
  int degree_;
  Real root_two_;
};

// Derivatives of degree l >= 1 from the values of degree l - 1. With Y^m the complex function of order m >= 0 (the
// phase of README.md) and k = (2l+1) / (2l-1):
//   d/dz Y_l^m           = sqrt(k (l-m)(l+m)) Y_(l-1)^m
//   (d/dx - i d/dy) Y_l^m = sqrt(k (l+m)(l+m-1)) Y_(l-1)^(m-1)
//   (d/dx + i d/dy) Y_l^m = -sqrt(k (l-m)(l-m-1)) Y_(l-1)^(m+1)
template <class Real>
void differentiate_band(int l, const Real* values, Real* dx, Real* dy, Real* dz) {
  using std::sqrt;
  const BandValues<Real> below(values, l - 1);
  const auto factor = [l](long n) {
    return Real(sqrt(Real(static_cast<Real>((2L * l + 1) * n) / static_cast<Real>(2L * l - 1))));
  };
  const Real half_root = sqrt(Real(2)) / 2;
  for (int m = 0; m <= l; ++m) {
    const auto cosine = coefficient_index(l, m);
    const auto sine = coefficient_index(l, -m);
    const Real along = factor(static_cast<long>(l - m) * (l + m));
    const Real up = factor(static_cast<long>(l - m) * (l - m - 1)) / 2;
    if (m == 0) {
      dx[cosine] = -2 * half_root * up * below.cosine(1);
      dy[cosine] = -2 * half_root * up * below.sine(1);
      dz[cosine] = half_root * along * below.cosine(0);
      continue;
    }
    const Real down = factor(static_cast<long>(l + m) * (l + m - 1)) / 2;
    dx[cosine] = down * below.cosine(m - 1) - up * below.cosine(m + 1);
    dx[sine] = down * below.sine(m - 1) - up * below.sine(m + 1);
    dy[cosine] = -down * below.sine(m - 1) - up * below.sine(m + 1);
    dy[sine] = down * below.cosine(m - 1) + up * below.cosine(m + 1);
    dz[cosine] = along * below.cosine(m);
    dz[sine] = along * below.sine(m);
  }
}

}  // namespace detail

template <class Real>
void basis_gradient(int degree, const Real& x, const Real& y, const Real& z, Real* out, Real* dx, Real* dy, Real* dz) {
  basis(degree, x, y, z, out);
  dx[0] = dy[0] = dz[0] = Real(0);
  for (int l = 1; l <= degree; ++l) detail::differentiate_band(l, out, dx, dy, dz);
}

template <class Real>
void basis_tangent_gradient(int degree, const Real& x, const Real& y, const Real& z, Real* out, Real* dx, Real* dy,
                            Real* dz) {
  basis_gradient(degree, x, y, z, out, dx, dy, dz);
  for (int l = 1; l <= degree; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      const Real along = static_cast<Real>(l) * out[i];
      dx[i] -= along * x;
      dy[i] -= along * y;
      dz[i] -= along * z;
    }
  }
}

}  // namespace sh::numeric
