#include "codegen/recipes/basis/sphere.hpp"

#include <cln/integer.h>

#include "symbolic/basis/basis.hpp"

namespace sh::codegen::recipes {

using symbolic::Surd;

std::size_t basis_index(int l, int m) {
  const int index = l * (l + 1) + m;
  return static_cast<std::size_t>(index);
}

int basis_count(int degree) { return (degree + 1) * (degree + 1); }

Surd sectoral_factor(int m) {
  const cln::cl_I odd = m == 0 ? cln::cl_I(1) : cln::doublefactorial(static_cast<unsigned>(2 * m - 1));
  const cln::cl_RA square =
      cln::cl_RA((m == 0 ? 1 : 2) * (2 * m + 1)) / (4 * cln::factorial(static_cast<unsigned>(2 * m)));
  return Surd(odd) * Surd::square_root(square, -1);
}

Surd upper_factor(int l, int m) { return Surd::square_root(cln::cl_RA(4 * l * l - 1) / (l * l - m * m)); }

Surd lower_factor(int l, int m) { return upper_factor(l, m) / upper_factor(l - 1, m); }

AxialForm axial_form(int l, int m) {
  const symbolic::BasisFunction f = symbolic::reduced_basis_function(l, m);
  AxialForm form{m == 0 ? f.factor : f.factor / sectoral_factor(m), {}, (l - m) % 2 != 0};
  form.powers.assign((l - m) / 2 + 1, 0);
  for (const auto& [monomial, coefficient] : f.axial.terms()) {
    form.powers.at(monomial.exponent(2) / 2) = coefficient;
  }
  return form;
}

namespace {

// The constant of node p_4_2: a_4_2.
std::string constant_name(char letter, const std::string& name) {
  const std::size_t underscore = name.find('_');
  return underscore == std::string::npos ? std::string() : letter + name.substr(underscore);
}

}  // namespace

NodeId affine(Builder& build, const ExactReal& k, NodeId a, const ExactReal& c, const std::string& name) {
  const NodeId product = build.mul(build.constant(k, constant_name('a', name)), a);
  const bool minus = is_negative(c);
  const NodeId constant = build.constant(minus ? negate(c) : c, constant_name('b', name));
  return minus ? build.sub(product, constant, name) : build.add(product, constant, name);
}

NodeId combination(Builder& build, const ExactReal& k, NodeId a, const ExactReal& q, NodeId b,
                   const std::string& name) {
  const NodeId first = build.mul(build.constant(k, constant_name('a', name)), a);
  const bool minus = is_negative(q);
  const NodeId second = build.mul(build.constant(minus ? negate(q) : q, constant_name('b', name)), b);
  return minus ? build.sub(first, second, name) : build.add(first, second, name);
}

Direction direction_inputs(Builder& build) {
  const NodeId x = build.input(0, "x");
  const NodeId y = build.input(1, "y");
  const NodeId z = build.input(2, "z");
  return {x, y, z};
}

void describe_basis(Kernel& kernel, int degree) {
  kernel.title = degree == 0
                     ? "The real spherical harmonic of degree 0"
                     : "Real spherical harmonics of degree 0 to " + std::to_string(degree) + " in one direction";
  kernel.domain = "|d| = 1 for d = (x, y, z); z is the polar axis";
  kernel.result = "Y_lm(d) at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = with_direction({});
  kernel.results = {array(Role::kBasisValues, "out", degree)};
}

void set_basis_outputs(Kernel& kernel, const std::vector<NodeId>& values) {
  int degree = 0;
  while (basis_count(degree) < static_cast<int>(values.size())) ++degree;
  kernel.outputs.clear();
  label_coefficients(kernel, degree);
  for (std::size_t i = 0; i < values.size(); ++i) kernel.outputs[i].node = values[i];
}

}  // namespace sh::codegen::recipes
