// Vectors of W floats for kernels with SIMD inside one call.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>
#include <cstring>
#include <utility>

namespace sh::batch::SH_BATCH_ISA {

template <int W>
struct VectorOf;
template <>
struct VectorOf<4> {
  using type = float __attribute__((vector_size(16)));
};
template <>
struct VectorOf<8> {
  using type = float __attribute__((vector_size(32)));
};
template <>
struct VectorOf<16> {
  using type = float __attribute__((vector_size(64)));
};
template <int W>
using Vector = typename VectorOf<W>::type;

template <int W>
inline Vector<W> load_vector(const float* from) {
  Vector<W> v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

// Calls f(std::integral_constant<int, i>) for i = 0 .. N-1, unrolled.
template <class F, int... I>
[[gnu::always_inline]] inline void repeat(F& f, std::integer_sequence<int, I...> /*indices*/) {
  (f(std::integral_constant<int, I>{}), ...);
}
template <int N, class F>
[[gnu::always_inline]] inline void repeat(F f) {
  repeat(f, std::make_integer_sequence<int, N>{});
}

// Lane i of the result is lane Index::at(i) of a followed by b.
template <class Index, class V, int... I>
[[gnu::always_inline]] inline V shuffle(V a, V b, std::integer_sequence<int, I...> /*lanes*/) {
  return __builtin_shufflevector(a, b, Index::at(I)...);
}
template <class Index, class V>
[[gnu::always_inline]] inline V shuffle(V a, V b) {
  return shuffle<Index>(a, b, std::make_integer_sequence<int, int(sizeof(V) / sizeof(float))>{});
}

}  // namespace sh::batch::SH_BATCH_ISA
