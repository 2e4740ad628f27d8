// See exhaustive.hpp.
#include "numeric/kernels/exhaustive.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "generated/cpp/cap.hpp"
#include "generated/cpp/cap_accurate_l10.hpp"
#include "generated/cpp/cap_accurate_l9.hpp"
#include "generated/cpp/window_gaussian.hpp"
#include "generated/cpp/window_hann.hpp"
#include "generated/cpp/window_laplacian.hpp"
#include "numeric/kernels/every_float.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::numeric {
namespace {

// The largest coefficient of a cap with 1 - cos = u, "cap(l)" of size_formula.hpp.
DoubleLanes cap_size(std::size_t l, const DoubleLanes& u) {
  const double scale = std::sqrt((2 * static_cast<double>(l) + 1) * std::numbers::pi);
  return l == 0 ? DoubleLanes(scale * u) : DoubleLanes(scale / 2 * u * (2 - u));
}

template <int kDegree, class Cap>
OneVariableKernel cap_kernel(const char* family, Cap /*cap*/) {
  return {family, kDegree, 2, [](const FloatRange& range) { return worst_float<kDegree + 1>(range, Cap(), cap_size); }};
}

// A window applied to c = 1; the factor of each band is at its first coefficient.
template <int kDegree, class Window>
OneVariableKernel window_kernel(const char* family, Window /*window*/) {
  return {family, kDegree, 1, [](const FloatRange& range) {
            const auto factors = []<class T>(const T& x, T* out) {
              std::array<T, coefficient_count(kDegree)> c;
              c.fill(T(1));
              Window()(x, c.data());
              for (int l = 0; l <= kDegree; ++l) out[l] = c[l * l];
            };
            return worst_float<kDegree + 1>(range, factors,
                                            [](std::size_t, const DoubleLanes&) { return DoubleLanes(1); });
          }};
}

template <int... kDegree>
void add_caps(std::vector<OneVariableKernel>& all, std::integer_sequence<int, kDegree...> /*degrees*/) {
  (all.push_back(cap_kernel<kDegree>("cap", [](const auto& u, auto* out) { cap<kDegree>(u, out); })), ...);
}

template <int kDegree>
void add_windows(std::vector<OneVariableKernel>& all) {
  all.push_back(window_kernel<kDegree>("window_hann", [](const auto& x, auto* c) { window_hann<kDegree>(x, c); }));
  all.push_back(
      window_kernel<kDegree>("window_gaussian", [](const auto& x, auto* c) { window_gaussian<kDegree>(x, c); }));
  all.push_back(
      window_kernel<kDegree>("window_laplacian", [](const auto& x, auto* c) { window_laplacian<kDegree>(x, c); }));
}

}  // namespace

std::vector<OneVariableKernel> one_variable_kernels() {
  std::vector<OneVariableKernel> all;
  add_caps(all, std::make_integer_sequence<int, 11>());
  all.push_back(cap_kernel<9>("cap_accurate", [](const auto& u, auto* out) { cap_accurate_l9(u, out); }));
  all.push_back(cap_kernel<10>("cap_accurate", [](const auto& u, auto* out) { cap_accurate_l10(u, out); }));
  add_windows<3>(all);
  add_windows<6>(all);
  return all;
}

}  // namespace sh::numeric
