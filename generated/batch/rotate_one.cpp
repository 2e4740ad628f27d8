// Rotation of one vector of coefficients on the instruction set SH_BATCH_ISA: kernels by degree.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
// With AVX-512 SIMD inside, degree 3 to 6; otherwise the kernels of generated/cpp/rotate.hpp. A prepared matrix is the
// same on every instruction set.
#include "../cpp/rotate.hpp"
#include "../cpp/rotate_apply.hpp"
#include "../cpp/rotate_build.hpp"
#include "call.hpp"

#if defined(__AVX512F__)
#include "rotate_lanes.hpp"
#else
#include "vectors.hpp"
#endif

namespace sh::batch::SH_BATCH_ISA {
namespace {

constexpr int kLanes = 16;

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

// Column j of bands 0 to 3 in 16 lanes, j = 0 to 6, then of each further band: what is beyond a band is 0.
template <int Degree>
void build_columns(const float* r, float* prepared) {
  constexpr int kBands = Degree + 1;
  float m[kBands * (2 * kBands - 1) * (2 * kBands + 1) / 3];
  sh::rotate_build<Degree>(r, static_cast<float*>(m));
  const auto* from = static_cast<const float*>(m);
  float* column = prepared;
  for (int l = 0; l <= Degree; ++l) {
    const int size = 2 * l + 1;
    const int lane = l <= 3 ? l * l : 0;
    const int columns = l <= 3 ? 7 : size;
    if (l == 0 || l > 3) {
      for (int i = 0; i < columns * kLanes; ++i) column[i] = 0;
    }
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) column[j * kLanes + lane + i] = from[i * size + j];
    }
    from += size * size;
    if (l >= 3) column += columns * kLanes;
  }
}

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
  apply_first_bands(prepared, c, out);
  if constexpr (Degree >= 4) apply_band<4>(prepared + 7 * kLanes, c, out);
  if constexpr (Degree >= 5) apply_band<5>(prepared + 16 * kLanes, c, out);
  if constexpr (Degree >= 6) apply_band<6>(prepared + 27 * kLanes, c, out);
}
#else
template <int Degree>
constexpr auto lanes = scalar<Degree>;

#if defined(__AVX__)
constexpr int kWidth = 8;
#else
constexpr int kWidth = 4;
#endif

// Band L by its columns, whose first lane is Lane; out may be c.
template <int L, int Lane>
[[gnu::always_inline]] inline void apply_band(const float* columns, const float* c, float* out) {
  constexpr int size = 2 * L + 1;
  constexpr int vectors = (size + kWidth - 1) / kWidth;
  constexpr int before = Lane + vectors * kWidth > kLanes ? Lane + vectors * kWidth - kLanes : 0;
  Vector<kWidth> sum[vectors] = {};
  repeat<size>([&](auto j) {
    const float* column = columns + j * kLanes + Lane - before;
    repeat<vectors>([&](auto v) { sum[v] += load_vector<kWidth>(column + v * kWidth) * c[L * L + j]; });
  });
  std::memcpy(out + L * L, reinterpret_cast<const char*>(sum) + before * sizeof(float), size * sizeof(float));
}

template <int Degree>
[[gnu::flatten]] void apply_columns(const float* prepared, const float* c, float* out) {
  out[0] = prepared[0] * c[0];
  apply_band<1, 1>(prepared, c, out);
  apply_band<2, 4>(prepared, c, out);
  apply_band<3, 9>(prepared, c, out);
  if constexpr (Degree >= 4) apply_band<4, 0>(prepared + 7 * kLanes, c, out);
  if constexpr (Degree >= 5) apply_band<5, 0>(prepared + 16 * kLanes, c, out);
  if constexpr (Degree >= 6) apply_band<6, 0>(prepared + 27 * kLanes, c, out);
}
#endif

}  // namespace

extern const detail::RotateOne kRotateOne[];
const detail::RotateOne kRotateOne[] = {scalar<0>, scalar<1>, scalar<2>, lanes<3>,  lanes<4>,  lanes<5>,
                                        lanes<6>,  scalar<7>, scalar<8>, scalar<9>, scalar<10>};
extern const detail::RotatePrepare kRotatePrepareOne[];
const detail::RotatePrepare kRotatePrepareOne[] = {
    build<0>,         build<1>, build<2>, build_columns<3>, build_columns<4>, build_columns<5>,
    build_columns<6>, build<7>, build<8>, build<9>,         build<10>};
extern const detail::RotateOne kRotatePreparedOne[];
const detail::RotateOne kRotatePreparedOne[] = {apply<0>,         apply<1>,         apply<2>,         apply_columns<3>,
                                                apply_columns<4>, apply_columns<5>, apply_columns<6>, apply<7>,
                                                apply<8>,         apply<9>,         apply<10>};

}  // namespace sh::batch::SH_BATCH_ISA
