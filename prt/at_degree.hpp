// Calls the generated kernels with a degree that is chosen at run time.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "prt/transfer/shape.hpp"

namespace sh::prt {

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

}  // namespace sh::prt
