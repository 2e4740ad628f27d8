// Products: product(a, b), square(a), product_zonal(a, zonal) -> coefficients of the product on the same bands,
// product_full(a, b) -> all of them, and triple(a, b, c) -> the integral of a b c. Against quadrature on the sphere,
// exact for the degree of the integrand, of the values of numeric's basis at its nodes.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/oracle/quadrature.hpp"

namespace sh::numeric {
namespace {

constexpr int kVectors = 60;

// A rule for two factors of one degree and a result of another, with the values of the basis at its nodes.
template <class Real>
struct ProductRule {
  std::size_t factor = 0;     // coefficients of a factor
  std::size_t result = 0;     // of the result, not fewer
  std::vector<Real> weights;  // (nodes)
  std::vector<Real> basis;    // (nodes, result)

  ProductRule(int degree, int result_degree)
      : factor(static_cast<std::size_t>(coefficient_count(degree))),
        result(static_cast<std::size_t>(coefficient_count(result_degree))) {
    for (const auto& node : sphere_rule<Real>(2 * degree + result_degree)) {
      weights.push_back(node.weight);
      basis.resize(basis.size() + result);
      sh::numeric::basis(result_degree, node.x, node.y, node.z, basis.data() + basis.size() - result);
    }
  }

  // The factor with coefficients c at node k.
  Real value(std::size_t k, const Real* c) const {
    Real sum = 0;
    for (std::size_t i = 0; i < factor; ++i) sum += c[i] * basis[k * result + i];
    return sum;
  }
};

template <class Real>
const ProductRule<Real>& cached_product_rule(int degree, int result_degree) {
  static std::map<std::pair<int, int>, ProductRule<Real>> rules;
  return rules.try_emplace({degree, result_degree}, degree, result_degree).first->second;
}

// Factors of a degree, at most result_degree; out ((result_degree + 1)^2).
template <class Real>
void product(int degree, int result_degree, const Real* a, const Real* b, Real* out) {
  const auto& rule = cached_product_rule<Real>(degree, result_degree);
  std::fill_n(out, rule.result, Real(0));
  for (std::size_t k = 0; k < rule.weights.size(); ++k) {
    const Real weighted = rule.weights[k] * rule.value(k, a) * rule.value(k, b);
    for (std::size_t i = 0; i < rule.result; ++i) out[i] += weighted * rule.basis[k * rule.result + i];
  }
}

template <class Real>
void product(int degree, const Real* a, const Real* b, Real* out) {
  product(degree, degree, a, b, out);
}

std::vector<NamedInput> pairs(int degree) {
  auto inputs = combined(coefficient_inputs(degree, kVectors, 31), coefficient_inputs(degree, kVectors - 1, 32));
  for (const auto& input : coefficient_inputs(degree, 4, 33)) {
    inputs.push_back(combined({input}, {input})[0]);
    inputs.back().name += ", a square";
  }
  // Small numbers, to see that nothing underflows where |a| |b| does not.
  inputs.push_back(inputs[0]);
  inputs.back().name += ", scaled";
  for (double& value : inputs.back().values) value *= 1e-15;
  return inputs;
}

std::vector<NamedInput> with_zonal(int degree) {
  return combined(coefficient_inputs(degree, kVectors, 31), vector_inputs(degree + 1, kVectors - 1, 34));
}

// The product of the lengths of the vectors that the input consists of.
double lengths(const double* in, std::initializer_list<int> counts) {
  double product = 1;
  for (const int count : counts) {
    product *= length(in, count);
    in += count;
  }
  return product;
}

Parameter coefficients(const char* name, int degree) { return in_array(name, coefficient_count(degree)); }

// result_degree: of the product of two factors of a degree.
FamilyCheck check_of_product(const char* family, int (*result_degree)(int)) {
  return {.family = family,
          .signature =
              [result_degree](int degree) {
                return Signature{{coefficients("a", degree), coefficients("b", degree),
                                  out_array("out", coefficient_count(result_degree(degree)))}};
              },
          .inputs = pairs,
          .oracle = [result_degree](
                        int degree, const auto* in,
                        auto* out) { product(degree, result_degree(degree), in, in + coefficient_count(degree), out); },
          .nearest = {},
          .size =
              [](int degree, const double* in, std::size_t /*output*/) {
                return lengths(in, {coefficient_count(degree), coefficient_count(degree)});
              },
          .unit = "|a| |b|"};
}

}  // namespace

FamilyCheck product_check() {
  return check_of_product("product", [](int degree) { return degree; });
}

FamilyCheck product_full_check() {
  return check_of_product("product_full", [](int degree) { return 2 * degree; });
}

FamilyCheck square_check() {
  return {.family = "square",
          .signature =
              [](int degree) {
                return Signature{{coefficients("a", degree), out_array("out", coefficient_count(degree))}};
              },
          .inputs = [](int degree) { return coefficient_inputs(degree, kVectors, 31); },
          .oracle = [](int degree, const auto* in, auto* out) { product(degree, in, in, out); },
          .nearest = {},
          .size = [](int degree, const double* in,
                     std::size_t /*output*/) { return std::pow(length(in, coefficient_count(degree)), 2); },
          .unit = "|a|^2"};
}

FamilyCheck product_zonal_check() {
  return {.family = "product_zonal",
          .signature =
              [](int degree) {
                return Signature{{coefficients("a", degree), in_array("zonal", degree + 1),
                                  out_array("out", coefficient_count(degree))}};
              },
          .inputs = with_zonal,
          .oracle =
              [](int degree, const auto* in, auto* out) {
                using Real = std::remove_cvref_t<decltype(*in)>;
                std::vector<Real> zonal(static_cast<std::size_t>(coefficient_count(degree)));
                for (int l = 0; l <= degree; ++l) {
                  zonal[static_cast<std::size_t>(coefficient_index(l, 0))] = in[coefficient_count(degree) + l];
                }
                product(degree, in, zonal.data(), out);
              },
          .nearest = {},
          .size =
              [](int degree, const double* in, std::size_t /*output*/) {
                return lengths(in, {coefficient_count(degree), degree + 1});
              },
          .unit = "|a| |zonal|"};
}

FamilyCheck triple_check() {
  return {
      .family = "triple",
      .signature =
          [](int degree) {
            return Signature{{coefficients("a", degree), coefficients("b", degree), coefficients("c", degree)}, true};
          },
      .inputs = [](int degree) { return combined(pairs(degree), coefficient_inputs(degree, kVectors - 2, 35)); },
      .oracle =
          [](int degree, const auto* in, auto* out) {
            using Real = std::remove_cvref_t<decltype(*in)>;
            const int count = coefficient_count(degree);
            std::vector<Real> product_ab(static_cast<std::size_t>(count));
            product(degree, in, in + count, product_ab.data());
            *out = 0;
            for (int i = 0; i < count; ++i) *out += product_ab[static_cast<std::size_t>(i)] * in[2 * count + i];
          },
      .nearest = {},
      .size =
          [](int degree, const double* in, std::size_t /*output*/) {
            const int count = coefficient_count(degree);
            return lengths(in, {count, count, count});
          },
      .unit = "|a| |b| |c|"};
}

}  // namespace sh::numeric
