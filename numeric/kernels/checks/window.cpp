// Windows that damp high bands, in place: (parameters, c). Against their definitions with the angles and powers of the
// parameters, where the kernels have recurrences.
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"

namespace sh::numeric {
namespace {

constexpr int kVectors = 60;

// Cut-offs w >= 2: cos(pi / w) and sin(pi / w) / (pi / w), or the first alone.
std::vector<NamedInput> cut_offs(bool with_sinc) {
  std::vector<NamedInput> inputs;
  const auto add = [&](const std::string& name, double w) {
    const double angle = std::numbers::pi / w;
    inputs.push_back({name, {std::cos(angle)}});
    if (with_sinc) inputs.back().values.push_back(std::sin(angle) / angle);
  };
  for (const double w : {2.0, 3.0, 4.0, 11.0, 100.0, 1e4, 1e9}) add("cut-off " + std::to_string(w), w);
  for (int i = 0; i < 150; ++i) add("cut-off " + std::to_string(i), 2 + 0.01 * i * i);
  inputs.push_back({"no cut-off", {1}});
  if (with_sinc) inputs.back().values.push_back(1);
  return inputs;
}

// Numbers in [0, 1], ends, tiny and nearly 1 included.
std::vector<NamedInput> fractions() {
  std::vector<NamedInput> inputs;
  for (const double g : {0.0, 1e-30, 1e-4, 0.5, 1 - 1e-6, 1.0}) inputs.push_back({"named", {g}});
  for (int i = 0; i < 150; ++i) inputs.push_back({"fraction " + std::to_string(i), {(i + 0.5) / 150}});
  return inputs;
}

// sin(l a) / sin(a) for cos a = c.
template <class Real>
Real sine_ratio(int l, const Real& c) {
  using std::acos;
  using std::sin;
  if (c >= 1) return static_cast<Real>(l);
  const Real angle = acos(c);
  return Real(sin(Real(static_cast<Real>(l) * angle))) / Real(sin(angle));
}

// factor(l, parameters) is the window at degree l.
template <class Factor>
FamilyCheck window_check(const std::string& family, int parameters, const std::vector<NamedInput>& parameter_inputs,
                         Factor factor) {
  return {
      .family = family,
      .signature =
          [parameters](int degree) {
            Signature signature;
            for (int i = 0; i < parameters; ++i) signature.parameters.push_back(scalar("parameter"));
            signature.parameters.push_back(in_out_array("c", coefficient_count(degree)));
            return signature;
          },
      .inputs = [parameter_inputs](
                    int degree) { return combined(parameter_inputs, coefficient_inputs(degree, kVectors, 96)); },
      .oracle =
          [parameters, factor](int degree, const auto* in, auto* out) {
            for (int i = 0; i < coefficient_count(degree); ++i) {
              out[i] = factor(degree_of(static_cast<std::size_t>(i)), in) * in[parameters + i];
            }
          },
      .nearest = {},
      .size = [parameters](int /*degree*/, const double* in,
                           std::size_t output) { return std::abs(in[static_cast<std::size_t>(parameters) + output]); },
      .unit = "|c_lm|"};
}

// (sin(l pi / w) / (l pi / w))^power, with sin(pi / w) / (pi / w) as given: sin(l a) / (l a) = sin(l a) / sin(a) / l
// sinc.
FamilyCheck lanczos_check(const std::string& family, int power) {
  return window_check(family, 2, cut_offs(true), [power](int l, const auto* in) {
    using Real = std::remove_cvref_t<decltype(*in)>;
    const Real sinc = l == 0 ? Real(1) : Real(sine_ratio(l, in[0]) * in[1] / static_cast<Real>(l));
    Real factor = 1;
    for (int i = 0; i < power; ++i) factor *= sinc;
    return factor;
  });
}

}  // namespace

FamilyCheck window_hann_check() {
  return window_check("window_hann", 1, cut_offs(false), [](int l, const auto* in) {
    using std::acos;
    using std::cos;
    using Real = std::remove_cvref_t<decltype(*in)>;
    return Real((1 + cos(Real(static_cast<Real>(l) * Real(acos(in[0]))))) / 2);
  });
}

FamilyCheck window_lanczos_check() { return lanczos_check("window_lanczos", 1); }
FamilyCheck window_lanczos2_check() { return lanczos_check("window_lanczos2", 2); }
FamilyCheck window_lanczos4_check() { return lanczos_check("window_lanczos4", 4); }

FamilyCheck window_gaussian_check() {
  return window_check("window_gaussian", 1, fractions(), [](int l, const auto* in) {
    using std::pow;
    using Real = std::remove_cvref_t<decltype(*in)>;
    return l == 0 ? Real(1) : Real(pow(in[0], l * l));
  });
}

FamilyCheck window_laplacian_check() {
  return window_check("window_laplacian", 1, fractions(), [](int l, const auto* in) {
    using Real = std::remove_cvref_t<decltype(*in)>;
    return Real(1 / (1 + in[0] * static_cast<Real>(l * l * (l + 1) * (l + 1))));
  });
}

}  // namespace sh::numeric
