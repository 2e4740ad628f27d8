// Gradients, and the instances of basis.hpp for the types of real.hpp: multiprecision templates compile here, once.
#include "numeric/oracle/basis_impl.hpp"
#include "numeric/oracle/instances.hpp"

namespace sh::numeric {
namespace detail {

// The values of one degree as functions of cos(m phi) and sin(m phi), m >= 0, all in the scale of m > 0; 0 beyond the
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

// The same for the orders m - 1 to m + 1 alone, m >= 0.
template <class Real>
class ValuesNear {
 public:
  ValuesNear(int m, int degree, const Real& x, const Real& y, const Real& z) : first_(m > 0 ? m - 1 : 0) {
    using std::sqrt;
    std::array<AzimuthalPowers<Real>, 3> powers{AzimuthalPowers<Real>(x, y), {x, y}, {x, y}};
    for (int n = 0; n < first_; ++n) powers[0].next();
    for (std::size_t i = 1; i < 3; ++i) (powers[i] = powers[i - 1]).next();
    ReducedRows<Real>(degree).visit(degree, first_, z, Real(x * x + y * y), [&](int n, const Scaled<Real>& q) {
      if (n > m + 1) return;
      const int i = n - first_;
      cosine_[i] = powers[i].real_times(q);
      sine_[i] = powers[i].imaginary_times(q);
      if (n == 0) cosine_[i] *= sqrt(Real(2));
    });
  }

  [[nodiscard]] Real cosine(int m) const { return cosine_[m - first_]; }
  [[nodiscard]] Real sine(int m) const { return sine_[m - first_]; }

 private:
  int first_;
  std::array<Real, 3> cosine_{}, sine_{};  // 0 beyond the degree
};

// d/dx, d/dy, d/dz of the two functions of degree l and order +-m; for m = 0 only the cosine is a function.
template <class Real>
struct Derivatives {
  std::array<Real, 3> cosine, sine;
};

// Derivatives of degree l >= 1 from the values of degree l - 1. With Y^m the complex function of order m >= 0 (the
// phase of README.md) and k = (2l+1) / (2l-1):
//   d/dz Y_l^m           = sqrt(k (l-m)(l+m)) Y_(l-1)^m
//   (d/dx - i d/dy) Y_l^m = sqrt(k (l+m)(l+m-1)) Y_(l-1)^(m-1)
//   (d/dx + i d/dy) Y_l^m = -sqrt(k (l-m)(l-m-1)) Y_(l-1)^(m+1)
template <class Real, class Values>
Derivatives<Real> derivatives(int l, int m, const Values& below) {
  using std::sqrt;
  const auto factor = [l](long n) {
    return Real(sqrt(Real(static_cast<Real>((2L * l + 1) * n) / static_cast<Real>(2L * l - 1))));
  };
  const Real along = factor(static_cast<long>(l - m) * (l + m));
  const Real up = factor(static_cast<long>(l - m) * (l - m - 1)) / 2;
  if (m == 0) {
    const Real half_root = sqrt(Real(2)) / 2;
    return {{Real(-2 * half_root * up * below.cosine(1)), Real(-2 * half_root * up * below.sine(1)),
             Real(half_root * along * below.cosine(0))},
            {}};
  }
  const Real down = factor(static_cast<long>(l + m) * (l + m - 1)) / 2;
  return {{Real(down * below.cosine(m - 1) - up * below.cosine(m + 1)),
           Real(-down * below.sine(m - 1) - up * below.sine(m + 1)), Real(along * below.cosine(m))},
          {Real(down * below.sine(m - 1) - up * below.sine(m + 1)),
           Real(down * below.cosine(m - 1) + up * below.cosine(m + 1)), Real(along * below.sine(m))}};
}

template <class Real>
void differentiate_band(int l, const Real* values, Real* dx, Real* dy, Real* dz) {
  const BandValues<Real> below(values, l - 1);
  const auto put = [&](int i, const std::array<Real, 3>& derivative) {
    dx[i] = derivative[0];
    dy[i] = derivative[1];
    dz[i] = derivative[2];
  };
  for (int m = 0; m <= l; ++m) {
    const auto both = derivatives<Real>(l, m, below);
    put(coefficient_index(l, m), both.cosine);
    if (m > 0) put(coefficient_index(l, -m), both.sine);
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
std::array<Real, 3> basis_value_gradient(int degree, int order, const Real& x, const Real& y, const Real& z) {
  if (degree == 0) return {Real(0), Real(0), Real(0)};
  const int m = order < 0 ? -order : order;
  const auto both = detail::derivatives<Real>(degree, m, detail::ValuesNear<Real>(m, degree - 1, x, y, z));
  return order < 0 ? both.sine : both.cosine;
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

#define SHFORGE_INSTANCE(Real)                                                                                \
  template void basis<Real>(int, const Real&, const Real&, const Real&, Real*);                               \
  template void basis<Real>(int, const Real&, const Real&, const Real&, std::span<Real>);                     \
  template std::vector<Real> basis<Real>(int, const Real&, const Real&, const Real&);                         \
  template void basis_z_form<Real>(int, const Real&, const Real&, const Real&, Real*);                        \
  template Real basis_value<Real>(int, int, const Real&, const Real&, const Real&);                           \
  template std::array<Real, 3> normalized<Real>(const Real&, const Real&, const Real&);                       \
  template void basis_gradient<Real>(int, const Real&, const Real&, const Real&, Real*, Real*, Real*, Real*); \
  template std::array<Real, 3> basis_value_gradient<Real>(int, int, const Real&, const Real&, const Real&);   \
  template void basis_tangent_gradient<Real>(int, const Real&, const Real&, const Real&, Real*, Real*, Real*, Real*);

SHFORGE_FOR_EACH_REAL(SHFORGE_INSTANCE)

}  // namespace sh::numeric
