// Functions on the unit sphere as the sources write them: polynomials in x, y, z (variables 0, 1, 2, and further ones)
// whose coefficients are real sums of surds, so that a transcription of a formula or of code can be run on them.
//
// Convention: orthonormal, no Condon-Shortley phase, z polar, index l(l+1)+m; the independent side of a decision is the
// homogeneous form of symbolic/basis/basis.hpp. Integrals are those of monomials over the sphere [Folland01].
#pragma once

#include <map>
#include <span>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/polynomial.hpp"
#include "symbolic/number/radical_sum.hpp"

namespace sh::symbolic::errata::sphere {

class SphereFunction {
 public:
  /// One rational polynomial for each radical.
  using Parts = std::map<RadicalSum::Radical, Polynomial>;

  SphereFunction() = default;
  explicit SphereFunction(const cln::cl_RA& constant) : SphereFunction(Surd(constant)) {}
  explicit SphereFunction(const Surd& factor, const Polynomial& p = Polynomial(1));
  /// A constant; throws std::invalid_argument when it is not real.
  explicit SphereFunction(const RadicalSum& constant);
  static SphereFunction variable(int index) { return SphereFunction(Surd(1), Polynomial::variable(index)); }

  [[nodiscard]] const Parts& parts() const { return parts_; }
  [[nodiscard]] bool is_zero() const { return parts_.empty(); }
  /// The value at a point: one number for each variable that occurs.
  [[nodiscard]] RadicalSum at(std::span<const RadicalSum> point) const;
  /// The same function with polynomials put in for variables 0, 1, ...
  [[nodiscard]] SphereFunction substituted(std::span<const Polynomial> values) const;
  /// f(R s) for a matrix R (3, 3).
  [[nodiscard]] SphereFunction turned(const Matrix<cln::cl_RA>& r) const;

  SphereFunction operator-() const { return SphereFunction(-1) * *this; }
  friend SphereFunction operator+(const SphereFunction& a, const SphereFunction& b);
  friend SphereFunction operator-(const SphereFunction& a, const SphereFunction& b) { return a + -b; }
  friend SphereFunction operator*(const SphereFunction& a, const SphereFunction& b);
  /// Equal as polynomials.
  friend bool operator==(const SphereFunction& a, const SphereFunction& b) { return a.parts_ == b.parts_; }

 private:
  void add(const RadicalSum::Radical& radical, const Polynomial& p);
  Parts parts_;
};

/// Equal wherever x^2 + y^2 + z^2 = 1.
bool equal_on_sphere(const SphereFunction& a, const SphereFunction& b);

/// Y_lm of symbolic/basis/basis.hpp, homogeneous form, and all of degree 0..degree.
SphereFunction spherical_harmonic(int degree, int order);
std::vector<SphereFunction> spherical_harmonics(int degree);

/// The integral of f over the unit sphere of variables first, first+1, first+2; the others stay.
SphereFunction integral_over_sphere(const SphereFunction& f, int first);
/// The same where nothing but x, y, z occurs.
RadicalSum sphere_integral(const SphereFunction& f);
/// The integral over the part lower < z < upper of the sphere.
RadicalSum zone_integral(const SphereFunction& f, const cln::cl_RA& lower, const cln::cl_RA& upper);

/// (f * h)(t) = integral f(w) h(w.t) dw; h holds z alone, which stands for w.t.
SphereFunction convolved(const SphereFunction& f, const SphereFunction& h);
/// Y_l0 as a polynomial in z alone.
SphereFunction zonal_harmonic(int degree);

/// Coefficients (integral of f Y_i) of degree 0..degree, and the sum of coefficients times Y_i.
std::vector<RadicalSum> projection(const SphereFunction& f, int degree);
SphereFunction expansion(const std::vector<RadicalSum>& coefficients);
/// Rational numbers without a pattern, one for each function of degree 0..degree.
std::vector<RadicalSum> some_coefficients(int degree, int seed);

/// The dimension of the span, as polynomials. On the sphere: of their normal forms.
int rank(const std::vector<Polynomial>& polynomials);
int rank_on_sphere(const std::vector<Polynomial>& polynomials);
/// x^a y^b z^c, a + b + c <= degree.
std::vector<Polynomial> monomials(int degree);

/// With cos p, sin p, cos t, sin t in variables 0..3: every squared cosine becomes 1 - sine^2.
Polynomial reduce_squared_cosines(const Polynomial& p);

/// A rotation by no special angle about no special axis, rational.
Matrix<cln::cl_RA> some_rotation();

}  // namespace sh::symbolic::errata::sphere
