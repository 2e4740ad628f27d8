// Numbers that stand in rows elsewhere, as Eigen arrays: what adds, scales and multiplies rows of coefficients.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace sh::prt {

/// The `count` numbers from `first` on. T: float or double, const or not.
template <class T>
auto as_array(T* first, std::size_t count) {
  using Array = Eigen::ArrayX<std::remove_const_t<T>>;
  return Eigen::Map<std::conditional_t<std::is_const_v<T>, const Array, Array>>(first,
                                                                                static_cast<Eigen::Index>(count));
}

/// All numbers of a vector, which must outlive the result.
template <class T>
auto as_array(std::vector<T>& values) {
  return as_array(values.data(), values.size());
}
template <class T>
auto as_array(const std::vector<T>& values) {
  return as_array(values.data(), values.size());
}

/// The 2l+1 coefficients of degree l of a function whose coefficients start at c.
template <class T>
auto band(T* c, int l) {
  return as_array(c + std::size_t(l) * std::size_t(l), 2 * std::size_t(l) + 1);
}

}  // namespace sh::prt
