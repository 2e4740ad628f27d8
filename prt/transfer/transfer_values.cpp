#include "prt/transfer/transfer_values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "prt/arrays.hpp"

namespace sh::prt {
namespace {

template <class Items, class Test>
bool all(const Items& items, const Test& test) {
  return std::all_of(items.begin(), items.end(), test);
}

bool is_finite(const Eigen::Vector3f& value) { return value.allFinite(); }

bool is_unit(const Eigen::Vector3f& value) {
  constexpr float kRounding = 1e-3F;
  return std::abs(value.norm() - 1.0F) <= kRounding;
}

bool is_reflectance(const Eigen::Vector3f& value) {
  return value.allFinite() && value.minCoeff() >= 0.0F && value.maxCoeff() <= 1.0F;
}

bool all_finite(const Rows& rows) {
  bool finite = true;
  rows.each(0, rows.count(), [&](std::size_t /*first*/, std::size_t count, const float* numbers) {
    finite = finite && as_array(numbers, count * rows.length()).isFinite().all();
  });
  return finite;
}

constexpr float kMaxReflectance = 1000.0F;  // no limit of nature, but far above all that a surface reflects

bool is_exponent(float value) { return value >= 0.0F && value <= kMaxExponent; }

// Of a function from 0 to 1 none exceeds sqrt(4 pi).
bool is_of_visibility(float value) { return std::abs(value) <= 4.0F; }

bool names_vertices(const Mesh& mesh) {
  const auto is_vertex = [&](std::uint32_t v) { return v < mesh.positions.size(); };
  return all(mesh.faces, [&](const Face& face) { return all(face, is_vertex); }) &&
         all(mesh.remap, [&](std::uint32_t v) { return v == kNoVertex || is_vertex(v); });
}

// What no bake makes; empty if there is nothing. No weights of -1 to 1 lead out of single precision.
std::string flaw_of(const Clusters& clusters) {
  if (clusters.empty()) return {};
  const std::size_t count = clusters.count();
  if (!all(clusters.cluster, [&](std::uint16_t c) { return c < count; })) return "it names a cluster that is not there";
  if (!all(clusters.weights, [](std::int8_t weight) { return weight >= -Clusters::kSteps; })) {
    return "a weight is below -127";
  }
  const std::size_t length = clusters.length;
  Eigen::ArrayXf sums(length);
  for (std::size_t row = 0; row * length < clusters.basis.size(); ++row) {
    if (row % (1 + clusters.vectors) == 0) sums.setZero();
    sums += as_array(&clusters.basis[row * length], length).abs();
    if (!sums.allFinite()) return "a transfer coefficient is not finite";
  }
  return {};
}

std::string flaw_of_pictures(const Mesh& mesh) {
  const Pictures& pictures = mesh.albedo_maps;
  if (pictures.bytes.size() != pictures.byte_count() || mesh.albedo_map.empty() != pictures.heads.empty() ||
      mesh.tint.size() != mesh.albedo_map.size() ||
      !all(mesh.albedo_map, [&](std::uint16_t number) { return number <= pictures.heads.size(); })) {
    return "it names a picture of the albedo that is not there";
  }
  return all(mesh.tint, is_reflectance) ? "" : "a tint is not from 0 to 1";
}

// Texels are vertices, and rise in their atlas.
std::string flaw_of_atlases(const Mesh& mesh) {
  const Atlases& atlases = mesh.atlases;
  std::size_t entry = 0;
  for (const Atlases::Head& head : atlases.heads) {
    const std::size_t size = static_cast<std::size_t>(head.width) * static_cast<std::size_t>(head.height);
    const std::size_t last = std::size_t{head.first} + head.count;
    if (last > mesh.positions.size() || entry + head.count > atlases.pixels.size()) {
      return "an atlas names texels that are not there";
    }
    const auto first = atlases.pixels.begin() + static_cast<std::ptrdiff_t>(entry);
    const auto end = first + head.count;
    if (!std::is_sorted(first, end, std::less_equal<>()) || (head.count > 0 && *(end - 1) >= size)) {
      return "the texels of an atlas are not in order, or beyond its size";
    }
    entry += head.count;
  }
  if (entry != atlases.pixels.size() || mesh.chart.size() != mesh.atlas.size() ||
      mesh.atlas.empty() != atlases.heads.empty() || !all(mesh.atlas, [&](std::uint16_t number) {
        return number <= atlases.heads.size() && (number == 0 || atlases.heads[number - std::size_t{1}].count > 0);
      })) {
    return "it names an atlas that is not there";
  }
  const auto is_within = [](const Eigen::Vector2f& place) {
    constexpr float kRounding = 1e-4F;
    return place.allFinite() && place.minCoeff() >= -kRounding && place.maxCoeff() <= 1.0F + kRounding;
  };
  return all(mesh.chart, is_within) ? "" : "a place in an atlas is not from 0 to 1";
}

}  // namespace

std::string flaw_of_values(const Transfer& transfer) {
  const Mesh& mesh = transfer.mesh;
  if (transfer.grid) {
    if (std::string flaw = flaw_of(*transfer.grid); !flaw.empty()) return flaw;
  }
  if (!all(transfer.density, [](float value) { return value >= 0.0F && std::isfinite(value); })) {
    return "a density is negative or not finite";
  }
  if (!names_vertices(mesh)) return "it names a vertex that is not there";
  if (!all(mesh.positions, is_finite)) return "a position is not finite";
  if (!all(mesh.normals, is_unit) || !all(mesh.geometric_normals, is_unit)) return "a normal is not of length 1";
  if (!all(mesh.albedo, is_reflectance)) return "an albedo is not from 0 to 1";
  if (!all(mesh.mirror, is_reflectance)) return "a mirror's reflectance is not from 0 to 1";
  if (!all(mesh.specular, is_reflectance)) return "a specular reflectance is not from 0 to 1";
  if (mesh.exponent.size() != mesh.specular.size() || !all(mesh.exponent, is_exponent)) {
    return "an exponent is not from 0 to 1e6";
  }
  const Reflectances& brdfs = mesh.brdfs;
  if (brdfs.rows.size() != brdfs.heads.size() * kReflectanceTableSize || mesh.brdf.empty() != brdfs.heads.empty() ||
      !all(mesh.brdf, [&](std::uint16_t number) { return number <= brdfs.heads.size(); })) {
    return "it names a BRDF that is not there";
  }
  if (!all(brdfs.rows, [](float value) { return std::abs(value) <= kMaxReflectance; })) {
    return "a coefficient of a BRDF is not from -1000 to 1000";
  }
  const NormalMaps& maps = mesh.normal_maps;
  if (maps.texels.size() != 3 * maps.texel_count() || mesh.normal_map.empty() != maps.heads.empty() ||
      mesh.texture.size() != std::max(mesh.normal_map.size(), mesh.albedo_map.size()) ||
      !all(mesh.normal_map, [&](std::uint16_t number) { return number <= maps.heads.size(); })) {
    return "it names a normal map that is not there";
  }
  if (!all(mesh.texture, [](const Eigen::Vector2f& value) { return value.allFinite(); })) {
    return "a texture coordinate is not finite";
  }
  if (!all(maps.texels, [](Eigen::half value) { return std::abs(static_cast<float>(value)) <= 1.0F; })) {
    return "a texel of a normal map is not from -1 to 1";
  }
  if (std::string flaw = flaw_of_pictures(mesh); !flaw.empty()) return flaw;
  if (std::string flaw = flaw_of_atlases(mesh); !flaw.empty()) return flaw;
  if (!all_finite(transfer.rows()) || !all_finite(transfer.matrices()) || !all(transfer.emitted, is_finite)) {
    return "a transfer coefficient is not finite";
  }
  if (transfer.grid && transfer.shape.meets == Meets::kOperator && !all(transfer.coefficients, is_of_visibility)) {
    return "a coefficient of a visibility is not from -4 to 4";
  }
  const std::string flaw = flaw_of(transfer.clusters);
  return flaw.empty() ? flaw_of(transfer.indirect_clusters) : flaw;
}

}  // namespace sh::prt
