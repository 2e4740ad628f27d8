// Windows that damp high bands, in place: (parameters, c). Against their definitions with the angles and powers of the
// parameters, where the kernels have recurrences.
#include <cmath>

#include "numeric/kernels/exact/exact.hpp"

namespace sh::numeric {
namespace {

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
