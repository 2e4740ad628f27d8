// Transferred radiance of many vertices under one light, from 81 numbers of visibility a vertex, and what glossy vertices
// reflect of it, against 25x25 transfer matrices times the light [Sloan, Kautz and Snyder, 2002, section 4]. The matrices
// lie in blocks of 16 vertices, so that each is read once, in order, and serves three channels. More vertices than fit
// into the caches.
#if defined(__F16C__) || defined(__AVX512F__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <string>
#include <thread>
#include <vector>

#include "generated/batch/batch.hpp"
#include "generated/cpp/transfer_prepare.hpp"
#include "generated/cpp/zonal.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

constexpr int kDegree = 4;
constexpr int kChannels = 3;
constexpr std::size_t kVertices = 131072;
constexpr std::size_t kSize = coefficient_count(kDegree);
constexpr std::size_t kVisibility = coefficient_count(2 * kDegree);
constexpr std::size_t kLanes = 16;
constexpr int kPasses = 15;

using Vector = Sixteen::Vector;
using Half = batch::Half;

inline Vector load(const float* from) { return *reinterpret_cast<const Vector*>(from); }

inline Vector load(const Half* from) {
#if defined(__AVX512F__)
  return reinterpret_cast<Vector>(
      _mm512_maskz_cvtph_ps(0xffff, _mm256_load_si256(reinterpret_cast<const __m256i*>(from))));
#elif defined(__F16C__)
  Vector wide;
  auto* to = reinterpret_cast<float*>(&wide);
  for (std::size_t i = 0; i < kLanes; i += 8) {
    _mm256_store_ps(to + i, _mm256_cvtph_ps(_mm_load_si128(reinterpret_cast<const __m128i*>(from + i))));
  }
  return wide;
#else
  Vector wide;  // no such conversion here: a cheaper one in its place
  for (std::size_t i = 0; i < kLanes; ++i) wide[i] = static_cast<float>(static_cast<std::uint16_t>(from[i]));
  return wide;
#endif
}

using Colors = std::array<Vector, kChannels>;

// A row of 16 matrices times the light; goes to the next row.
template <class T>
inline Colors times_row(const T*& matrices, const float* light) {
  Colors sums{};
  for (std::size_t i = 0; i < kSize; ++i) {
    const Vector entry = load(matrices);
    __builtin_prefetch(matrices + 4096 / sizeof(T));
    matrices += kLanes;
    for (int channel = 0; channel < kChannels; ++channel) sums[channel] += entry * light[channel * kSize + i];
  }
  return sums;
}

// out = matrices of `vertices` vertices times light, in blocks.
template <class T>
void multiply(const T* matrices, const float* light, std::size_t vertices, float* out) {
  for (std::size_t block = 0; block < vertices / kLanes; ++block) {
    for (std::size_t row = 0; row < kSize; ++row) {
      const Colors sums = times_row(matrices, light);
      for (int channel = 0; channel < kChannels; ++channel) {
        *reinterpret_cast<Vector*>(out + (channel * kSize + row) * kLanes) = sums[channel];
      }
    }
    out += kChannels * kSize * kLanes;
  }
}

// rgb = matrices times light, convolved with the lobe, in the direction of each vertex.
template <class T>
void reflect(const T* matrices, const float* light, const float* lobe, const float* directions, float* rgb) {
  std::array<Sixteen, kDegree + 1> lobes;
  for (std::size_t l = 0; l < lobes.size(); ++l) lobes[l] = Sixteen(lobe[l]);
  for (std::size_t block = 0; block < kVertices / kLanes; ++block) {
    std::array<Sixteen, 3> d;
    for (std::size_t k = 0; k < d.size(); ++k) d[k] = Sixteen(load(directions + k * kLanes));
    std::array<Sixteen, kSize> weights;
    sh::zonal<kDegree>(lobes.data(), d[0], d[1], d[2], weights.data());
    Colors total{};
    for (const Sixteen& weight : weights) {
      const Colors sums = times_row(matrices, light);
      for (int channel = 0; channel < kChannels; ++channel) total[channel] += weight.vector() * sums[channel];
    }
    for (int channel = 0; channel < kChannels; ++channel) {
      *reinterpret_cast<Vector*>(rgb + channel * kLanes) = total[channel];
    }
    directions += d.size() * kLanes;
    rgb += kChannels * kLanes;
  }
}

template <class T>
batch::Records<const T> records(const Buffer<T>& blocks) {
  return {blocks.get(), batch::Layout::kBlocked};
}

// work(first vertex, vertices) for a part of them on each core.
template <class Work>
void on_all_cores(const Work& work) {
  const std::size_t blocks = kVertices / kLanes;
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (std::size_t core = 0; core < cores; ++core) {
    const std::size_t first = blocks * core / cores * kLanes;
    threads.emplace_back(work, first, blocks * (core + 1) / cores * kLanes - first);
  }
  for (std::thread& thread : threads) thread.join();
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
  const std::vector<float> lobe{0.9F, 0.7F, 0.5F, 0.3F, 0.1F};
  const Buffer<float> directions = to_blocks(random_directions(kVertices), 3);
  const auto apply = [&](auto visibilities) {
    batch::transfer_apply_rgb(kDegree, kVertices, visibilities, samples.data(), batch::blocked(out.get()));
  };
  const auto glossy = [&](auto visibilities) {
    batch::transfer_glossy_rgb(kDegree, kVertices, visibilities, samples.data(), batch::shared(lobe.data()),
                               batch::Records<const float>{directions.get(), batch::Layout::kBlocked},
                               batch::blocked(out.get()));
  };
  const auto dense = [&](const auto* of) { multiply(of, lights.data(), kVertices, out.get()); };
  const auto reflected = [&](const auto* of) { reflect(of, lights.data(), lobe.data(), directions.get(), out.get()); };
  const std::vector<double> t = least_times(
      {[&] { apply(records(visibility)); }, [&] { apply(records(halves)); }, [&] { dense(matrices.get()); },
       [&] { dense(half_matrices.get()); }, [&] { glossy(records(visibility)); }, [&] { glossy(records(halves)); },
       [&] { reflected(matrices.get()); }, [&] { reflected(half_matrices.get()); }},
      kPasses);
  const double ns = 1e9 / kVertices;
  const auto rows = [&](std::size_t ours, std::size_t control) {
    table.ratio("visibility in half, 162 bytes", "ns", t[ours + 1] * ns, t[control] * ns,
                "matrices in float, 2,500 bytes", 0.5);
    table.ratio("visibility in half, 162 bytes", "ns", t[ours + 1] * ns, t[control + 1] * ns,
                "matrices in half, 1,250 bytes", 1.0);
    table.ratio("visibility in float, 324 bytes", "ns", t[ours] * ns, t[control] * ns, "matrices in float", 0.5);
  };
  rows(0, 2);
  table.section("The same, convolved with a lobe and evaluated at a direction a vertex: 12 bytes instead of 300");
  rows(4, 6);
  const std::vector<double> on_all =
      least_times({[&] {
                     on_all_cores([&](std::size_t first, std::size_t vertices) {
                       batch::transfer_apply_rgb(
                           kDegree, vertices,
                           batch::Records<const Half>{halves.get() + first * kVisibility, batch::Layout::kBlocked},
                           samples.data(), batch::blocked(out.get() + first * kChannels * kSize));
                     });
                   },
                   [&] {
                     on_all_cores([&](std::size_t first, std::size_t vertices) {
                       multiply(half_matrices.get() + first * kSize * kSize, lights.data(), vertices,
                                out.get() + first * kChannels * kSize);
                     });
                   }},
                  kPasses);
  table.section("Transferred radiance again, with as many threads as there are cores: " +
                std::to_string(std::thread::hardware_concurrency()));
  table.ratio("visibility in half, 162 bytes", "ns", on_all[0] * ns, on_all[1] * ns, "matrices in half, 1,250 bytes",
              0.6);
}

}  // namespace sh::bench
