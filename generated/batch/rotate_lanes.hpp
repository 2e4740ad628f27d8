// Rotation of one vector of coefficients with a coefficient in each of 16 lanes of AVX-512.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// R = Rz(alpha) Ry(beta) Rz(gamma), Ry(beta) = S Rz(-beta) S, where S swaps y and z
// (D. Pinchon, P. E. Hoggan, "Rotation matrices for real spherical harmonics", J. Phys. A 40, 2007); tables: turns.hpp.
#pragma once

#include <immintrin.h>

#include "turns.hpp"
#include "vectors.hpp"

namespace sh::batch::SH_BATCH_ISA {

inline __m512 permute(const int* lanes, __m512 v) { return _mm512_permutexvar_ps(_mm512_load_si512(lanes), v); }

// Cosines and sines of the multiples of alpha, -beta and gamma.
template <int Degree>
class MultipleAngles {
  enum Angle { kAlpha, kBeta, kGamma };

 public:
  // r: rotation matrix, row by row. No angle is formed, and there is no hole at beta = 0 or pi: where sin^2(beta) is
  // tiny, alpha is 0 and gamma takes the whole turn.
  [[gnu::always_inline]] explicit MultipleAngles(const float* r) {
    constexpr float kTiny = 1.9721523e-31F;  // 2^-102
    const float sine_square = r[2] * r[2] + r[5] * r[5];
    const bool pole = sine_square < kTiny;
    const float x = pole ? 1.0F : r[2];
    const float y = pole ? 0.0F : r[5];
    const float square = pole ? 1.0F : sine_square;
    // Of alpha, beta and gamma times the length sin(beta), but for the cosine of beta: that, and with it the sine, only
    // to length 1. An error of a length grows with the multiple.
    const float correction = 1.5F - 0.5F * (r[8] * r[8] + sine_square);
    const __m128 cosines = _mm_setr_ps(x, r[8] * correction, r[4] * x - r[1] * y, 0.0F);
    const __m128 sines = _mm_setr_ps(y, -sine_square * correction, r[3] * x - r[0] * y, 0.0F);
    constexpr __mmask8 kOfBeta = 1U << kBeta;
    constexpr __mmask8 kOthers = 1U << kAlpha | 1U << kGamma;
    const __m128 squares = _mm_mask_mov_ps(_mm_fmadd_ps(cosines, cosines, sines * sines), kOfBeta, _mm_set1_ps(square));
    // One of Newton's steps to the inverse square roots from a common estimate with 14 bits.
    const __m128 single = _mm_set_ss(square);
    const __m128 estimate = _mm_broadcastss_ps(_mm_rsqrt14_ss(single, single));
    const __m128 step = 1.5F - squares * (estimate * estimate * 0.5F);
    const __m128 c = _mm_mask_mul_ps(cosines, kOthers, cosines * estimate, step);
    const __m128 s = sines * estimate * step;
    multiply_angles(c, s);
  }

  // The bands of Turns of a rotated function; out may be c.
  template <class Turns>
  [[gnu::always_inline]] void rotate(const float* c, float* out) const {
    constexpr __mmask16 mask = Turns::kLanes == 16 ? 0xffff : (1U << Turns::kLanes) - 1;
    constexpr int first = Turns::kFirst * Turns::kFirst;
    __m512 v = _mm512_maskz_loadu_ps(mask, c + first);
    v = turn<Turns, kGamma>(v);
    v = swap<Turns>(v);
    v = turn<Turns, kBeta>(v);
    v = swap<Turns>(v);
    v = turn<Turns, kAlpha>(v);
    _mm512_mask_storeu_ps(out + first, mask, v);
  }

 private:
  // c, s: cosines and sines of three angles.
  [[gnu::always_inline]] void multiply_angles(__m128 c, __m128 s) {
    constexpr __mmask16 kFirst = 0x00f0;
    constexpr __mmask16 kSecond = 0x0f00;
    constexpr __mmask16 kThird = 0xf000;
    const __m512 c1 = _mm512_broadcast_f32x4(c);
    const __m512 s1 = _mm512_broadcast_f32x4(s);
    const __m512 c2 = c1 * c1 - s1 * s1;
    const __m512 s2 = (c1 + c1) * s1;
    const __m512 c3 = c1 * c2 - s1 * s2;
    const __m512 s3 = c1 * s2 + s1 * c2;
    const __m512 to_second_c = _mm512_mask_mov_ps(_mm512_mask_mov_ps(_mm512_set1_ps(1.0F), kFirst, c1), kSecond, c2);
    const __m512 to_second_s = _mm512_mask_mov_ps(_mm512_maskz_mov_ps(kFirst, s1), kSecond, s2);
    cosine_[0] = _mm512_mask_mov_ps(to_second_c, kThird, c3);
    sine_[0] = _mm512_mask_mov_ps(to_second_s, kThird, s3);
    if constexpr (Degree > 3) {
      const __m512 c4 = c2 * c2 - s2 * s2;
      const __m512 s4 = (c2 + c2) * s2;
      cosine_[1] = c4 * cosine_[0] - s4 * sine_[0];
      sine_[1] = c4 * sine_[0] + s4 * cosine_[0];
    }
  }

  // By the multiples of alpha, beta or gamma about z.
  template <class Turns, Angle Of>
  [[gnu::always_inline]] __m512 turn(__m512 v) const {
    __m512 cosine;
    __m512 sine;
    if constexpr (Turns::kLast <= 3) {
      cosine = permute(Turns::kMultiple[Of], cosine_[0]);
      sine = permute(Turns::kMultiple[Of], sine_[0]);
    } else {
      const __m512i lanes = _mm512_load_si512(Turns::kMultiple[Of]);
      cosine = _mm512_permutex2var_ps(cosine_[0], lanes, cosine_[1]);
      sine = _mm512_permutex2var_ps(sine_[0], lanes, sine_[1]);
    }
    // Whatever does not depend on what comes last is done before.
    const __m512 sign = _mm512_load_ps(Turns::kSign);
    const __m512 partner = permute(Turns::kPartner, v);
    if constexpr (Of == kGamma) return _mm512_fmadd_ps(sine, sign * partner, cosine * v);
    return _mm512_fmadd_ps(sine * sign, partner, cosine * v);
  }

  // By D(S), an entry of every row a round.
  template <class Turns>
  [[gnu::always_inline]] static __m512 swap(__m512 v) {
    __m512 sum = _mm512_load_ps(Turns::kSwap[0]) * permute(Turns::kSwapColumn[0], v);
    repeat<Turns::kSwapRounds - 1>(
        [&](auto t) { sum += _mm512_load_ps(Turns::kSwap[t + 1]) * permute(Turns::kSwapColumn[t + 1], v); });
    return sum;
  }

  __m512 cosine_[2];  // lane 4k + angle: cos(k angle)
  __m512 sine_[2];
};

// Bands 0 to 3 of a rotated function by the columns of their matrices; out may be c. The lanes of each column follow from
// those of the one before it: additions, for loads are what takes the time.
inline void apply_first_bands(const float* columns, const float* c, float* out) {
  const __m512 v = _mm512_loadu_ps(c);
  int next = 1;
  asm("" : "+r"(next));  // or compilers would load every sum, computed by themselves
  const __m512i step = _mm512_set1_epi32(next);
  __m512i lanes = _mm512_load_si512(detail::kColumnOfBands[0]);
  __m512 sum = _mm512_loadu_ps(columns) * _mm512_permutexvar_ps(lanes, v);
  repeat<6>([&](auto j) {
    constexpr int kFirstBand = (j + 2) / 2;  // that has a further column
    constexpr __mmask16 kLonger = 0xffffU << kFirstBand * kFirstBand & 0xffffU;
    lanes = _mm512_mask_add_epi32(lanes, kLonger, lanes, step);
    sum += _mm512_loadu_ps(columns + (j + 1) * 16) * _mm512_permutexvar_ps(lanes, v);
  });
  _mm512_storeu_ps(out, sum);
}

// Four values in every quarter of a register. Compilers would otherwise load each value in all lanes by itself, and Ice Lake
// loads 64 bytes a cycle, a value in all lanes or not.
[[gnu::always_inline]] inline __m512 load_four(const float* from) {
  __m512 four = _mm512_broadcast_f32x4(_mm_loadu_ps(from));
  asm("" : "+v"(four));
  return four;
}

// Band L > 3 of Degree by its columns of Step lanes, 16 or 24. Columns take turns among `kSums` sums, so that no column
// waits for the one before it. four: the last values that were loaded, of the band before at first.
template <int Degree, int L, int Step>
[[gnu::always_inline]] inline void apply_band(const float* columns, const float* c, __m512& four, float* out) {
  constexpr int kSize = 2 * L + 1;
  constexpr int kSums = L < 6 ? 2 : 4;
  constexpr int kAbove = kSize - 16;  // rows beyond the first 16 lanes
  constexpr int kLastFour = (Degree + 1) * (Degree + 1) - 4;
  __m512 first[kSums];
  __m256 above[kSums];
  repeat<kSize>([&](auto j) {
    const float* column = columns + j * Step;
    constexpr int kPlace = L * L + j;
    constexpr int kFour = kPlace / 4 * 4 < kLastFour ? kPlace / 4 * 4 : kLastFour;
    constexpr int kEveryQuarter = 0x55;
    if constexpr (kPlace % 4 == 0) four = load_four(c + kFour);
    const __m512 factor = _mm512_permute_ps(four, (kPlace - kFour) * kEveryQuarter);
    const __m512 term = _mm512_loadu_ps(column);
    if constexpr (j < kSums) {
      first[j] = term * factor;
    } else {
      first[j % kSums] += term * factor;
    }
    if constexpr (kAbove > 0) {
      const __m256 rest = _mm256_loadu_ps(column + 16) * _mm512_castps512_ps256(factor);
      if constexpr (j < kSums) {
        above[j] = rest;
      } else {
        above[j % kSums] += rest;
      }
    }
  });
  if constexpr (kSums == 4) {
    first[0] += first[2];
    first[1] += first[3];
  }
  constexpr __mmask16 kMask = kAbove >= 0 ? 0xffff : (1U << kSize) - 1;
  _mm512_mask_storeu_ps(out + L * L, kMask, first[0] + first[1]);
  if constexpr (kAbove > 0) {
    constexpr __mmask8 kRest = (1U << kAbove) - 1;
    const __m256 rest = above[0] + above[1] + (above[2] + above[3]);
    _mm256_mask_storeu_ps(out + L * L + 16, kRest, rest);
  }
}

}  // namespace sh::batch::SH_BATCH_ISA
