// Recipes for one set of coefficients and many directions: compute the coefficients of a polynomial once, then use
// Horner's rule.
//
// On the unit sphere, z^2 = 1-x^2-y^2 removes all higher powers of z. Therefore every function of bands 0 to L is
// p(x,y) + z q(x,y) for exactly one p of degree L and one q of degree L-1, with (L+1)^2 coefficients together. Horner's
// rule in x, with coefficients that are polynomials in y, gives the value in (L+1)^2 - 1 steps. Each step is one
// multiplication and one addition, without constants.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "codegen/measure/directions.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {
namespace {

using cln::cl_RA;
using symbolic::Polynomial;
using symbolic::Surd;

constexpr const char* kSource = "z^2 = 1-x^2-y^2 applied exactly; Horner's rule in x and y";

// x^2 + y^2
Polynomial across() {
  Polynomial result;
  result.add_term({2, 0, 0}, 1);
  result.add_term({0, 2, 0}, 1);
  return result;
}

std::string monomial_name(int i, int j, bool with_z) {
  return "x^" + std::to_string(i) + " y^" + std::to_string(j) + (with_z ? " z" : "");
}

// Calls f(i, j, with_z) in the order of polynomial_index.
template <class F>
void for_each_monomial(int degree, const F& f) {
  for (const bool with_z : {false, true}) {
    const int most = degree - (with_z ? 1 : 0);
    for (int i = most; i >= 0; --i) {
      for (int j = most - i; j >= 0; --j) f(i, j, with_z);
    }
  }
}

// The largest error from rounding the stored coefficients, in eps x |c| x sqrt((2l+1)/(4 pi)).
double storage_error(int degree) {
  const std::vector<double>& norms = polynomial_norms(degree);
  double largest = 0;
  for (const auto& d : test_directions()) {
    double sum = 0;
    for_each_monomial(degree, [&](int i, int j, bool with_z) {
      double monomial = with_z ? std::abs(d[2]) : 1;
      for (int k = 0; k < i; ++k) monomial *= std::abs(d[0]);
      for (int k = 0; k < j; ++k) monomial *= std::abs(d[1]);
      sum += monomial * norms[polynomial_index(degree, i, j, with_z)];
    });
    largest = std::max(largest, sum);
  }
  return largest / 2 / std::sqrt((2 * degree + 1) / (4 * std::numbers::pi));
}

}  // namespace

int polynomial_index(int degree, int i, int j, bool with_z) {
  const int most = degree - (with_z ? 1 : 0);
  const int first = with_z ? (degree + 1) * (degree + 2) / 2 : 0;
  return first + (most - i) * (most - i + 1) / 2 + most - i - j;
}

std::vector<std::vector<Surd>> polynomial_matrix(int degree) {
  const int count = coefficient_count(degree);
  std::vector<std::vector<Surd>> matrix(count, std::vector<Surd>(count));
  Polynomial without_z(cl_RA(1));
  without_z -= across();
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const symbolic::BasisFunction f = symbolic::reduced_basis_function(l, m);
      Polynomial reduced;
      for (const auto& [monomial, coefficient] : f.axial.terms()) {
        const int power = monomial.exponent(2);
        Polynomial z(coefficient);
        if (power % 2 != 0) z = z * Polynomial::variable(2);
        reduced += z * without_z.power(power / 2) * f.azimuthal;
      }
      for (const auto& [monomial, coefficient] : reduced.terms()) {
        const int row = polynomial_index(degree, monomial.exponent(0), monomial.exponent(1), monomial.exponent(2) > 0);
        matrix[row][coefficient_index(l, m)] = Surd(coefficient) * f.factor;
      }
    }
  }
  return matrix;
}

const std::vector<double>& polynomial_norms(int degree) {
  static std::map<int, std::vector<double>> known;
  std::vector<double>& norms = known[degree];
  if (!norms.empty()) return norms;
  for (const auto& row : polynomial_matrix(degree)) {
    double square = 0;
    for (const Surd& entry : row) square += std::pow(cln::double_approx(entry.evaluate(20)), 2);
    norms.push_back(std::sqrt(square));
  }
  return norms;
}

Kernel evaluate_prepare(int degree) {
  symbolic::require_basis_index(degree, 0);
  Kernel kernel;
  kernel.title = "A function with bands 0 to " + std::to_string(degree) +
                 " as a polynomial in the direction, for evaluate_prepared_l" + std::to_string(degree);
  kernel.domain = "any c; coefficients of the orthonormal Y_lm, no Condon-Shortley phase, at index l(l+1)+m";
  kernel.result =
      "coefficients of x^i y^j by falling i, then falling j, then those of z x^i y^j likewise; see the labels";
  kernel.citation = kSource;
  kernel.factored = true;
  kernel.parameters = {array(Role::kEvaluatedCoefficients, "c", degree)};
  kernel.results = {array(Role::kPolynomial, "polynomial", degree)};
  Builder build(kernel);
  std::vector<NodeId> sums(coefficient_count(degree), -1);
  for (int m = -degree; m <= degree; ++m) {
    const int order = std::abs(m);
    for (int parity = 0; parity < 2 && order + parity <= degree; ++parity) {
      // The coefficients of (x^2+y^2)^k in the factor of Re or Im (x+iy)^order.
      std::vector<NodeId> by_power(((degree - order - parity) / 2 + 1), -1);
      for (int l = order + parity; l <= degree; l += 2) {
        const AxialForm form = whole_axial_form(l, order);
        const std::vector<cl_RA> powers = composed(form.powers, 1, -1);  // of x^2+y^2 in place of z^2
        const NodeId c = build.input(coefficient_index(l, m), "");
        for (std::size_t k = 0; k < powers.size(); ++k) {
          by_power[k] = plus_scaled(build, by_power[k], form.scale * Surd(powers[k]), c);
        }
      }
      Polynomial spread = symbolic::reduced_basis_function(order, m).azimuthal;
      for (const NodeId part : by_power) {
        for (const auto& [monomial, coefficient] : spread.terms()) {
          NodeId& sum = sums[polynomial_index(degree, monomial.exponent(0), monomial.exponent(1), parity == 1)];
          sum = plus_scaled(build, sum, Surd(coefficient), part);
        }
        spread = spread * across();
      }
    }
  }
  for_each_monomial(degree, [&](int i, int j, bool with_z) {
    kernel.outputs.push_back({sums[polynomial_index(degree, i, j, with_z)], monomial_name(i, j, with_z)});
  });
  return kernel;
}

Kernel evaluate_prepared(int degree) {
  symbolic::require_basis_index(degree, 0);
  Kernel kernel;
  kernel.title = "The value of a prepared function with bands 0 to " + std::to_string(degree) + " in one direction";
  kernel.domain = "|d| = 1 for d = (x, y, z); polynomial as evaluate_prepare_l" + std::to_string(degree) + " makes it";
  kernel.result = fmt::format(
      "returns the sum of c_lm Y_lm(d) for the c that was prepared; rounding the polynomial to T adds at most {:.2g} "
      "eps more",
      storage_error(degree));
  kernel.citation = kSource;
  kernel.factored = true;
  kernel.parameters = with_direction({array(Role::kPolynomial, "polynomial", degree)});
  kernel.results = {parameter(Role::kValue, "value")};
  Builder build(kernel);
  const Direction d = direction_inputs(build, coefficient_count(degree));
  const auto step = [&build](NodeId sum, NodeId variable, NodeId next) {
    return sum < 0 ? next : build.add(build.mul(sum, variable), next);
  };
  const auto part = [&](bool with_z) {
    const int most = degree - (with_z ? 1 : 0);
    NodeId sum = -1;
    for (int i = most; i >= 0; --i) {
      NodeId inner = -1;
      for (int j = most - i; j >= 0; --j) {
        inner = step(inner, d.y, build.input(polynomial_index(degree, i, j, with_z), ""));
      }
      sum = step(sum, d.x, inner);
    }
    return sum;
  };
  const NodeId p = part(false);
  const NodeId q = part(true);
  kernel.outputs = {{q < 0 ? p : step(q, d.z, p), ""}};
  return kernel;
}

}  // namespace sh::codegen::recipes
