#include "symbolic/number/polynomial.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/proofs/points.hpp"

namespace sh::symbolic {
namespace {

// The derivative by the angle: c' = -s, s' = c.
Polynomial by_angle(const Polynomial& p) {
  return Polynomial::variable(0) * p.derivative(1) - Polynomial::variable(1) * p.derivative(0);
}

// sum x_i d/dx_i
Polynomial euler(const Polynomial& p) {
  Polynomial sum;
  for (int axis = 0; axis < 3; ++axis) sum += Polynomial::variable(axis) * p.derivative(axis);
  return sum;
}

// The Laplacian on the sphere of p's values there: r^2 lap p - (E^2 + E) p with Euler's E.
Polynomial spherical_laplacian(const Polynomial& p) {
  Polynomial laplacian;
  Polynomial r2;
  for (int axis = 0; axis < 3; ++axis) {
    laplacian += p.derivative(axis).derivative(axis);
    r2 += Polynomial::variable(axis).power(2);
  }
  const Polynomial once = euler(p);
  return r2 * laplacian - euler(once) - once;
}

}  // namespace

int prove_window_angles(const std::vector<Polynomial>& hann, const std::vector<Polynomial>& sine) {
  const int count = static_cast<int>(hann.size());
  const std::array<cln::cl_RA, 2> start{1, 0};
  for (int l = 0; l < count; ++l) {
    const Polynomial cosine = cln::cl_RA(2) * hann[l] - Polynomial(1);
    const bool turns = by_angle(cosine) == cln::cl_RA(-l) * sine.at(l) && by_angle(sine[l]) == cln::cl_RA(l) * cosine;
    if (!turns || cosine.evaluate(start) != 1 || !cln::zerop(sine[l].evaluate(start))) {
      throw Refuted("the windows are not made of cos and sin of l angle" + at_degree(l));
    }
  }
  return count;
}

int prove_window_gaussian(const std::vector<int>& exponents) {
  const int count = static_cast<int>(exponents.size());
  for (int l = 0; l < count; ++l) {
    const bool holds = l < 2 ? exponents[l] == l : exponents[l] + exponents[l - 2] == 2 + 2 * exponents[l - 1];
    if (!holds) throw Refuted("the logarithm of the window is not quadratic" + at_degree(l));
  }
  return count;
}

int prove_window_laplacian(const std::vector<cln::cl_RA>& penalties, const Basis& basis) {
  for (const BasisFunction& y : basis) {
    const Polynomial form = y.axial * y.azimuthal;
    const Polynomial twice = spherical_laplacian(spherical_laplacian(form));
    if (!reduce_on_sphere(twice - penalties.at(y.degree) * form).is_zero()) {
      throw Refuted(y.name() + ": the squared Laplacian has another eigenvalue");
    }
  }
  return static_cast<int>(basis.size());
}

}  // namespace sh::symbolic
