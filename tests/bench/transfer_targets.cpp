// Transferred radiance of many vertices under one light, from 81 numbers of visibility a vertex, against 25x25 transfer
// matrices times the light [Sloan, Kautz and Snyder, 2002, section 4]. The matrices lie in blocks of 16 vertices, so that
// each is read once, in order, and serves three channels. More vertices than fit into the caches.
#if defined(__F16C__) || defined(__AVX512F__)
#include <immintrin.h>
#endif

#include <array>
#include <string>

#include "generated/batch/batch.hpp"
#include "generated/cpp/transfer_prepare.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr int kDegree = 4;
constexpr int kChannels = 3;
constexpr std::size_t kVertices = 131072;
constexpr std::size_t kSize = coefficient_count(kDegree);
constexpr std::size_t kVisibility = coefficient_count(2 * kDegree);
constexpr std::size_t kLanes = 16;
constexpr int kPasses = 7;

using Vector = Sixteen::Vector;
using Half = batch::Half;

inline Vector load(const float* from) { return *reinterpret_cast<const Vector*>(from); }

inline Vector load(const Half* from) {
#if defined(__AVX512F__)
  return reinterpret_cast<Vector>(
      _mm512_maskz_cvtph_ps(0xffff, _mm256_load_si256(reinterpret_cast<const __m256i*>(from))));
#elif defined(__F16C__)
  std::array<__m256, 2> wide{_mm256_cvtph_ps(_mm_load_si128(reinterpret_cast<const __m128i*>(from))),
                             _mm256_cvtph_ps(_mm_load_si128(reinterpret_cast<const __m128i*>(from + kLanes / 2)))};
  return *reinterpret_cast<const Vector*>(wide.data());
#else
  Vector wide;  // no such conversion here: a cheaper one in its place
  for (std::size_t i = 0; i < kLanes; ++i) wide[i] = static_cast<float>(static_cast<std::uint16_t>(from[i]));
  return wide;
#endif
}

// out = matrices times light, in blocks.
template <class T>
void multiply(const T* matrices, const float* light, float* out) {
  for (std::size_t block = 0; block < kVertices / kLanes; ++block) {
    for (std::size_t row = 0; row < kSize; ++row) {
      std::array<Vector, kChannels> sums{};
      for (std::size_t i = 0; i < kSize; ++i) {
        const Vector entry = load(matrices);
        __builtin_prefetch(matrices + 4096 / sizeof(T));
        matrices += kLanes;
        for (int channel = 0; channel < kChannels; ++channel) sums[channel] += entry * light[channel * kSize + i];
      }
      for (int channel = 0; channel < kChannels; ++channel) {
        *reinterpret_cast<Vector*>(out + (channel * kSize + row) * kLanes) = sums[channel];
      }
    }
    out += kChannels * kSize * kLanes;
  }
}

template <class T>
batch::Records<const T> records(const Buffer<T>& blocks) {
  return {blocks.get(), batch::Layout::kBlocked};
}

}  // namespace

void transfer(Table& table) {
  table.section("Transferred radiance in RGB, 5 bands, 131,072 vertices, one core, ns a vertex",
                "control: 25x25 matrices in blocks of 16 vertices, read once for three channels");
  const std::vector<float> lights = random_vectors(kChannels, kSize);
  std::vector<float> samples(kChannels * (8 * kDegree * kDegree + 4));
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    sh::transfer_prepare<kDegree>(&lights[channel * kSize], &samples[channel * samples.size() / kChannels]);
  }
  constexpr Half kQuarter{0x3400};
  const Buffer<float> visibility = make_buffer<float>(kVertices * kVisibility, 0.25F);
  const Buffer<Half> halves = make_buffer<Half>(kVertices * kVisibility, kQuarter);
  const Buffer<float> out = make_buffer<float>(kVertices * kChannels * kSize);
  const Buffer<float> matrices = make_buffer<float>(kVertices * kSize * kSize, 0.25F);
  const Buffer<Half> half_matrices = make_buffer<Half>(kVertices * kSize * kSize, kQuarter);
  const auto apply = [&](auto records_of) {
    batch::transfer_apply_rgb(kDegree, kVertices, records_of, batch::shared(samples.data()), batch::blocked(out.get()));
  };
  const std::vector<double> t = least_times({[&] { apply(records(visibility)); }, [&] { apply(records(halves)); },
                                             [&] { multiply(matrices.get(), lights.data(), out.get()); },
                                             [&] { multiply(half_matrices.get(), lights.data(), out.get()); }},
                                            kPasses);
  const double ns = 1e9 / kVertices;
  table.ratio("visibility in half, 162 bytes", "ns", t[1] * ns, t[2] * ns, "matrices in float, 2,500 bytes", 0.5);
  table.ratio("visibility in half, 162 bytes", "ns", t[1] * ns, t[3] * ns, "matrices in half, 1,250 bytes", 1.0);
  table.ratio("visibility in float, 324 bytes", "ns", t[0] * ns, t[2] * ns, "matrices in float", 0.5);
}

}  // namespace sh::bench
