// See exhaustive.hpp.
#include "numeric/kernels/exhaustive.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "generated/cpp/cap.hpp"
#include "generated/cpp/cap_accurate_l10.hpp"
#include "generated/cpp/cap_accurate_l7.hpp"
#include "generated/cpp/cap_accurate_l8.hpp"
#include "generated/cpp/cap_accurate_l9.hpp"
#include "generated/cpp/window_gaussian.hpp"
#include "generated/cpp/window_hann.hpp"
#include "generated/cpp/window_laplacian.hpp"

namespace sh::numeric {
namespace {

// The largest coefficient of a cap with 1 - cos = u, as in checks/cap.cpp.
DoubleLanes cap_size(std::size_t l, const DoubleLanes& u) {
  const double scale = std::sqrt((2 * static_cast<double>(l) + 1) * std::numbers::pi);
  return l == 0 ? DoubleLanes(scale * u) : DoubleLanes(scale / 2 * u * (2 - u));
}

template <int kDegree, class Cap>
FloatError worst_cap(const FloatRange& range, const Cap& cap) {
  return worst_float<kDegree + 1>(range, cap, cap_size);
}

// A window applied to c = 1; the factor of each band is at its first coefficient.
template <int kDegree, class Window>
FloatError worst_window(const FloatRange& range, const Window& window) {
  const auto factors = [&]<class T>(const T& x, T* out) {
    std::array<T, (kDegree + 1) * (kDegree + 1)> c;
    c.fill(T(1));
    window(x, c.data());
    for (std::size_t l = 0; l <= kDegree; ++l) out[l] = c[l * l];
  };
  return worst_float<kDegree + 1>(range, factors, [](std::size_t, const DoubleLanes&) { return DoubleLanes(1); });
}

template <int kDegree>
void add_caps(std::vector<OneVariableKernel>& all) {
  all.push_back({"cap", kDegree, 2, [](const FloatRange& range) {
                   return worst_cap<kDegree>(range, []<class T>(const T& u, T* out) { cap<kDegree>(u, out); });
                 }});
}

template <int kDegree>
void add_windows(std::vector<OneVariableKernel>& all) {
  all.push_back({"window_hann", kDegree, 1, [](const FloatRange& range) {
                   return worst_window<kDegree>(range, []<class T>(const T& x, T* c) { window_hann<kDegree>(x, c); });
                 }});
  all.push_back({"window_gaussian", kDegree, 1, [](const FloatRange& range) {
                   return worst_window<kDegree>(range,
                                                []<class T>(const T& x, T* c) { window_gaussian<kDegree>(x, c); });
                 }});
  all.push_back({"window_laplacian", kDegree, 1, [](const FloatRange& range) {
                   return worst_window<kDegree>(range,
                                                []<class T>(const T& x, T* c) { window_laplacian<kDegree>(x, c); });
                 }});
}

}  // namespace

std::vector<OneVariableKernel> one_variable_kernels() {
  std::vector<OneVariableKernel> all;
  [&]<int... kDegree>(std::integer_sequence<int, kDegree...>) { (add_caps<kDegree>(all), ...); }
  (std::make_integer_sequence<int, 11>());
  all.push_back({"cap_accurate", 7, 2, [](const FloatRange& range) {
                   return worst_cap<7>(range, []<class T>(const T& u, T* out) { cap_accurate_l7(u, out); });
                 }});
  all.push_back({"cap_accurate", 8, 2, [](const FloatRange& range) {
                   return worst_cap<8>(range, []<class T>(const T& u, T* out) { cap_accurate_l8(u, out); });
                 }});
  all.push_back({"cap_accurate", 9, 2, [](const FloatRange& range) {
                   return worst_cap<9>(range, []<class T>(const T& u, T* out) { cap_accurate_l9(u, out); });
                 }});
  all.push_back({"cap_accurate", 10, 2, [](const FloatRange& range) {
                   return worst_cap<10>(range, []<class T>(const T& u, T* out) { cap_accurate_l10(u, out); });
                 }});
  add_windows<3>(all);
  add_windows<6>(all);
  return all;
}

}  // namespace sh::numeric
