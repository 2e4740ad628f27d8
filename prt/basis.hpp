// The generated basis kernels behind a degree chosen at run time.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>

#include "generated/cpp/basis.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// out (bands^2) = Y_lm(direction), l = 0..degree; |direction| = 1, 0 <= degree <= kMaxDegree.
template <class T>
void evaluate_basis(int degree, T x, T y, T z, T* out) {
  using Kernel = void (*)(T, T, T, T*);
  static constexpr auto kKernels = []<std::size_t... Degree>(std::index_sequence<Degree...>) {
    return std::array<Kernel, sizeof...(Degree)>{
        [](T a, T b, T c, T* result) { sh::basis<static_cast<int>(Degree)>(a, b, c, result); }...};
  }
  (std::make_index_sequence<kMaxDegree + 1>());
  kKernels[static_cast<std::size_t>(degree)](x, y, z, out);
}

}  // namespace sh::prt
