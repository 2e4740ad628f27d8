// Values of functions, against the recurrences of the oracle; and the list of all families.
//
// basis and basis_normalised; basis_gradient: values and Cartesian derivatives of the solid harmonics r^l Y_lm(d/r),
// any d; evaluate (c, d), evaluate_rgb (c of three channels, d); evaluate_prepare c -> polynomial and evaluate_prepared
// (polynomial, d).
#include "numeric/kernels/exact/exact.hpp"

#include <utility>

#include "numeric/kernels/exact/polynomial_forms.hpp"
#include "numeric/kernels/inputs.hpp"
#include "numeric/oracle/basis.hpp"

namespace sh::numeric {
namespace {

// out (channels) from c (channels, bands^2) and d.
auto values_of(int channels) {
  return [channels](int degree, const auto* in, auto* out) {
    const auto* const d = in + channels * coefficient_count(degree);
    const auto values = basis(degree, d[0], d[1], d[2]);
    for (int channel = 0; channel < channels; ++channel) {
      out[channel] = 0;
      for (const auto& value : values) out[channel] += *in++ * value;
    }
  };
}

// Polynomials of functions with |c| = 1.
std::vector<NamedInput> prepared_functions(int degree) {
  constexpr int kVectors = 59;
  auto inputs = coefficient_inputs(degree, kVectors, 306);
  for (auto& input : inputs) {
    const auto c = input.values;
    multiply(prepare_matrix(degree), c.data(), input.values.data());
  }
  return inputs;
}

std::vector<ExactFamily> exact_basis() {
  return {{"basis", [](int degree, const auto* d, auto* out) { basis(degree, d[0], d[1], d[2], out); }},
          {"basis_normalised",
           [](int degree, const auto* d, auto* out) {
             const auto unit = normalized(d[0], d[1], d[2]);
             basis(degree, unit[0], unit[1], unit[2], out);
           }},
          {"basis_gradient", [](int degree, const auto* d, auto* out) {
             const int count = coefficient_count(degree);
             basis_gradient(degree, d[0], d[1], d[2], out, out + count, out + 2 * count, out + 3 * count);
           }}};
}

std::vector<ExactFamily> exact_evaluate() {
  return {
      {"evaluate", values_of(1)},
      {"evaluate_rgb", values_of(3)},
      {"evaluate_prepare", [](int degree, const auto* in, auto* out) { multiply(prepare_matrix(degree), in, out); }},
      {"evaluate_prepared",
       [](int degree, const auto* in, auto* out) {
         using Real = std::remove_cvref_t<decltype(*in)>;
         const auto* const d = in + coefficient_count(degree);
         *out = 0;
         for (const auto& term : prepared_terms(degree)) {
           Real value = *in++;
           for (int i = 0; i < term.i; ++i) value *= d[0];
           for (int j = 0; j < term.j; ++j) value *= d[1];
           *out += term.k == 0 ? value : Real(value * d[2]);
         }
       },
       prepared_functions}};
}

}  // namespace

const std::vector<ExactFamily>& exact_families() {
  static const std::vector<ExactFamily> kAll = [] {
    std::vector<ExactFamily> all;
    for (auto* const group : {exact_basis, exact_evaluate, exact_project, exact_zonal, exact_window, exact_irradiance,
                              exact_product, exact_rotation, exact_transfer}) {
      for (ExactFamily& family : group()) all.push_back(std::move(family));
    }
    return all;
  }();
  return kAll;
}

}  // namespace sh::numeric
