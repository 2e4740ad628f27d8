#include "prt/runtime/relight.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "prt/chunks.hpp"
#include "prt/runtime/lit_clusters.hpp"
#include "prt/runtime/row_products.hpp"

namespace sh::prt {

namespace baseline {
extern const RowProductsOn kRowProducts;
}  // namespace baseline
#if defined(SH_RELIGHT_X86)
namespace avx2 {
extern const RowProductsOn kRowProducts;
}  // namespace avx2
namespace avx512 {
extern const RowProductsOn kRowProducts;
}  // namespace avx512
#endif

namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "colors are read and written as plain floats");

constexpr std::size_t kVerticesAtOnce = 2048;

void require_diffuse(const Transfer& transfer) {
  if (transfer.kind->is_glossy()) {
    throw std::invalid_argument(
        fmt::format("{}: glossy transfer ({}) shows other light in every direction; expected diffuse transfer",
                    transfer.scene, transfer.kind->letters));
  }
}

void require_no_albedo(const Transfer& transfer) {
  if (transfer.shape.holds_albedo) {
    throw std::invalid_argument(
        "transfer with bounces holds its albedo and cannot be recolored; unshadowed or shadowed transfer can");
  }
}

void require_count(std::size_t count, const Transfer& transfer, const char* what) {
  if (count != transfer.mesh.positions.size()) {
    throw std::invalid_argument(fmt::format("{} {} for {} vertices: expected one for each vertex", count, what,
                                            transfer.mesh.positions.size()));
  }
}

/// The light in single precision, in the layout of the inner loop.
std::vector<float> in_float(const LightCoefficients& light) { return {light.values.begin(), light.values.end()}; }

RowProducts row_products(const Transfer& transfer, const std::vector<float>& light) {
  const std::size_t n = light.size() / 3;
  RowProducts rows;
  rows.stride = transfer.shape.length();
  rows.transfer_step = transfer.shape.channels == 3 ? transfer.shape.count() : 0;
  rows.light = light.data();
  const bool is_white = std::equal(light.begin() + n, light.end(), light.begin());  // the three channels are equal
  rows.light_step = is_white ? 0 : n;
  rows.coefficients = n;
  rows.sums = rows.transfer_step == 0 && rows.light_step == 0 ? 1 : 3;
  return rows;
}

/// Calls work(rows of the range, first vertex, vertices) for ranges of vertices, in parallel.
template <class Work>
void for_ranges(const Transfer& transfer, const RowProducts& rows, const Work& work) {
  const tbb::blocked_range<std::size_t> all(0, transfer.mesh.positions.size(), kVerticesAtOnce);
  in_parallel(all, [&](const auto& range) {
    RowProducts part = rows;
    part.transfer = transfer.row(range.begin());
    work(part, range.begin(), range.size());
  });
}

/// Calls give(vertex, sum) with the sums of every vertex, (3), of transfer whose rows are clustered, in parallel.
template <class Give>
void for_clustered(const Transfer& transfer, RowProducts rows, const Give& give) {
  const Clusters& clusters = transfer.clusters;
  rows.transfer = clusters.basis.data();
  std::vector<float> lit(clusters.basis.size() / clusters.length * 3);
  row_products_here().back().color(rows, lit.size() / 3, nullptr, lit.data());
  const LitClusters products(clusters, lit);
  for_vertices(clusters.receivers(), [&](std::size_t v) {
    Eigen::Vector3f sums = Eigen::Vector3f::Zero();
    products.add_to(v, sums.data());
    give(v, sums);
  });
}

/// `colours` serve transfer without the albedo.
void relight_with(const Transfer& transfer, const LightCoefficients& light, std::span<const Eigen::Vector3f> colors,
                  std::span<Eigen::Vector3f> radiance) {
  require_diffuse(transfer);
  require_light(transfer, light);
  require_count(colors.size(), transfer, "colors");
  require_count(radiance.size(), transfer, "radiances");
  const std::vector<float> values = in_float(light);
  if (!transfer.clusters.empty()) {
    for_clustered(transfer, row_products(transfer, values), [&](std::size_t v, const Eigen::Vector3f& sums) {
      radiance[v] = transfer.shape.holds_albedo ? sums : Eigen::Vector3f(sums.cwiseProduct(colors[v]));
      if (!transfer.emitted.empty()) radiance[v] += transfer.emitted[v];
    });
    return;
  }
  for_ranges(transfer, row_products(transfer, values), [&](const RowProducts& rows, std::size_t first, std::size_t n) {
    row_products_here().back().color(rows, n, transfer.shape.holds_albedo ? nullptr : colors[first].data(),
                                     radiance[first].data());
    for (std::size_t v = first; !transfer.emitted.empty() && v < first + n; ++v) radiance[v] += transfer.emitted[v];
  });
}

}  // namespace

std::span<const RowProductsOn> row_products_here() {
  static const std::vector<RowProductsOn> kHere = [] {
    std::vector<RowProductsOn> here{baseline::kRowProducts};
#if defined(SH_RELIGHT_X86)
    if (__builtin_cpu_supports("avx2")) here.push_back(avx2::kRowProducts);
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl")) {
      here.push_back(avx512::kRowProducts);
    }
#endif
    return here;
  }();
  return kHere;
}

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
  if (kept.empty() || light.values.empty()) return;
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
  std::vector<Eigen::Vector3f> radiance(transfer.mesh.positions.size());
  relight_into(transfer, light, radiance);
  return radiance;
}

std::vector<Eigen::Vector3f> recolored(const Transfer& transfer, const LightCoefficients& light,
                                       std::span<const Eigen::Vector3f> colors) {
  require_no_albedo(transfer);
  std::vector<Eigen::Vector3f> radiance(transfer.mesh.positions.size());
  relight_with(transfer, light, colors, radiance);
  return radiance;
}

Eigen::Vector3f relight_vertex(const Transfer& transfer, std::size_t vertex, const LightCoefficients& light,
                               const Eigen::Vector3f& color) {
  require_diffuse(transfer);
  require_light(transfer, light);
  require_no_albedo(transfer);
  const std::vector<float> values = in_float(light);
  RowProducts rows = row_products(transfer, values);
  std::vector<float> room;
  rows.transfer = transfer.row(vertex, room);
  Eigen::Vector3f radiance;
  row_products_here().back().color(rows, 1, color.data(), radiance.data());
  return transfer.emitted.empty() ? radiance : Eigen::Vector3f(radiance + transfer.emitted[vertex]);
}

std::vector<float> relight_gray(const Transfer& transfer, const LightCoefficients& light) {
  require_diffuse(transfer);
  require_light(transfer, light);
  require_no_albedo(transfer);
  const std::vector<float> values = in_float(light);
  RowProducts all = row_products(transfer, values);
  all.light_step = 0;
  all.sums = 1;
  std::vector<float> radiance(transfer.mesh.positions.size());
  if (!transfer.clusters.empty()) {
    for_clustered(transfer, all, [&](std::size_t v, const Eigen::Vector3f& sums) { radiance[v] = sums[0]; });
    return radiance;
  }
  for_ranges(transfer, all, [&](const RowProducts& rows, std::size_t first, std::size_t n) {
    row_products_here().back().gray(rows, n, &radiance[first]);
  });
  return radiance;
}

LightCoefficients white(const LightCoefficients& light) {
  LightCoefficients out = light;
  for (std::size_t i = 0; i < light.bands_squared(); ++i) {
    const double luminance = 0.2126 * light.at(0, i) + 0.7152 * light.at(1, i) + 0.0722 * light.at(2, i);
    for (std::size_t c = 0; c < 3; ++c) out.at(c, i) = luminance;
  }
  return out;
}

}  // namespace sh::prt
