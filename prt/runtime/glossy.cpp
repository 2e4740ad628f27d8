#include "prt/runtime/glossy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "generated/batch/batch.hpp"
#include "generated/cpp/relight_rgb.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/large_pages.hpp"
#include "prt/material/lobe.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/runtime/lit_clusters.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/shading_normals.hpp"
#include "prt/transfer/visibility.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;
constexpr std::size_t kMostCoefficients = coefficient_count(kMaxDegree);
constexpr double kStrongest = 1e36;
constexpr float kPartOfSphere = 0.28209479F;  // of a function that is 1: its coefficient is sqrt(4 pi)

// reaching (count, 3, `bands`) += matrices (count, channels, rows, columns) times the light (3, columns), in the lower
// bands. Every row meets every channel of the light, which is faster than to leave some out.
void add_products(const TransferShape& shape, std::size_t count, const float* matrices, const float* light,
                  std::size_t bands, float* reaching) {
  const std::size_t rows = shape.rows();
  std::vector<float> sums(count * shape.channels * rows * kChannels);
  batch::relight_rgb(shape.degree, sums.size() / kChannels, batch::plain(matrices), light, batch::plain(sums.data()));
  using Sums = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, kChannels, Eigen::RowMajor>>;
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t first = (v * shape.channels + c % shape.channels) * rows;
      as_array(reaching + (v * kChannels + c) * bands, rows) +=
          Sums(&sums[first * kChannels], Eigen::Index(rows), kChannels).col(Eigen::Index(c)).array();
    }
  }
}

// The same for all matrices, in parallel.
void add_indirect(const TransferShape& shape, const Rows& matrices, const float* light, std::size_t bands,
                  float* reaching) {
  for_chunks(matrices.count(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, matrices.count());
    matrices.each(range.first, range.size(), [&](std::size_t first, std::size_t count, const float* some) {
      add_products(shape, count, some, light, bands, reaching + first * kChannels * bands);
    });
  });
}

// values (vertices, 3, bands^2) += what the rows give, in the lower bands; lit (rows of clusters, 3, `given`) are rows
// under the light.
void add_clusters(const Clusters& clusters, const std::vector<float>& lit, std::size_t given,
                  std::vector<float>& values) {
  const LitClusters rows(clusters, lit);
  const std::size_t bands = values.size() / clusters.receivers() / kChannels;
  for_vertices(clusters.receivers(), [&](std::size_t v) {
    std::array<float, kChannels * kMostCoefficients> sums;
    std::fill_n(sums.begin(), kChannels * given, 0.0F);
    rows.add_to(v, sums.data());
    for (std::size_t c = 0; c < kChannels; ++c) {
      as_array(values.data() + (v * kChannels + c) * bands, given) += as_array(sums.data() + c * given, given);
    }
  });
}

// values (points, 3, bands^2) of the degree of the result or of the light, whichever is higher.
void meet_points(const Transfer& volume, const LightCoefficients& light, std::vector<float>& values) {
  const TransferShape& shape = volume.shape;
  const Rows rows = volume.rows();
  const std::size_t points = rows.count();
  const int degree = std::max(shape.result_degree, light.degree);
  const std::size_t result = coefficient_count(shape.result_degree);
  const std::size_t bands = coefficient_count(degree);
  const std::vector<float> low = in_single(first_bands(light, std::min(light.degree, shape.degree)), shape.degree);
  values.resize(points * kChannels * bands);
  if (light.degree <= shape.degree && bands == result) {
    return transfer_light(shape, rows, low, values.data());
  }
  std::vector<float> met(points * kChannels * result);
  transfer_light(shape, rows, low, met.data());
  const std::vector<float> all = in_single(light, degree);
  const std::size_t first = std::min(coefficient_count(shape.degree), bands);  // of the bands that are not met
  for_vertices(points, [&](std::size_t p) {
    std::vector<float> room;
    const float seen = rows.some(p, 1, room)[0] * kPartOfSphere;
    for (std::size_t c = 0; c < kChannels; ++c) {
      float* own = &values[(p * kChannels + c) * bands];
      std::fill(std::copy_n(&met[(p * kChannels + c) * result], result, own), own + bands, 0.0F);
      as_array(own + first, bands - first) += seen * as_array(&all[c * bands + first], bands - first);
    }
  });
}

// values (points, 3, bands) += what the object sends.
void add_sent(const Transfer& volume, const LightCoefficients& light, std::size_t bands, std::vector<float>& values) {
  const TransferShape& shape = volume.indirect_shape;
  const std::vector<float> low = in_single(first_bands(light, std::min(light.degree, shape.degree)), shape.degree);
  add_indirect(shape, volume.matrices(), low.data(), bands, values.data());
}

// Throws unless all numbers pass the test.
template <class Numbers, class Test>
void require_single(const Transfer& transfer, const Numbers& numbers, const Test& test) {
  if (std::all_of(numbers.begin(), numbers.end(), test)) return;
  throw std::runtime_error(fmt::format(
      "{}: the radiance that reaches it exceeds single precision; expected weaker lights, below 1e37", transfer.scene));
}

Eigen::Vector3f summed(int degree, const float* lobe, const float* reaching) {
  Eigen::Vector3f sums;
  at_degree(degree, [&](auto known) { sh::relight_rgb<known()>(lobe, reaching, sums.data()); });
  return sums;
}

}  // namespace

TransferredRadiance TransferredRadiance::sent(const Transfer& volume, const LightCoefficients& light) {
  TransferredRadiance radiance;
  radiance.degree_ = volume.shape.result_degree;
  const std::size_t bands = coefficient_count(radiance.degree_);
  radiance.stride_ = kChannels * bands;
  radiance.values_.assign(volume.receivers() * radiance.stride_, 0.0F);
  add_sent(volume, light, bands, radiance.values_);
  return radiance;
}

TransferredRadiance TransferredRadiance::at_vertices(
    const Transfer& transfer, const std::function<LightCoefficients(std::size_t vertex)>& light) {
  if (!transfer.kind->is_glossy() || transfer.kind->has_bounces() || transfer.grid) {
    throw std::invalid_argument(fmt::format("transfer of kind {} under a light at each vertex; expected {} or {}",
                                            transfer.kind->letters, kGlossyUnshadowed.letters,
                                            kGlossyShadowed.letters));
  }
  TransferredRadiance radiance;
  const int degree = transfer.degree();
  radiance.degree_ = degree;
  radiance.stride_ = kChannels * coefficient_count(degree);
  radiance.values_.resize(transfer.mesh.positions.size() * radiance.stride_);
  for_vertices(transfer.mesh.positions.size(), [&](std::size_t v) {
    const LightCoefficients own = light(v);
    require_light(transfer, own);
    const std::vector<float> wide = in_single(own, degree);
    float* const out = radiance.values_.data() + v * radiance.stride_;
    if (transfer.shape.meets == Meets::kNothing) {
      std::copy(wide.begin(), wide.end(), out);
      return;
    }
    std::vector<float> room;
    const std::vector<float> samples = prepared_light(degree, wide.data());
    batch::transfer_apply_rgb(degree, 1, batch::plain(transfer.row(v, room)), samples.data(), batch::plain(out));
  });
  require_single(transfer, radiance.values_, [](float value) { return std::isfinite(value); });
  return radiance;
}

void TransferredRadiance::meet(const Transfer& transfer, const LightCoefficients& light) {
  degree_ = transfer.degree();
  stride_ = 0;
  if (!transfer.kind->is_glossy()) {
    throw std::invalid_argument(
        fmt::format("transfer of kind {} is exit radiance; expected a glossy kind", transfer.kind->letters));
  }
  if (transfer.grid) {
    degree_ = std::max(transfer.shape.result_degree, light.degree);
    // No visibility exceeds 4, so that the product is then within single precision.
    require_single(transfer, light.values, [](double value) { return std::abs(value) <= kStrongest; });
    meet_points(transfer, light, values_);
    stride_ = kChannels * coefficient_count(degree_);
    if (transfer.kind->stores_matrices()) {
      add_sent(transfer, light, coefficient_count(degree_), values_);
      require_single(transfer, values_, [](float value) { return std::isfinite(value); });
    }
    return;
  }
  require_light(transfer, light);
  const std::vector<float> wide = in_single(light, degree_);
  values_ = wide;
  if (transfer.shape.meets == Meets::kNothing) return;
  const std::size_t vertices = transfer.mesh.positions.size();
  const std::size_t bands = coefficient_count(degree_);
  stride_ = wide.size();
  const auto seen = [&](const Rows& visibility) {
    std::vector<float> out;
    renew_on_large_pages(out, visibility.count() * stride_);
    times_visibility(degree_, visibility, prepared_light(degree_, wide.data()), out.data());
    return out;
  };
  if (transfer.clusters.empty()) {
    values_ = seen(transfer.rows());
  } else {
    values_.assign(vertices * stride_, 0.0F);
    add_clusters(transfer.clusters, seen({transfer.clusters.basis, {}, transfer.shape}), bands, values_);
  }
  const TransferShape& shape = transfer.indirect_shape;
  const std::vector<float> low = in_single(first_bands(light, std::min(light.degree, shape.degree)), shape.degree);
  add_indirect(shape, transfer.matrices(), low.data(), bands, values_.data());
  if (!transfer.indirect_clusters.empty()) {
    const Rows rows(transfer.indirect_clusters.basis, {}, shape);
    std::vector<float> lit(rows.count() * kChannels * shape.rows(), 0.0F);
    add_indirect(shape, rows, low.data(), shape.rows(), lit.data());
    add_clusters(transfer.indirect_clusters, lit, shape.rows(), values_);
  }
  require_single(transfer, values_, [](float value) { return std::isfinite(value); });
}

void TransferredRadiance::at(const ReceiversAt& place, float* out) const {
  const std::size_t count = kChannels * coefficient_count(degree_);
  const auto of = [&](std::size_t k) { return place.part[k] * as_array(at(place.receiver[k]), count); };
  as_array(out, count) = of(0) + of(1) + of(2);
  if (place.count > 3) as_array(out, count) += of(3);
}

Material material_of(const Mesh& mesh, std::size_t vertex, const Eigen::Vector3f& albedo) {
  Material material{.albedo = albedo, .brdf = mesh.brdf_of(vertex)};
  if (!mesh.specular.empty()) {
    material.specular = mesh.specular[vertex];
    material.exponent = mesh.exponent[vertex];
  }
  return material;
}

bool has_one_finish(const Mesh& mesh, const Face& face) {
  const auto is_one = [&face](const auto& of) {
    return of.empty() || (of[face[0]] == of[face[1]] && of[face[0]] == of[face[2]]);
  };
  return is_one(mesh.brdf) && is_one(mesh.specular) && is_one(mesh.exponent);
}

bool has_one_finish(const Mesh& mesh) {
  return std::all_of(mesh.faces.begin(), mesh.faces.end(),
                     [&mesh](const Face& face) { return has_one_finish(mesh, face); });
}

Eigen::Vector3f exit_radiance(const Material& material, int degree, const float* reaching,
                              const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye) {
  Eigen::Vector3f radiance = Eigen::Vector3f::Zero();
  for_exit_lobes(material, degree, normal, to_eye, [&](const Eigen::Vector3f& color, const float* lobe) {
    radiance += color.cwiseProduct(summed(degree, lobe, reaching));
  });
  return radiance;
}

std::optional<SharpestLobe> sharpest_lobe(const Transfer& transfer) {
  const Mesh& mesh = transfer.mesh;
  std::optional<SharpestLobe> sharpest;
  for (std::size_t v = 0; transfer.kind->is_glossy() && v < mesh.specular.size(); ++v) {
    const auto exponent = static_cast<double>(mesh.exponent[v]);
    if (mesh.specular[v].isZero(0.0F) || (sharpest && sharpest->exponent >= exponent)) continue;
    sharpest = {exponent, phong_share(transfer.degree(), exponent)};
  }
  return sharpest;
}

std::vector<double> held_shares_of_brdfs(const Transfer& transfer) {
  std::vector<double> shares;
  const Reflectances& brdfs = transfer.mesh.brdfs;
  for (std::size_t i = 0; transfer.kind->is_glossy() && i < brdfs.heads.size(); ++i) {
    shares.push_back(share_of_bands(brdfs.table(i), transfer.degree()));
  }
  return shares;
}

Surface glossy_surface(const Transfer& transfer, TransferredRadiance reaching, SurfaceColors colors, MoreOfLobe more) {
  return [&transfer, all = std::move(reaching), colors = std::move(colors), more = std::move(more),
          receivers = SurfaceReceivers(transfer.mesh),
          normals = ShadingNormals(transfer.mesh)](const Hit& hit, const Eigen::Vector3f& direction) {
    const Mesh& mesh = transfer.mesh;
    const ReceiversAt place = receivers.at(hit);
    std::array<float, kChannels * kMostCoefficients> between;
    all.at(place, between.data());
    const Face& face = mesh.faces[hit.face];
    const Eigen::Vector3f color = colors.at(hit);
    const Eigen::Vector3f normal = normals.at(hit);
    const auto sent = [&](std::size_t corner) {
      const Material material = material_of(mesh, face[corner], color);
      Eigen::Vector3f radiance = exit_radiance(material, all.degree(), between.data(), normal, -direction);
      if (more) radiance += more(hit, face[corner], mirrored(direction, normal));
      return radiance;
    };
    Eigen::Vector3f radiance = sent(0);
    if (!has_one_finish(mesh, face)) {
      const std::array<float, 3> part = hit.parts();
      radiance = part[0] * radiance + part[1] * sent(1) + part[2] * sent(2);
    }
    if (!transfer.emitted.empty()) radiance += place.mean(transfer.emitted);
    return radiance;
  };
}

std::vector<Eigen::Vector3f> reflected_radiance(const Transfer& transfer, const TransferredRadiance& reaching,
                                                const Eigen::Vector3d& eye,
                                                const std::vector<Eigen::Vector3f>& albedo) {
  const Mesh& mesh = transfer.mesh;
  std::vector<Eigen::Vector3f> radiance(mesh.positions.size(), Eigen::Vector3f::Zero());
  for_vertices(mesh.positions.size(), [&](std::size_t v) {
    const Eigen::Vector3f to_eye = (eye - mesh.point(v)).stableNormalized().cast<float>();
    radiance[v] =
        exit_radiance(material_of(mesh, v, albedo[v]), reaching.degree(), reaching.at(v), mesh.normals[v], to_eye);
  });
  return radiance;
}

std::vector<Eigen::Vector3f> exit_radiance(const Transfer& transfer, const TransferredRadiance& reaching,
                                           const Eigen::Vector3d& eye, const std::vector<Eigen::Vector3f>& albedo) {
  std::vector<Eigen::Vector3f> radiance = reflected_radiance(transfer, reaching, eye, albedo);
  for (std::size_t v = 0; v < transfer.emitted.size(); ++v) radiance[v] += transfer.emitted[v];
  return radiance;
}

}  // namespace sh::prt
