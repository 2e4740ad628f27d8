#include "symbolic/basis/basis_ginac.hpp"

#include <cstdlib>

#include "symbolic/number/from_ginac.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;

struct Symbols {
  GiNaC::symbol x{"x"};
  GiNaC::symbol y{"y"};
  GiNaC::symbol z{"z"};
};

// d^(l+a)/dz^(l+a) (z^2 - 1)^l / (2^l l!)   [Rodrigues]
ex axial_part(const Symbols& v, int l, int a) {
  const ex derivative = GiNaC::pow(GiNaC::pow(v.z, 2) - 1, l).expand().diff(v.z, static_cast<unsigned>(l + a));
  return (derivative / (GiNaC::pow(GiNaC::numeric(2), l) * GiNaC::factorial(GiNaC::numeric(l)))).expand();
}

// ((x+iy)^a + (x-iy)^a)/2 or ((x+iy)^a - (x-iy)^a)/(2i)
ex azimuthal_part(const Symbols& v, int order) {
  const int a = std::abs(order);
  const ex plus = GiNaC::pow(v.x + GiNaC::I * v.y, a).expand();
  const ex minus = GiNaC::pow(v.x - GiNaC::I * v.y, a).expand();
  return (order < 0 ? (plus - minus) / (2 * GiNaC::I) : (plus + minus) / 2).expand();
}

// Each z^k of q gains (x^2+y^2+z^2)^((l-a-k)/2); k and l-a have the same parity.
ex homogenise(const Symbols& v, const ex& axial, int missing) {
  const ex r2 = GiNaC::pow(v.x, 2) + GiNaC::pow(v.y, 2) + GiNaC::pow(v.z, 2);
  ex sum = 0;
  for (int k = missing; k >= 0; k -= 2)
    sum += axial.coeff(v.z, k) * GiNaC::pow(v.z, k) * GiNaC::pow(r2, (missing - k) / 2);
  return sum.expand();
}

Surd closed_form_factor(int l, int a) {
  const GiNaC::numeric ratio = GiNaC::factorial(GiNaC::numeric(l - a)) / GiNaC::factorial(GiNaC::numeric(l + a));
  const GiNaC::numeric square = (a == 0 ? 1 : 2) * GiNaC::numeric(2 * l + 1, 4) * ratio;
  return Surd::square_root(cln::the<cln::cl_RA>(square.to_cl_N()), -1);
}

}  // namespace

BasisFunction basis_function_ginac(int degree, int order) {
  require_basis_index(degree, order);
  const int a = std::abs(order);
  const Symbols v;
  const std::vector<GiNaC::symbol> variables{v.x, v.y, v.z};
  const ex axial = axial_part(v, degree, a);
  const ex azimuthal = azimuthal_part(v, order);
  return {degree,
          order,
          closed_form_factor(degree, a),
          from_ginac(axial, variables),
          from_ginac(azimuthal, variables),
          from_ginac(homogenise(v, axial, degree - a) * azimuthal, variables)};
}

}  // namespace sh::symbolic
