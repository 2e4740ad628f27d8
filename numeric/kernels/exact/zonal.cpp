// Zonal functions: cap, zonal, add_cap, add_cap_rgb and windows that damp high bands.
//
// cap(one_minus_cos) -> zonal; zonal(zonal, d) -> out; add_cap and add_cap_rgb (d, one_minus_cos, color, sum in
// place). Against quadrature over the cap and the oracle's basis in the direction of the light.
// window_* (parameters, c): in place, against their definitions with the angles and powers of the parameters, where the
// kernels have recurrences.
#include "numeric/oracle/zonal.hpp"

#include <cmath>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/oracle/basis.hpp"

namespace sh::numeric {
namespace {

// out (bands^2): the zonal function z_0, z_1, ... turned from +z to the unit direction d.
template <class Real>
void turned_zonal(int degree, const Real* zonal, const Real* d, Real* out) {
  using std::sqrt;
  basis(degree, d[0], d[1], d[2], out);
  for (int l = 0; l <= degree; ++l) {
    const Real factor = sqrt(Real(4 * pi<Real>() / static_cast<Real>(2 * l + 1))) * zonal[l];
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) out[i] *= factor;
  }
}

// x, y, z, one_minus_cos, one value a channel, sum (channels, bands^2)
auto light(int channels) {
  return [channels](int degree, const auto* in, auto* out) {
    using Real = std::remove_cvref_t<decltype(*in)>;
    std::vector<Real> zonal(degree + 1);
    cap_zonal_quadrature(degree, in[3], zonal.data());
    std::vector<Real> turned(coefficient_count(degree));
    turned_zonal(degree, zonal.data(), in, turned.data());
    const Real* sum = in + 4 + channels;
    for (int channel = 0; channel < channels; ++channel) {
      for (const Real& value : turned) *out++ = *sum++ + in[4 + channel] * value;
    }
  };
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
auto window(int parameters, Factor factor) {
  return [parameters, factor](int degree, const auto* in, auto* out) {
    const auto* c = in + parameters;
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) *out++ = factor(l, in) * *c++;
    }
  };
}

// (sin(l pi / w) / (l pi / w))^power, with sin(pi / w) / (pi / w) as given: sin(l a) / (l a) = sin(l a) / sin(a) / l
// sinc.
auto lanczos(int power) {
  return window(2, [power](int l, const auto* in) {
    using Real = std::remove_cvref_t<decltype(*in)>;
    const Real sinc = l == 0 ? Real(1) : Real(sine_ratio(l, in[0]) * in[1] / static_cast<Real>(l));
    Real factor = 1;
    for (int i = 0; i < power; ++i) factor *= sinc;
    return factor;
  });
}

}  // namespace

std::vector<ExactFamily> exact_zonal() {
  return {{"cap", [](int degree, const auto* in, auto* out) { cap_zonal_quadrature(degree, in[0], out); }},
          {"zonal", [](int degree, const auto* in, auto* out) { turned_zonal(degree, in, in + degree + 1, out); }},
          {"add_cap", light(1)},
          {"add_cap_rgb", light(3)}};
}

std::vector<ExactFamily> exact_window() {
  return {{"window_hann", window(1,
                                 [](int l, const auto* in) {
                                   using std::acos;
                                   using std::cos;
                                   using Real = std::remove_cvref_t<decltype(*in)>;
                                   return Real((1 + cos(Real(static_cast<Real>(l) * Real(acos(in[0]))))) / 2);
                                 })},
          {"window_lanczos", lanczos(1)},
          {"window_lanczos2", lanczos(2)},
          {"window_lanczos4", lanczos(4)},
          {"window_gaussian", window(1,
                                     [](int l, const auto* in) {
                                       using std::pow;
                                       using Real = std::remove_cvref_t<decltype(*in)>;
                                       return l == 0 ? Real(1) : Real(pow(in[0], l * l));
                                     })},
          {"window_laplacian", window(1, [](int l, const auto* in) {
             using Real = std::remove_cvref_t<decltype(*in)>;
             return Real(1 / (1 + in[0] * static_cast<Real>(l * l * (l + 1) * (l + 1))));
           })}};
}

}  // namespace sh::numeric
