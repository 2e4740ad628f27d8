// Recipes: the product of two functions term by term, products with a zonal function, and integrals of three functions.
//
// Term by term: c_k = sum over i, j of G_ijk a_i b_j with the nonzero entries of the Gaunt tensor. The kernel computes
// every product a_i b_j once. This is the simplest form, and it has the least rounding error.
#include <cstdlib>
#include <map>
#include <tuple>

#include "codegen/recipes/linear_circuit.hpp"
#include "codegen/recipes/product/product.hpp"
#include "symbolic/product/gaunt.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::BilinearForm;
using symbolic::BilinearTerm;

constexpr const char* kSource =
    "J. A. Gaunt, \"The Triplets of Helium\", Phil. Trans. R. Soc. A 228, 1929; constants derived exactly";

// c_k = sum of factor a_i b_j; the kernel computes every product a_i b_j once.
void add_up_terms(Kernel& kernel, SignedBuilder& build, const std::vector<BilinearForm>& forms,
                  const std::vector<Value>& a, const std::vector<Value>& b) {
  std::map<std::pair<int, int>, Value> products;
  for (const BilinearForm& form : forms) {
    std::vector<Value> terms;
    for (const BilinearTerm& term : form.terms) {
      const auto [known, added] = products.try_emplace({term.i, term.j});
      if (added) known->second = build.times(a[term.i], b[term.j]);
      terms.push_back(build.times(term.factor, known->second));
    }
    kernel.outputs[form.output].node = build.node(build.sum(terms));
  }
}

// (order, row degree, column degree) of one entry of the matrices of a zonal product, row <= column
using ZonalEntry = std::tuple<int, int, int>;

void describe_zonal(Kernel& kernel, int degree) {
  kernel.citation = kSource;
  kernel.title = "The product of a function on the sphere and a zonal one about +z, projected on " + degrees_to(degree);
  kernel.domain = "any coefficients: zonal[l] is that of Y_l0, the others of the zonal function are zero";
  kernel.result =
      "coefficients of the product at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = {array(Role::kCoefficients, "a", degree), array(Role::kZonalCoefficients, "zonal", degree)};
  kernel.results = {array(Role::kCoefficients, "out", degree)};
  label_coefficients(kernel, degree);
}

}  // namespace

Kernel product_frame(const ProductShape& shape, Factors factors) {
  Kernel kernel;
  const bool same = factors == Factors::kSame;
  const bool exact = shape.result >= shape.a + shape.b;
  kernel.title = (same ? "The square of a function on the sphere" : "The product of two functions on the sphere") +
                 std::string(exact ? ", complete, in " : ", projected on ") + degrees_to(shape.result);
  kernel.domain = "any coefficients";
  if (shape.a != shape.b) kernel.domain += ": a has " + degrees_to(shape.a) + ", b has " + degrees_to(shape.b);
  kernel.result = std::string("coefficients of ") + (same ? "a a" : "a b") +
                  " at index l(l+1)+m, orthonormal on the unit sphere, no Condon-Shortley phase";
  kernel.parameters = {array(Role::kCoefficients, "a", shape.a)};
  if (!same) kernel.parameters.push_back(array(Role::kCoefficients, "b", shape.b));
  kernel.results = {array(Role::kCoefficients, "out", shape.result)};
  label_coefficients(kernel, shape.result);
  return kernel;
}

std::array<std::vector<Value>, 2> factor_inputs(SignedBuilder& build, const ProductShape& shape, Factors factors) {
  const int count_a = coefficient_count(shape.a);
  const std::vector<Value> a = build.inputs(0, count_a);
  return {a, factors == Factors::kSame ? a : build.inputs(count_a, coefficient_count(shape.b))};
}

Kernel product_tensor(const ProductShape& shape, Factors factors) {
  const bool same = factors == Factors::kSame;
  Kernel kernel = product_frame(shape, factors);
  kernel.citation = kSource;
  SignedBuilder build(kernel);
  const auto [a, b] = factor_inputs(build, shape, factors);
  const auto forms = same ? symbolic::square_form(shape.a, shape.result) : symbolic::product_form(shape);
  add_up_terms(kernel, build, forms, a, b);
  return kernel;
}

Kernel product_zonal(int degree) {
  Kernel kernel;
  describe_zonal(kernel, degree);
  kernel.citation += ", sums found by search";
  SignedBuilder build(kernel);
  const std::vector<Value> a = build.inputs(0, coefficient_count(degree));
  const std::vector<Value> zonal = build.inputs(coefficient_count(degree), degree + 1);
  std::vector<ZonalEntry> entries;
  LinearMap map;
  for (int m = 0; m <= degree; ++m) {
    for (int row = m; row <= degree; ++row) {
      for (int column = row; column <= degree; ++column) {
        entries.emplace_back(m, row, column);
        map.emplace_back();
        for (int l = 0; l <= degree; ++l) {
          const ExactReal entry =
              symbolic::gaunt(coefficient_index(row, m), coefficient_index(column, m), coefficient_index(l, 0));
          if (!is_zero(entry)) map.back().emplace(l, entry);
        }
      }
    }
  }
  const std::vector<Value> values = run_forwards(build, short_circuit(map, degree + 1, degree <= 6 ? 20 : 2), zonal);
  std::map<ZonalEntry, Value> matrix;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& [m, row, column] = entries[i];
    const std::string name = "m" + std::to_string(m) + "_" + std::to_string(row) + "_" + std::to_string(column);
    matrix[entries[i]] = build.named(values[i], name);
    matrix[{m, column, row}] = matrix[entries[i]];
  }
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const int order = std::abs(m);
      std::vector<Value> terms;
      for (int column = order; column <= degree; ++column) {
        terms.push_back(build.times(matrix[{order, l, column}], a[coefficient_index(column, m)]));
      }
      kernel.outputs[coefficient_index(l, m)].node = build.node(build.sum(terms));
    }
  }
  return kernel;
}

Kernel product_zonal_tensor(int degree) {
  Kernel kernel;
  describe_zonal(kernel, degree);
  SignedBuilder build(kernel);
  const std::vector<Value> a = build.inputs(0, coefficient_count(degree));
  const std::vector<Value> zonal = build.inputs(coefficient_count(degree), degree + 1);
  add_up_terms(kernel, build, symbolic::zonal_product_form({degree, degree, degree}), a, zonal);
  return kernel;
}

Kernel triple(Kernel product, int degree) {
  Kernel kernel = std::move(product);
  const int count = coefficient_count(degree);
  SignedBuilder build(kernel);
  const std::vector<Value> c = build.inputs(2 * count, count);
  std::vector<Value> terms;
  terms.reserve(count);
  for (int i = 0; i < count; ++i) {
    terms.push_back(build.times({kernel.outputs[i].node}, c[i]));
  }
  kernel.title = "The integral over the sphere of the product of three functions of " + degrees_to(degree);
  kernel.domain = "any coefficients";
  kernel.result = "the integral of a b c, orthonormal basis at index l(l+1)+m, no Condon-Shortley phase";
  kernel.parameters.push_back(array(Role::kCoefficients, "c", degree));
  kernel.results = {parameter(Role::kValue, "integral")};
  kernel.outputs = {{build.node(build.balanced_sum(terms)), "integral of a b c"}};
  return kernel;
}

}  // namespace sh::codegen::recipes
