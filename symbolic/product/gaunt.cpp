#include "symbolic/product/gaunt.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/number/derivation.hpp"
#include "symbolic/number/from_ginac.hpp"

namespace sh::symbolic {
namespace {

using GiNaC::ex;
using Function = std::pair<int, int>;  // degree l and a = |m|

const GiNaC::symbol& symbol_z() {
  static const GiNaC::symbol z("z");
  return z;
}

// The integral over phi of three functions cos m phi or sin |m| phi, over pi: twice the coefficient of u^0 in their
// product, u = exp(i phi).
const cln::cl_RA& azimuthal_integral(const std::array<int, 3>& orders) {
  static std::map<std::array<int, 3>, cln::cl_RA> known;
  return remembered(known, orders, [&] {
    const GiNaC::symbol u("u");
    ex product = 2;
    for (const int m : orders) {
      const ex turn = GiNaC::pow(u, m);  // sin |m| phi = (u^-m - u^m) / 2i for m < 0
      product *= m < 0 ? (1 / turn - turn) / (2 * GiNaC::I) : (turn + 1 / turn) / 2;
    }
    return rational_from_ginac(product.expand().coeff(u, 0));
  });
}

// The integral over z of three q(z) and (1-z^2)^((a+b+c)/2), the product of three (x^2+y^2)^(a/2).
const cln::cl_RA& axial_integral(const std::array<Function, 3>& functions) {
  static std::map<std::array<Function, 3>, cln::cl_RA> known;
  return remembered(known, functions, [&] {
    const GiNaC::symbol& z = symbol_z();
    ex product = 1;
    int orders = 0;
    for (const auto& [degree, order] : functions) {
      product *= to_ginac(reduced_basis_function(degree, order).axial, {0, 0, z});
      orders += order;
    }
    product *= GiNaC::pow(1 - z * z, orders / 2);
    return rational_from_ginac(GiNaC::integral(z, -1, 1, product.expand()).eval_integ());
  });
}

GauntTensor tensor_of(int degree, Surd (*entry)(int, int, int)) {
  require_gaunt_degree(degree);
  const int count = numeric::coefficient_count(degree);
  GauntTensor tensor;
  for (int i = 0; i < count; ++i) {
    for (int j = i; j < count; ++j) {
      for (int k = j; k < count; ++k) {
        const Surd value = entry(i, j, k);
        if (!value.is_zero()) tensor.emplace_hint(tensor.end(), IndexTriple{i, j, k}, value);
      }
    }
  }
  return tensor;
}

}  // namespace

IndexTriple sorted(IndexTriple triple) {
  std::array<int, 3> indices{triple.i, triple.j, triple.k};
  std::sort(indices.begin(), indices.end());
  return {indices[0], indices[1], indices[2]};
}

bool gaunt_may_differ_from_zero(int i, int j, int k) {
  const DegreeOrder a = degree_order(i);
  const DegreeOrder b = degree_order(j);
  const DegreeOrder c = degree_order(k);
  const bool even = (a.degree + b.degree + c.degree) % 2 == 0;
  const bool triangle = std::abs(a.degree - b.degree) <= c.degree && c.degree <= a.degree + b.degree;
  const int negative = (a.order < 0 ? 1 : 0) + (b.order < 0 ? 1 : 0) + (c.order < 0 ? 1 : 0);
  std::array<int, 3> sizes{std::abs(a.order), std::abs(b.order), std::abs(c.order)};
  std::sort(sizes.begin(), sizes.end());
  return even && triangle && negative % 2 == 0 && sizes[0] + sizes[1] == sizes[2];
}

Surd gaunt(int i, int j, int k) {
  std::array<int, 3> orders{};
  std::array<Function, 3> functions;
  Surd factor = Surd::square_root(1, 2);  // pi
  for (std::size_t n = 0; n < 3; ++n) {
    const DegreeOrder y = degree_order(std::array<int, 3>{i, j, k}[n]);
    orders[n] = y.order;
    functions[n] = {y.degree, std::abs(y.order)};
  }
  std::sort(orders.begin(), orders.end());
  std::sort(functions.begin(), functions.end());
  const cln::cl_RA& around = azimuthal_integral(orders);
  if (cln::zerop(around)) return {};
  const cln::cl_RA& along = axial_integral(functions);
  if (cln::zerop(along)) return {};
  for (const auto& [degree, order] : functions) factor = factor * orthonormal_factor(degree, order);
  return factor * Surd(around * along);
}

GauntTensor gaunt_tensor(int degree) { return tensor_of(degree, gaunt); }
GauntTensor gaunt_by_wigner(int degree) { return tensor_of(degree, gaunt_entry_by_wigner); }

void require_gaunt_degree(int degree) {
  require_degree("Gaunt tensor", degree, kMaxGauntDegree, "the tensor grows with the fifth power");
}

}  // namespace sh::symbolic
