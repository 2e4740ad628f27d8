// One product of two functions on the instruction set SH_BATCH_ISA: kernels by degree.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// With AVX2 or AVX-512 SIMD inside the product; otherwise, and where that does not pay, the kernel of
// generated/cpp/product.hpp.
#include "../cpp/product.hpp"
#include "call.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include "orbits_l3.hpp"
#include "orbits_l4.hpp"
#include "orbits_l5.hpp"
#include "orbits_l6.hpp"
#include "product_orbits.hpp"
#endif
#if defined(__AVX512F__)
#include <immintrin.h>

#include "triples_l2.hpp"
#endif

namespace sh::batch::SH_BATCH_ISA {
namespace {

template <int Degree>
void scalar(const float* a, const float* b, float* c) {
  sh::product<Degree>(a, b, c);
}

#if defined(__AVX512F__)
// Degree 2, term by term, as triples_l2.hpp says.
void triples(const float* a, const float* b, float* c) {
  using Table = detail::Triples2;
  constexpr __mmask16 kNine = 0x1ff;
  const __m512 va = _mm512_maskz_loadu_ps(kNine, a);
  const __m512 vb = _mm512_maskz_loadu_ps(kNine, b);
  const auto constants = [](const float* from) { return _mm512_load_ps(from); };
  const auto permuted = [](const int* lanes, __m512 v) { return _mm512_permutexvar_ps(_mm512_load_si512(lanes), v); };
  __m512 scale_a = constants(Table::kScales[0]) * _mm512_set1_ps(a[Table::kEven[0]]);
  __m512 scale_b = constants(Table::kScales[0]) * _mm512_set1_ps(b[Table::kEven[0]]);
  for (int e = 1; e < 3; ++e) {
    scale_a += constants(Table::kScales[e]) * _mm512_set1_ps(a[Table::kEven[e]]);
    scale_b += constants(Table::kScales[e]) * _mm512_set1_ps(b[Table::kEven[e]]);
  }
  __m512 sum = scale_a * vb + scale_b * va;
  for (int t = 0; t < Table::kRounds; ++t) {
    sum += constants(Table::kG[t]) * permuted(Table::kI[t], va) * permuted(Table::kJ[t], vb);
  }
  sum += permuted(Table::kMore, sum);
  _mm512_mask_storeu_ps(c, kNine, sum);
}
#endif

#if defined(__AVX2__) && defined(__FMA__)
template <int W, class Orbits>
[[gnu::flatten]] void orbits(const float* a, const float* b, float* c) {
  OrbitProduct<W, Orbits>::run(a, b, c);
}
#endif

}  // namespace

extern const detail::ProductOne kProductOne[];
const detail::ProductOne kProductOne[] = {
    scalar<0>,
    scalar<1>,
#if defined(__AVX512F__)
    triples,
    orbits<16, WithAntipodes<detail::Orbits3>>,
    orbits<16, detail::Orbits4>,
    orbits<16, detail::Orbits5>,
    orbits<16, detail::Orbits6>,
#elif defined(__AVX2__) && defined(__FMA__)
    scalar<2>,
    orbits<8, detail::Orbits3>,
    orbits<8, detail::Orbits4>,
    orbits<8, detail::Orbits5>,
    orbits<8, detail::Orbits6>,
#else
    scalar<2>, scalar<3>, scalar<4>, scalar<5>,  scalar<6>,
#endif
    scalar<7>,
    scalar<8>,
    scalar<9>,
    scalar<10>,
};

}  // namespace sh::batch::SH_BATCH_ISA
