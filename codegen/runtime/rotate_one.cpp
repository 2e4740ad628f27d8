// Rotation of one vector of coefficients on the instruction set SH_BATCH_ISA: kernels by degree.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// SIMD inside with AVX2 and AVX-512, degree 3 to 7; otherwise the kernels of generated/cpp/rotate.hpp. A prepared matrix is
// the same on every instruction set: matrices to degree 1, columns of lanes above.
#include "../cpp/rotate.hpp"
#include "../cpp/rotate_apply.hpp"
#include "../cpp/rotate_build.hpp"
#include "call.hpp"
#include "turns.hpp"
#include "vectors.hpp"

#if defined(__AVX512F__)
#include "rotate_lanes.hpp"
#endif
#if defined(__AVX2__)
#include "rotate_pairs.hpp"
#endif

namespace sh::batch::SH_BATCH_ISA {
namespace {

constexpr int kLanes = 16;

// Lanes of a column of band l > 3: multiples of 8.
constexpr int lanes_of_band(int l) { return 2 * l + 1 <= kLanes ? kLanes : 24; }
// Where the columns of band l > 3 start: behind those that bands 0 to 3 share, seven, and those of the bands between.
// (Of l <= 4: how long the shared columns of the bands below l are.)
constexpr int first_of_band(int l) {
  return l <= 4 ? (2 * l - 1) * kLanes : first_of_band(l - 1) + (2 * l - 1) * lanes_of_band(l - 1);
}

template <int Degree>
void scalar(const float* r, const float* c, float* out) {
  sh::rotate<Degree>(r, c, out);
}
template <int Degree>
void build(const float* r, float* prepared) {
  sh::rotate_build<Degree>(r, prepared);
}
template <int Degree>
void apply(const float* prepared, const float* c, float* out) {
  sh::rotate_apply<Degree>(prepared, c, out);
}

// Column j of bands 0 to 3 in 16 lanes, j = 0 to 6 or less, then of each further band: what is beyond a band is 0.
template <int Degree>
void build_columns(const float* r, float* prepared) {
  constexpr int kBands = Degree + 1;
  float m[kBands * (2 * kBands - 1) * (2 * kBands + 1) / 3];
  sh::rotate_build<Degree>(r, static_cast<float*>(m));
  std::memset(prepared, 0, first_of_band(kBands) * sizeof(float));
  const auto* from = static_cast<const float*>(m);
  for (int l = 0; l <= Degree; ++l) {
    const int size = 2 * l + 1;
    const int step = l <= 3 ? kLanes : lanes_of_band(l);
    float* const to = l <= 3 ? prepared + l * l : prepared + first_of_band(l);
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) to[j * step + i] = from[i * size + j];
    }
    from += size * size;
  }
}

#if defined(__AVX__)
// Column J of bands 1 and 2, whose lanes begin at band 1.
template <int J>
struct ColumnOfTwoBands {
  static constexpr int at(int lane) { return detail::kColumnOfBands[J][lane + 1] - 1; }
};

// Degree 2, by the columns that bands 0 to 3 share: bands 1 and 2 fill 8 lanes.
inline void apply_two_bands(const float* prepared, const float* c, float* out) {
  const float first = prepared[0] * c[0];
  const Vector<8> v = load_vector<8>(c + 1);
  Vector<8> sum = load_vector<8>(prepared + 1) * shuffle<ColumnOfTwoBands<0>>(v, v);
  repeat<4>(
      [&](auto j) { sum += load_vector<8>(prepared + (j + 1) * kLanes + 1) * shuffle<ColumnOfTwoBands<j + 1>>(v, v); });
  out[0] = first;
  std::memcpy(out + 1, &sum, sizeof sum);
}
#endif

#if defined(__AVX512F__)
template <int Degree>
[[gnu::flatten]] void lanes(const float* r, const float* c, float* out) {
  const MultipleAngles<Degree> angles(r);
  angles.template rotate<detail::Turns0>(c, out);
  if constexpr (Degree >= 4) angles.template rotate<detail::Turns4>(c, out);
  if constexpr (Degree >= 5) angles.template rotate<detail::Turns5>(c, out);
  if constexpr (Degree >= 6) angles.template rotate<detail::Turns6>(c, out);
}
template <int Degree>
[[gnu::flatten]] void apply_columns(const float* prepared, const float* c, float* out) {
  if constexpr (Degree == 2) return apply_two_bands(prepared, c, out);
  apply_first_bands(prepared, c, out);
  __m512 four;
  repeat<(Degree > 3 ? Degree - 3 : 0)>([&](auto above) {
    constexpr int kL = 4 + above;
    apply_band<Degree, kL, lanes_of_band(kL)>(prepared + first_of_band(kL), c, four, out);
  });
}
#else
#if defined(__AVX__)
constexpr int kWidth = 8;
#else
constexpr int kWidth = 4;
#endif

// Band L by its columns of Step lanes, of which the first is Lane; out may be c.
template <int L, int Lane, int Step>
[[gnu::always_inline]] inline void apply_band(const float* columns, const float* c, float* out) {
  constexpr int size = 2 * L + 1;
  constexpr int vectors = (size + kWidth - 1) / kWidth;
  constexpr int before = Lane + vectors * kWidth > Step ? Lane + vectors * kWidth - Step : 0;
  Vector<kWidth> sum[vectors] = {};
  repeat<size>([&](auto j) {
    const float* column = columns + j * Step + Lane - before;
    repeat<vectors>([&](auto v) { sum[v] += load_vector<kWidth>(column + v * kWidth) * c[L * L + j]; });
  });
  std::memcpy(out + L * L, reinterpret_cast<const char*>(sum) + before * sizeof(float), size * sizeof(float));
}

template <int Degree>
[[gnu::flatten]] void apply_columns(const float* prepared, const float* c, float* out) {
#if defined(__AVX__)
  if constexpr (Degree == 2) return apply_two_bands(prepared, c, out);
#endif
  out[0] = prepared[0] * c[0];
  apply_band<1, 1, kLanes>(prepared, c, out);
  apply_band<2, 4, kLanes>(prepared, c, out);
  if constexpr (Degree > 2) apply_band<3, 9, kLanes>(prepared, c, out);
  repeat<(Degree > 3 ? Degree - 3 : 0)>([&](auto above) {
    constexpr int kL = 4 + above;
    apply_band<kL, 0, lanes_of_band(kL)>(prepared + first_of_band(kL), c, out);
  });
}
#endif

// The fastest way for degree 3 to 7.
template <int Degree>
constexpr detail::RotateOne fastest() {
#if defined(__AVX512F__)
  if constexpr (Degree <= detail::kLastTurnDegree) return lanes<Degree>;
#endif
#if defined(__AVX2__)
  return rotate_pairs<Degree>;
#else
  return scalar<Degree>;
#endif
}

}  // namespace

extern const detail::RotateOne kRotateOne[];
const detail::RotateOne kRotateOne[] = {scalar<0>,    scalar<1>,    scalar<2>, fastest<3>(), fastest<4>(), fastest<5>(),
                                        fastest<6>(), fastest<7>(), scalar<8>, scalar<9>,    scalar<10>};
extern const detail::RotatePrepare kRotatePrepareOne[];
const detail::RotatePrepare kRotatePrepareOne[] = {
    build<0>,         build<1>,         build_columns<2>, build_columns<3>, build_columns<4>, build_columns<5>,
    build_columns<6>, build_columns<7>, build_columns<8>, build_columns<9>, build_columns<10>};
extern const detail::RotateOne kRotatePreparedOne[];
const detail::RotateOne kRotatePreparedOne[] = {apply<0>,         apply<1>,         apply_columns<2>, apply_columns<3>,
                                                apply_columns<4>, apply_columns<5>, apply_columns<6>, apply_columns<7>,
                                                apply_columns<8>, apply_columns<9>, apply_columns<10>};

}  // namespace sh::batch::SH_BATCH_ISA
