// Runs a template for a range of degrees.
#pragma once

#include <utility>

namespace sh::bench {

/// Calls f.operator()<Degree>() for First..Last.
template <int First, int Last, class F>
void for_degrees(const F& f) {
  [&]<int... kOffset>(std::integer_sequence<int, kOffset...>) { (f.template operator()<First + kOffset>(), ...); }
  (std::make_integer_sequence<int, Last - First + 1>());
}

constexpr std::size_t count_of(int degree) {
  const int count = (degree + 1) * (degree + 1);
  return static_cast<std::size_t>(count);
}

}  // namespace sh::bench
