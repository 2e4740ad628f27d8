#include "symbolic/basis/basis.hpp"

#include <cln/integer.h>

#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>

#include "numeric/oracle/index.hpp"
#include "symbolic/number/derivation.hpp"
#include "symbolic/number/from_ginac.hpp"
#include "symbolic/number/polynomial.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;

const std::vector<GiNaC::symbol>& coordinates() {
  static const std::vector<GiNaC::symbol> xyz{GiNaC::symbol("x"), GiNaC::symbol("y"), GiNaC::symbol("z")};
  return xyz;
}

// d^a P_l / dz^a for a = 0..l
const std::vector<Polynomial>& axial_parts(int l) {
  static std::map<int, std::vector<Polynomial>> known;
  return remembered(known, l, [l] {
    std::vector<Polynomial> parts{legendre_polynomial(l, 2)};
    while (static_cast<int>(parts.size()) <= l) parts.push_back(parts.back().derivative(2));
    return parts;
  });
}

// Re or Im of (x + iy)^a
Polynomial azimuthal_part(int order) {
  const ex power = GiNaC::pow(coordinates()[0] + GiNaC::I * coordinates()[1], std::abs(order));
  ComplexPolynomial parts = complex_from_ginac(power, coordinates());
  return order < 0 ? parts.im : parts.re;
}

// Each z^k of q gains (x^2+y^2+z^2)^((l-a-k)/2); k and l-a have the same parity.
Polynomial homogeneous_form(const BasisFunction& f) {
  const std::vector<ex> xyz(coordinates().begin(), coordinates().end());
  const ex r2 = GiNaC::pow(xyz[0], 2) + GiNaC::pow(xyz[1], 2) + GiNaC::pow(xyz[2], 2);
  const int missing = f.degree - std::abs(f.order);
  ex sum = 0;
  for (const auto& [monomial, coefficient] : f.axial.terms()) {
    const int k = monomial.exponent(2);
    sum += GiNaC::numeric(coefficient) * GiNaC::pow(xyz[2], k) * GiNaC::pow(r2, (missing - k) / 2);
  }
  return from_ginac(sum.expand() * to_ginac(f.azimuthal, xyz), coordinates());
}

}  // namespace

DegreeOrder degree_order(int index) {
  int degree = 0;
  while (numeric::coefficient_count(degree) <= index) ++degree;
  return {degree, index - degree * (degree + 1)};
}

void require_basis_index(int degree, int order) {
  require_degree("basis", degree, kMaxBasisDegree, "exponents of a product of two functions stay below 128");
  if (std::abs(order) > degree) {
    throw std::invalid_argument("basis: order " + std::to_string(order) + " at degree " + std::to_string(degree) +
                                "; it should be -degree to degree");
  }
}

cln::cl_RA squared_factor(int degree, int order) {
  const int a = std::abs(order);
  const cln::cl_I below = cln::factorial(static_cast<unsigned>(degree - a));
  const cln::cl_I above = cln::factorial(static_cast<unsigned>(degree + a));
  return (order == 0 ? 1 : 2) * (2 * degree + 1) * (below / cln::cl_RA(above));
}

const Surd& orthonormal_factor(int degree, int order) {
  static std::map<std::pair<int, int>, Surd> known;
  return remembered(known, {degree, std::abs(order)},
                    [&] { return Surd::square_root(squared_factor(degree, order) / 4, -1); });
}

Surd factor_ratio(int degree, int row_order, int column_order) {
  return Surd::square_root(squared_factor(degree, row_order) / squared_factor(degree, column_order));
}

BasisFunction reduced_basis_function(int degree, int order) {
  require_basis_index(degree, order);
  static std::map<int, Polynomial> azimuthal;
  return {degree,
          order,
          orthonormal_factor(degree, order),
          axial_parts(degree)[std::abs(order)],
          remembered(azimuthal, order, [order] { return azimuthal_part(order); }),
          {}};
}

const BasisFunction& basis_function(int degree, int order) {
  static std::map<int, BasisFunction> known;
  require_basis_index(degree, order);
  return remembered(known, coefficient_index(degree, order), [&] {
    BasisFunction f = reduced_basis_function(degree, order);
    f.homogeneous = homogeneous_form(f);
    return f;
  });
}

}  // namespace sh::symbolic
