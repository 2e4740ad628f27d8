// Exact arithmetic for deciding the formulas of [Green03]: functions of the polar angles, and projections by their
// definition as integrals.
//
// Convention: the project's (orthonormal, no Condon-Shortley phase, index l(l+1)+m, z polar); rational polynomials in
// x, y, z are variables 0, 1, 2. Nothing here knows a formula of the source.
#pragma once

#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/number/radical_sum.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata::exact {

/// A trigonometric polynomial in theta and phi: variables 0..3 are cos theta, sin theta, cos phi, sin phi, later ones
/// are free. Kept with both sines at most to the first power, so equal functions are equal term by term.
class Angular {
 public:
  Angular() = default;
  explicit Angular(const cln::cl_RA& constant) : normal_(constant) {}
  explicit Angular(const Polynomial& p);
  static Angular variable(int index) { return Angular(Polynomial::variable(index)); }

  [[nodiscard]] const Polynomial& normal() const { return normal_; }

  friend Angular operator+(const Angular& a, const Angular& b) { return Angular(a.normal_ + b.normal_); }
  friend Angular operator-(const Angular& a, const Angular& b) { return Angular(a.normal_ - b.normal_); }
  friend Angular operator*(const Angular& a, const Angular& b) { return Angular(a.normal_ * b.normal_); }
  friend bool operator==(const Angular& a, const Angular& b) { return a.normal_ == b.normal_; }

 private:
  Polynomial normal_;
};

/// Square roots that code takes: sin theta from its square, and the root of a rational number.
/// Throws std::domain_error for anything else.
Angular root(const Angular& square);
RadicalSum root(const RadicalSum& square);

/// Angles are pairs of cosine and sine.
template <class T>
T cos(const CosSin<T>& angle) {
  return angle.cosine;
}
template <class T>
T sin(const CosSin<T>& angle) {
  return angle.sine;
}
template <class T>
CosSin<T> operator+(const CosSin<T>& a, const CosSin<T>& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}
template <class T>
CosSin<T> operator-(const CosSin<T>& a, const CosSin<T>& b) {
  return a + CosSin<T>{b.cosine, T() - b.sine};
}
template <class T>
CosSin<T> operator*(int multiple, const CosSin<T>& angle) {
  CosSin<T> sum{T(cln::cl_RA(1)), T()};
  for (int i = 0; i < multiple; ++i) sum = sum + angle;
  for (int i = 0; i > multiple; --i) sum = sum - angle;
  return sum;
}

/// theta and phi themselves.
CosSin<Angular> theta();
CosSin<Angular> phi();

/// 1/(4 pi) INT_0^2pi INT_0^pi f sin(theta) dtheta dphi, by integrating over theta and phi one after the other.
/// Throws std::domain_error when f is not a polynomial in x, y, z.
cln::cl_RA angular_mean(const Angular& f);

/// An exact value with one irrational factor.
template <class T>
struct Scaled {
  Surd factor;
  T value;
};

/// Whether both are the same function or number.
template <class T>
bool same(const Scaled<T>& a, const Scaled<T>& b) {
  if (a.value == T() || b.value == T()) return a.value == b.value;
  const Surd ratio = a.factor / b.factor;
  return ratio.radicand() == 1 && ratio.pi_half_power() == 0 && T(ratio.rational()) * a.value == b.value;
}

/// Y_lm by the definition of symbolic/basis/basis.hpp, degree at most 10, in x, y, z and in theta, phi.
const BasisFunction& basis(int index);
Scaled<Angular> basis_of_angles(int degree, int order);

/// x^a y^b z^c with a + b + c <= degree.
std::vector<Polynomial> monomials(int degree);
/// Whether two polynomials agree wherever x^2 + y^2 + z^2 = 1.
bool equal_on_sphere(const Polynomial& a, const Polynomial& b);

/// INT f y_i ds and INT f y_i y_j ds.
Surd coefficient(const Polynomial& f, int i);
Surd coefficient(const Polynomial& f, int i, int j);
/// sum of (INT f y_i ds) y_i for first <= i <= last.
Polynomial projection(const Polynomial& f, int first, int last);
/// Whether that sum is f for every polynomial f of the degree.
bool reproduces(int degree, int first, int last);

/// D^m P_l in variable 0, from Rodrigues' formula; zero when m > l. The associated function without phase is
/// (1-x^2)^(m/2) times it.
Polynomial legendre_derivative(int l, int m);
/// The integral over [-1, 1] of a polynomial in variable 0.
cln::cl_RA integral_over_interval(const Polynomial& p, const cln::cl_RA& lower = -1, const cln::cl_RA& upper = 1);
/// (1 - x^2)^k in variable 0.
Polynomial one_minus_square(int k);

cln::cl_RA factorial(int n);
/// (-1)^n.
inline cln::cl_RA parity(int n) { return n % 2 == 0 ? 1 : -1; }

}  // namespace sh::symbolic::errata::exact
