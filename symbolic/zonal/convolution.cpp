#include "symbolic/zonal/convolution.hpp"

#include <cln/integer.h>

#include <stdexcept>
#include <string>

#include "symbolic/number/derivation.hpp"
#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {
namespace {

Surd times_pi(const cln::cl_RA& rational) { return Surd(rational) * Surd::square_root(1, 2); }

}  // namespace

Surd convolution_factor(int degree) {
  if (degree < 0) {
    throw std::invalid_argument("convolution factor: degree " + std::to_string(degree) + "; it should be 0 or more");
  }
  return Surd::square_root(cln::cl_RA(4) / (2 * degree + 1), 1);
}

std::vector<TurnedZonal> turned_zonal(int degree) {
  require_basis_index(degree, 0);
  std::vector<TurnedZonal> entries;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const BasisFunction& y = basis_function(l, m);
      entries.push_back({l, m, convolution_factor(l) * y.factor, y.homogeneous});
    }
  }
  return entries;
}

Surd irradiance_factor(int degree) {
  if (degree < 0) {
    throw std::invalid_argument("irradiance factor: degree " + std::to_string(degree) + "; it should be 0 or more");
  }
  if (degree == 1) return times_pi(cln::cl_RA(2) / 3);
  if (degree % 2 != 0) return {};
  const int half = degree / 2;
  const cln::cl_I central = cln::binomial(static_cast<unsigned>(degree), static_cast<unsigned>(half));
  const cln::cl_RA size = cln::cl_RA(2 * central) / ((cln::cl_I(degree) + 2) * (degree - 1));
  return times_pi((half % 2 == 0 ? -size : size) / cln::ash(cln::cl_I(1), degree));
}

Surd irradiance_factor_integral(int degree) {
  require_degree("irradiance factor", degree, kMaxIrradianceDegree, "exponents stay below 128");
  const Polynomial t = Polynomial::variable(0);
  const Polynomial moment = definite_integral(t * legendre_polynomial(degree, 0), 0, Polynomial(), Polynomial(1));
  return times_pi(2 * moment.coefficient({}));
}

}  // namespace sh::symbolic
