// Rotation of one vector of coefficients with AVX2: orders m of a band in the lanes of one register, -m in another.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// R = Rz(alpha) S Rz(b) S Rz(gamma), where S swaps y and z: as in rotate_lanes.hpp, but for the sign of the angles. A turn
// about z takes four operations and no permutation. Tables: turns.hpp.
#pragma once

#include <immintrin.h>

#include "turns.hpp"
#include "vectors.hpp"

namespace sh::batch::SH_BATCH_ISA {

using Eight = Vector<8>;

// The lanes with a bit of their number set come from the second register, the others from the first.
template <int Bit>
struct LanesWith {
  static constexpr int at(int lane) { return (lane & Bit) != 0 ? 8 + lane : lane; }
};

// A complex number in every lane.
struct Complex {
  Eight re;
  Eight im;
  [[gnu::always_inline]] friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};
[[gnu::always_inline]] inline Complex square(const Complex& z) {
  return {z.re * z.re - z.im * z.im, (z.re + z.re) * z.im};
}
// z in the lanes with a bit of their number set, 1 in the others.
template <int Bit>
[[gnu::always_inline]] inline Complex where(const Complex& z) {
  return {shuffle<LanesWith<Bit>>(Eight{} + 1.0F, z.re), shuffle<LanesWith<Bit>>(Eight{}, z.im)};
}

// The multiples of gamma, b and alpha: lane k of all_ holds e^(i k angle); low_ holds k = 0 to 3 twice.
template <int Degree>
class PairAngles {
 public:
  // r: rotation matrix, row by row. No angle is formed. Where sin^2(b) is tiny, gamma is 0 and alpha takes the whole turn.
  // Gamma comes first and from the fewest operations, because it is needed first.
  [[gnu::always_inline]] explicit PairAngles(const float* r) {
    constexpr float kTiny = 1.9721523e-31F;  // 2^-102
    Eight x = same(r[6]);
    Eight y = same(r[7]);
    const Eight z = same(r[8]);
    const Eight sine_square = x * x + y * y;
    Eight length_square = sine_square;
    if (__builtin_expect(static_cast<long>(sine_square[0] < kTiny), 0L) != 0) {
      x = length_square = same(1.0F);
      y = Eight{};
    }
    const Eight inverse_square = 1.0F / length_square;
    const Eight inverse = inverse_square * Eight(_mm256_sqrt_ps(length_square));
    const Complex first{x * inverse, y * inverse};  // of -gamma
    const Eight y2 = y + y;
    set(kGamma, first, {1.0F - (y * y2) * inverse_square, (x * y2) * inverse_square});
    // To length 1: an error of a length grows with the multiple.
    const Eight correction = 1.5F - 0.5F * (z * z + sine_square);
    const Complex tilt{z * correction, sine_square * inverse * correction};
    set(kB, tilt, square(tilt));
    const Complex last{same(r[4]) * first.re - same(r[3]) * first.im, same(r[0]) * first.im - same(r[1]) * first.re};
    const Eight unit = 1.5F - 0.5F * (last.re * last.re + last.im * last.im);
    const Complex alpha{last.re * unit, last.im * unit};
    set(kAlpha, alpha, square(alpha));
  }

  // Coefficients of Band (of 3 and 2 at once) in pairs.
  template <int Band>
  [[gnu::always_inline]] void rotate(Complex& v) const {
    turn<Band, kGamma>(v);
    swap<Band>(v);
    turn<Band, kB>(v);
    swap<Band>(v);
    turn<Band, kAlpha>(v);
  }

 private:
  enum Angle { kGamma, kB, kAlpha };

  [[gnu::always_inline]] static Eight same(float x) { return _mm256_set1_ps(x); }

  [[gnu::always_inline]] void set(Angle angle, const Complex& once, const Complex& twice) {
    low_[angle] = where<1>(once) * where<2>(twice);
    if constexpr (Degree > 3) all_[angle] = low_[angle] * where<4>(square(twice));
  }

  template <int Band, Angle Of>
  [[gnu::always_inline]] void turn(Complex& v) const {
    const Complex& e = Band == 3 ? low_[Of] : all_[Of];
    v = Of == kGamma ? Complex{v.re * e.re + v.im * e.im, v.im * e.re - v.re * e.im} : v * e;
  }

  // Rows and columns of D(S).
  template <class Pairs, int T>
  struct CosineColumn {
    static constexpr int at(int lane) { return Pairs::kCosineColumn[T][lane]; }
  };
  template <class Pairs, int T>
  struct SineColumn {
    static constexpr int at(int lane) { return Pairs::kSineColumn[T][lane]; }
  };
  static constexpr int lanes_of(int band) { return band == 3 ? 4 : 8; }
  // Order -m to lane m - 1.
  template <int Band>
  struct Lower {
    static constexpr int at(int lane) { return (lane + 1) % lanes_of(Band) == 0 ? lane : lane + 1; }
  };
  // Orders with l + |m| = Parity modulo 2: cosines from the first register, sines, a lane lower, from the second.
  template <int Band, int Parity>
  struct Columns {
    static constexpr int at(int lane) {
      return (detail::Pairs<Band>::kBands[lane / lanes_of(Band)] + lane) % 2 == Parity ? lane : 8 + lane;
    }
  };

  template <int Band>
  [[gnu::always_inline]] static void swap(Complex& v) {
    using Pairs = detail::Pairs<Band>;
    const Eight lower = shuffle<Lower<Band>>(v.im, v.im);
    const Eight even = shuffle<Columns<Band, 0>>(v.re, lower);
    const Eight odd = shuffle<Columns<Band, 1>>(v.re, lower);
    v.re = load_vector<8>(Pairs::kCosine[0]) * shuffle<CosineColumn<Pairs, 0>>(even, even);
    repeat<Pairs::kCosineRounds - 1>([&](auto t) {
      v.re += load_vector<8>(Pairs::kCosine[t + 1]) * shuffle<CosineColumn<Pairs, t + 1>>(even, even);
    });
    v.im = load_vector<8>(Pairs::kSine[0]) * shuffle<SineColumn<Pairs, 0>>(odd, odd);
    repeat<Pairs::kSineRounds - 1>(
        [&](auto t) { v.im += load_vector<8>(Pairs::kSine[t + 1]) * shuffle<SineColumn<Pairs, t + 1>>(odd, odd); });
  }

  Complex low_[3];
  Complex all_[3];
};

// Coefficients -Band .. 0 and back: lane m has order -m. (Backward<3>: in each half.)
template <int Band>
struct Backward {
  static constexpr int at(int lane) {
    if (Band == 3) return lane ^ 3;
    return lane <= Band ? Band - lane : lane;
  }
};

[[gnu::always_inline]] inline Eight halves(const float* first, const float* second) {
  return _mm256_set_m128(_mm_loadu_ps(second), _mm_loadu_ps(first));
}
[[gnu::always_inline]] inline __m128 lower(Eight v) { return _mm256_castps256_ps128(v); }
[[gnu::always_inline]] inline __m128 upper(Eight v) { return _mm256_extractf128_ps(v, 1); }

// Lanes m <= Band.
template <int Band>
[[gnu::always_inline]] inline __m256i orders() {
  return _mm256_setr_epi32(-1, -1, -1, -1, -(Band >= 4), -(Band >= 5), -(Band >= 6), -(Band >= 7));
}

// Band, of which c points to order 0, in pairs. The last band's registers read nothing behind it; of other bands, lanes
// beyond their orders hold coefficients of the next one, which nothing uses.
template <int Band, bool IsLast>
[[gnu::always_inline]] inline Complex load_pairs(const float* c) {
  const Eight backward = load_vector<8>(c - Band);
  return {IsLast && Band < 7 ? Eight(_mm256_maskload_ps(c, orders<Band>())) : load_vector<8>(c),
          shuffle<Backward<Band>>(backward, backward)};
}

// What is written beyond a band is written again by the next one.
template <int Band, bool IsLast>
[[gnu::always_inline]] inline void store_pairs(const Complex& v, float* out) {
  const Eight backward = shuffle<Backward<Band>>(v.im, v.im);
  std::memcpy(out - Band, &backward, sizeof backward);
  if constexpr (!IsLast || Band == 7) {
    std::memcpy(out, &v.re, sizeof v.re);
  } else {
    const __m128 above = upper(v.re);
    _mm_storeu_ps(out, lower(v.re));
    if constexpr (Band == 4) _mm_store_ss(out + 4, above);
    if constexpr (Band >= 5) _mm_storel_pi(reinterpret_cast<__m64*>(out + 4), above);
    if constexpr (Band == 6) _mm_store_ss(out + 6, _mm_movehl_ps(above, above));
  }
}

// Degree 3 to 7; out may be c.
template <int Degree>
[[gnu::flatten]] void rotate_pairs(const float* r, const float* c, float* out) {
  const PairAngles<Degree> angles(r);
  const float zero = c[0];
  const float y = r[4] * c[1] + r[5] * c[2] + r[3] * c[3];
  const float z = r[7] * c[1] + r[8] * c[2] + r[6] * c[3];
  const float x = r[1] * c[1] + r[2] * c[2] + r[0] * c[3];
  constexpr int kAbove = Degree - 3;
  const Eight backward = halves(c + 9, c + 3);
  Complex three_and_two{halves(c + 12, c + 6), shuffle<Backward<3>>(backward, backward)};
  Complex above[kAbove + 1];
  repeat<kAbove>([&](auto i) {
    constexpr int kBand = 4 + i;
    above[i] = load_pairs<kBand, kBand == Degree>(c + kBand * (kBand + 1));
  });
  angles.template rotate<3>(three_and_two);
  repeat<kAbove>([&](auto i) { angles.template rotate<4 + i>(above[i]); });
  const Eight back = shuffle<Backward<3>>(three_and_two.im, three_and_two.im);
  _mm_storeu_ps(out + 3, upper(back));
  out[0] = zero;
  out[1] = y;
  out[2] = z;
  out[3] = x;
  _mm_storeu_ps(out + 6, upper(three_and_two.re));
  _mm_storeu_ps(out + 9, lower(back));
  _mm_storeu_ps(out + 12, lower(three_and_two.re));
  repeat<kAbove>([&](auto i) {
    constexpr int kBand = 4 + i;
    store_pairs<kBand, kBand == Degree>(above[i], out + kBand * (kBand + 1));
  });
}

}  // namespace sh::batch::SH_BATCH_ISA
