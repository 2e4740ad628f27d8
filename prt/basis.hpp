// Calls of the generated kernels with a degree that is chosen at run time, and loops over bands.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "numeric/oracle/index.hpp"
#include "prt/arrays.hpp"
#include "prt/transfer/shape.hpp"

namespace sh::prt {

/// The highest degree of a product of visibility and light (generated `transfer_apply`): visibility has twice the degree,
/// and its basis ends at kMaxDegree.
inline constexpr int kHighestProduct = 5;

/// Calls work(std::integral_constant<int, degree>()), so that `sh::basis<d()>` and its like can be called with its
/// argument d. Precondition: 0 <= degree <= kMaxDegree.
template <class Work>
void at_degree(int degree, Work&& work) {
  using Call = void (*)(std::remove_reference_t<Work>&);
  static constexpr auto kCalls = []<int... Degree>(std::integer_sequence<int, Degree...>) {
    return std::array<Call, sizeof...(Degree)>{
        [](std::remove_reference_t<Work>& call) { call(std::integral_constant<int, Degree>()); }...};
  }
  (std::make_integer_sequence<int, kMaxDegree + 1>());
  kCalls[degree](work);
}

/// An array that is large enough for the basis of any degree.
using BasisValues = std::array<double, std::size_t{kMaxDegree + 1} * (kMaxDegree + 1)>;

using numeric::coefficient_index;

/// out (bands^2) = Y_lm(direction), l = 0..degree; |direction| = 1, 0 <= degree <= kMaxDegree. T: float or double.
template <class T>
void evaluate_basis(int degree, T x, T y, T z, T* out);

/// sum (bands^2) += weight Y_lm(direction), a sample of a projection; |direction| = 1, 0 <= degree <= kMaxDegree.
/// T: float or double.
template <class T>
void add_basis(int degree, T x, T y, T z, T weight, T* sum);

/// out (bands^2) = the coefficients of the function `in`, turned by the rotation matrix r: (R f)(s) = f(R^-1 s). `out` may be
/// `in`. 0 <= degree <= kMaxDegree. T: float or double.
template <class T>
void rotate_function(int degree, const Eigen::Matrix3<T>& r, const T* in, T* out);

/// c_lm *= factors_l for as many bands as there are factors.
inline void scale_bands(const std::vector<double>& factors, double* c) {
  for (std::size_t l = 0; l < factors.size(); ++l) band(c, static_cast<int>(l)) *= factors[l];
}

}  // namespace sh::prt
