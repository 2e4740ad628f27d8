#include "prt/runtime/relight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "generated/batch/batch.hpp"
#include "prt/chunks.hpp"
#include "prt/large_pages.hpp"
#include "prt/runtime/lit_clusters.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace sh::prt {

namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "colors are read and written as plain floats");

constexpr std::size_t kChannels = 3;
constexpr std::size_t kVerticesAtOnce = 2048;  // whole blocks

void require_diffuse(const Transfer& transfer) {
  if (transfer.kind->is_glossy()) {
    throw std::invalid_argument(
        fmt::format("{}: glossy transfer ({}) shows other light in every direction; expected diffuse transfer",
                    transfer.scene, transfer.kind->letters));
  }
  if (transfer.shape.rows() > 1) {
    throw std::invalid_argument(fmt::format(
        "{}: its medium shows other light in every direction; expected one with an isotropic phase function",
        transfer.scene));
  }
}

void require_no_albedo(const Transfer& transfer) {
  if (transfer.shape.holds_albedo) {
    throw std::invalid_argument(
        "transfer with bounces or light through bodies holds its albedo and cannot be recolored; other kinds can");
  }
}

void require_count(std::size_t count, const Transfer& transfer, const char* what) {
  if (count != transfer.receivers()) {
    throw std::invalid_argument(
        fmt::format("{} {} for {} vertices: expected one for each vertex", count, what, transfer.receivers()));
  }
}

/// The light of a call, in single precision and in the degree of the transfer, channel by channel.
struct PreparedLight {
  PreparedLight(const Transfer& transfer, const LightCoefficients& light);
  std::vector<float> complete;  // (3, bands^2)
  /// What meets the columns that are stored: (3, columns of a row), for one row or for one row a channel.
  std::size_t rows = 1;
  std::vector<float> stored;
};

PreparedLight::PreparedLight(const Transfer& transfer, const LightCoefficients& light)
    : complete(in_single(light, transfer.degree())) {
  if (!transfer.stored.in_blocks) return;
  const TransferShape& shape = transfer.shape;
  const std::vector<std::size_t> places = stored_columns(shape);
  rows = shape.storage.one_channel ? 1 : shape.channels;
  const std::size_t columns = places.size() / rows;  // the places of the first channel come first
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    for (std::size_t k = 0; k < columns; ++k) stored.push_back(complete[channel * shape.count() + places[k]]);
  }
}

/// The sums of `count` complete rows of a transfer of this shape, three a row.
void sums_of(const TransferShape& shape, const float* rows, std::size_t count, const PreparedLight& light, float* out) {
  if (shape.channels == 3) {
    batch::relight_colored(shape.degree, count, batch::plain(rows), light.complete.data(), batch::plain(out));
  } else {
    batch::relight_rgb(shape.degree, count, batch::plain(rows), light.complete.data(), batch::plain(out));
  }
}

template <class Stored>
void relight_blocks(const std::byte* data, const Rows& rows, std::size_t blocks, const PreparedLight& light,
                    const float* factors, float* out, bool past_caches) {
  const auto* numbers = reinterpret_cast<const Stored*>(data);
  const std::size_t columns = light.stored.size() / kChannels;
  batch::relight_stored({numbers, rows.scale().data(), light.rows, columns}, blocks, light.stored.data(), factors, out,
                        past_caches);
}

/// What rows in whole blocks, of those from `first` on, send out, times factors, which may be null: how many there are of
/// `count`. `first` begins a block.
std::size_t relight_blocks(Element element, const Rows& rows, std::size_t first, std::size_t count,
                           const PreparedLight& light, const float* factors, float* out, bool past_caches) {
  if (first >= rows.in_blocks()) return 0;
  const std::size_t some = std::min(count, rows.in_blocks() - first);
  const auto relight = element == Element::kByte   ? relight_blocks<std::int8_t>
                       : element == Element::kHalf ? relight_blocks<batch::Half>
                                                   : relight_blocks<float>;
  relight(rows.block(first), rows, some / kReceiversOfBlock, light, factors, out, past_caches);
  return some;
}

/// The same for rows `first` and on, as they are stored; `first` begins a block.
void sums_of(const TransferShape& shape, const Rows& rows, std::size_t first, std::size_t count,
             const PreparedLight& light, float* out) {
  const std::size_t done = relight_blocks(shape.storage.element, rows, first, count, light, nullptr, out, false);
  rows.each(first + done, count - done, [&](std::size_t v, std::size_t some, const float* numbers) {
    sums_of(shape, numbers, some, light, out + kChannels * (v - first));
  });
}

/// Calls work(first vertex, vertices) for every kVerticesAtOnce vertices, in parallel.
template <class Work>
void for_ranges(const Transfer& transfer, const Work& work) {
  const std::size_t vertices = transfer.receivers();
  in_parallel(std::size_t{0}, (vertices + kVerticesAtOnce - 1) / kVerticesAtOnce, [&](std::size_t range) {
    const std::size_t first = range * kVerticesAtOnce;
    work(first, std::min(kVerticesAtOnce, vertices - first));
  });
}

/// Calls give(vertex, sums) with the sums of every vertex, (3), of transfer whose rows are clustered, in parallel.
template <class Give>
void for_clustered(const Transfer& transfer, const PreparedLight& light, const Give& give) {
  const Clusters& clusters = transfer.clusters;
  std::vector<float> lit(clusters.basis.size() / clusters.length * 3);
  sums_of(transfer.shape, clusters.basis.data(), lit.size() / 3, light, lit.data());
  const LitClusters products(clusters, lit);
  for_vertices(clusters.receivers(), [&](std::size_t v) {
    Eigen::Vector3f sums = Eigen::Vector3f::Zero();
    products.add_to(v, sums.data());
    give(v, sums);
  });
}

/// Bytes of rows that outgrow the caches: radiance that is written beside them would not stay there either.
constexpr std::size_t kCachedBytes = 32U << 20U;

/// out = values times factors (values alone if that is null), past the caches where that is possible, so that no line of
/// `out` is read first.
void write_past_caches(const float* values, const float* factors, std::size_t count, float* out) {
  const auto value = [=](std::size_t i) { return factors == nullptr ? values[i] : values[i] * factors[i]; };
  std::size_t i = 0;
#if defined(__SSE2__)
  constexpr std::size_t kFour = sizeof(__m128) / sizeof(float);
  for (; i < count && reinterpret_cast<std::uintptr_t>(out + i) % sizeof(__m128) != 0; ++i) out[i] = value(i);
  for (; i + kFour <= count; i += kFour) {
    __m128 four = _mm_loadu_ps(values + i);
    if (factors != nullptr) {
      __builtin_prefetch(factors + i + 3 * kVerticesAtOnce, 0, 2);  // those of the next range
      four = _mm_mul_ps(four, _mm_loadu_ps(factors + i));
    }
    _mm_stream_ps(out + i, four);
  }
  _mm_sfence();
#endif
  for (; i < count; ++i) out[i] = value(i);
}

void add_emitted(const Transfer& transfer, std::size_t first, std::size_t count, Eigen::Vector3f* radiance) {
  for (std::size_t v = 0; !transfer.emitted.empty() && v < count; ++v) radiance[v] += transfer.emitted[first + v];
}

/// The sums of `count` vertices from `first` on, times their colors if the rows hold no albedo, with the emitted light;
/// colors, one a vertex from `first` on.
void finish(const Transfer& transfer, std::size_t first, std::size_t count, const Eigen::Vector3f* colors,
            Eigen::Vector3f* radiance) {
  const auto values = static_cast<Eigen::Index>(kChannels * count);
  if (!transfer.shape.holds_albedo) {
    Eigen::Map<Eigen::ArrayXf>(radiance->data(), values) *= Eigen::Map<const Eigen::ArrayXf>(colors->data(), values);
  }
  add_emitted(transfer, first, count, radiance);
}

/// `colors` serve transfer without the albedo.
void relight_with(const Transfer& transfer, const LightCoefficients& light, std::span<const Eigen::Vector3f> colors,
                  std::span<Eigen::Vector3f> radiance) {
  require_diffuse(transfer);
  require_light(transfer, light);
  if (!transfer.shape.holds_albedo) require_count(colors.size(), transfer, "colors");
  require_count(radiance.size(), transfer, "radiances");
  const PreparedLight values(transfer, light);
  if (!transfer.clusters.empty()) {
    return for_clustered(transfer, values, [&](std::size_t v, const Eigen::Vector3f& sums) {
      radiance[v] = sums;
      finish(transfer, v, 1, colors.data() + v, &radiance[v]);
    });
  }
  const Rows rows = transfer.rows();
  const bool past_caches = rows.bytes() > kCachedBytes && transfer.emitted.empty();
  const auto factors = [&](std::size_t first) { return transfer.shape.holds_albedo ? nullptr : colors[first].data(); };
  for_ranges(transfer, [&](std::size_t first, std::size_t count) {
    const std::size_t in_blocks = relight_blocks(transfer.shape.storage.element, rows, first, count, values,
                                                 factors(first), radiance[first].data(), past_caches);
    add_emitted(transfer, first, in_blocks, &radiance[first]);
    if (in_blocks == count) return;
    first += in_blocks;
    count -= in_blocks;
    if (past_caches) {
      std::array<float, kChannels * kVerticesAtOnce> sums;
      sums_of(transfer.shape, rows, first, count, values, sums.data());
      return write_past_caches(sums.data(), factors(first), kChannels * count, radiance[first].data());
    }
    sums_of(transfer.shape, rows, first, count, values, radiance[first].data());
    finish(transfer, first, count, colors.data() + first, &radiance[first]);
  });
}

}  // namespace

void require_light(const Transfer& transfer, const LightCoefficients& light) {
  if (light.degree > transfer.degree()) {
    throw std::invalid_argument(fmt::format("the light has degree {}, the transfer {}; the light's must not be higher",
                                            light.degree, transfer.degree()));
  }
  require_kept(transfer, light);
}

void require_kept(const Transfer& transfer, const LightCoefficients& light) {
  constexpr double kRounding = 1e-6;
  const std::vector<std::uint32_t>& kept = transfer.shape.storage.kept;
  if (kept.empty() || light.values.empty() || transfer.shape.meets != Meets::kDot) return;
  const auto louder = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double largest = std::abs(*std::max_element(light.values.begin(), light.values.end(), louder));
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i % light.bands_squared());
    if (std::abs(light.values[i]) > kRounding * largest && !std::binary_search(kept.begin(), kept.end(), index)) {
      throw std::invalid_argument(fmt::format(
          "the transfer keeps {} of {} coefficients, those of its plan's lights (turned: {}); this light also has "
          "number {}: bake with --without symmetry",
          kept.size(), light.bands_squared(), transfer.plan.light_turns.empty() ? "any" : transfer.plan.light_turns,
          index));
    }
  }
}

void relight_into(const Transfer& transfer, const LightCoefficients& light, std::span<Eigen::Vector3f> radiance) {
  relight_with(transfer, light, transfer.mesh.albedo, radiance);
}

std::vector<Eigen::Vector3f> relight(const Transfer& transfer, const LightCoefficients& light) {
  std::vector<Eigen::Vector3f> radiance;
  renew_on_large_pages(radiance, transfer.receivers());
  relight_into(transfer, light, radiance);
  return radiance;
}

std::vector<Eigen::Vector3f> recolored(const Transfer& transfer, const LightCoefficients& light,
                                       std::span<const Eigen::Vector3f> colors) {
  require_no_albedo(transfer);
  std::vector<Eigen::Vector3f> radiance(transfer.receivers());
  relight_with(transfer, light, colors, radiance);
  return radiance;
}

Eigen::Vector3f relight_vertex(const Transfer& transfer, std::size_t vertex, const LightCoefficients& light,
                               const Eigen::Vector3f& color) {
  require_diffuse(transfer);
  require_light(transfer, light);
  require_no_albedo(transfer);
  std::vector<float> room;
  Eigen::Vector3f radiance;
  sums_of(transfer.shape, transfer.row(vertex, room), 1, PreparedLight(transfer, light), radiance.data());
  finish(transfer, vertex, 1, &color, &radiance);
  return radiance;
}

std::vector<float> relight_gray(const Transfer& transfer, const LightCoefficients& light) {
  require_diffuse(transfer);
  require_light(transfer, light);
  require_no_albedo(transfer);
  const PreparedLight values(transfer, light);
  std::vector<float> radiance(transfer.receivers());
  if (!transfer.clusters.empty()) {
    for_clustered(transfer, values, [&](std::size_t v, const Eigen::Vector3f& sums) { radiance[v] = sums[0]; });
    return radiance;
  }
  const Rows rows = transfer.rows();
  for_ranges(transfer, [&](std::size_t first, std::size_t count) {
    std::array<float, kChannels * kVerticesAtOnce> sums;
    sums_of(transfer.shape, rows, first, count, values, sums.data());
    for (std::size_t v = 0; v < count; ++v) radiance[first + v] = sums[kChannels * v];
  });
  return radiance;
}

LightCoefficients white(const LightCoefficients& light) {
  LightCoefficients out = light;
  out.matrix().colwise() = light.matrix() * Eigen::Vector3d(0.2126, 0.7152, 0.0722);
  return out;
}

}  // namespace sh::prt
