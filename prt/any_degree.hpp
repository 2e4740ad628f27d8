// The generated basis kernels behind one run-time choice of the degree.
#pragma once
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "generated/cpp/basis.hpp"
#include "prt/transfer.hpp"

namespace sh::prt {

/// out ((degree+1)^2) = the basis at the unit direction (x, y, z), i = l(l+1)+m.
template <class T>
using BasisKernel = void (*)(T x, T y, T z, T* out);

namespace detail {
template <class T, std::size_t... kDegrees>
constexpr std::array<BasisKernel<T>, sizeof...(kDegrees)> basis_kernels(std::index_sequence<kDegrees...> /*degrees*/) {
  return {[](T x, T y, T z, T* out) { sh::basis<static_cast<int>(kDegrees)>(x, y, z, out); }...};
}
}  // namespace detail

/// Throws std::invalid_argument unless 0 <= degree <= kMaxDegree.
inline void require_degree(int degree) {
  if (degree < 0 || degree > kMaxDegree) {
    throw std::invalid_argument("degree " + std::to_string(degree) + " is out of range; 0 to " +
                                std::to_string(kMaxDegree) + " can be used");
  }
}

/// The kernel of a degree. Throws as require_degree does.
template <class T>
BasisKernel<T> basis_kernel(int degree) {
  static constexpr auto kKernels = detail::basis_kernels<T>(std::make_index_sequence<kMaxDegree + 1>());
  require_degree(degree);
  return kKernels[static_cast<std::size_t>(degree)];
}

}  // namespace sh::prt
