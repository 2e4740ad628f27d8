// Products: product(a, b), square(a), product_zonal(a, zonal) -> coefficients of the product on the same bands,
// product_full(a, b) -> all of them, triple(a, b, c) -> the integral of a b c, and relight(transfer, light) -> the integral
// of their product, for each channel. Against quadrature on the sphere,
// exact for the degree of the integrand, of the values of the oracle's basis at its nodes.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"

namespace sh::numeric {
namespace {

// A rule for two factors of one degree and a result of another, with the values of the basis at its nodes.
template <class Real>
struct ProductRule {
  std::size_t factor = 0;     // coefficients of a factor
  std::size_t result = 0;     // of the result, not fewer
  std::vector<Real> weights;  // (nodes)
  std::vector<Real> basis;    // (nodes, result)

  ProductRule(int degree, int result_degree)
      : factor(coefficient_count(degree)), result(coefficient_count(result_degree)) {
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

// The integral of transfer times light for each channel of the light, from transfer of as many channels, or of one.
auto relit(int transfer_channels, int light_channels) {
  return [=](int degree, const auto* transfer, auto* out) {
    using Real = std::remove_cvref_t<decltype(*transfer)>;
    const auto& rule = cached_product_rule<Real>(degree, degree);
    const Real* const light = transfer + transfer_channels * rule.factor;
    for (int channel = 0; channel < light_channels; ++channel) {
      const Real* const of_channel = transfer + (transfer_channels == 1 ? 0 : channel * rule.factor);
      out[channel] = 0;
      for (std::size_t k = 0; k < rule.weights.size(); ++k) {
        out[channel] += rule.weights[k] * rule.value(k, of_channel) * rule.value(k, light + channel * rule.factor);
      }
    }
  };
}

}  // namespace

std::vector<ExactFamily> exact_product() {
  return {{"product",
           [](int degree, const auto* in, auto* out) { product(degree, in, in + coefficient_count(degree), out); }},
          {"product_full", [](int degree, const auto* in,
                              auto* out) { product(degree, 2 * degree, in, in + coefficient_count(degree), out); }},
          {"square", [](int degree, const auto* in, auto* out) { product(degree, in, in, out); }},
          {"product_zonal",
           [](int degree, const auto* in, auto* out) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             std::vector<Real> zonal(coefficient_count(degree));
             for (int l = 0; l <= degree; ++l) {
               zonal[coefficient_index(l, 0)] = in[coefficient_count(degree) + l];
             }
             product(degree, in, zonal.data(), out);
           }},
          {"relight", relit(1, 1)},
          {"relight_rgb", relit(1, 3)},
          {"relight_colored", relit(3, 3)},
          {"triple", [](int degree, const auto* in, auto* out) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             const int count = coefficient_count(degree);
             std::vector<Real> product_ab(count);
             product(degree, in, in + count, product_ab.data());
             in += 2 * count;
             *out = 0;
             for (const Real& value : product_ab) *out += value * *in++;
           }}};
}

}  // namespace sh::numeric
