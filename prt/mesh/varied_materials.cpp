#include "prt/mesh/varied_materials.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "prt/image/bilinear.hpp"
#include "prt/material/microfacet.hpp"

namespace sh::prt {

namespace {

int step_of(float value, int steps) {
  return static_cast<int>(std::lround(std::clamp(value, 0.0F, 1.0F) * static_cast<float>(steps)));
}

// Numbers of tables by steps of roughness and metallic part.
class Tables {
 public:
  explicit Tables(Mesh& mesh) : mesh_(mesh) {}

  std::uint16_t number(float roughness, float metallic) {
    const std::pair steps = {step_of(roughness, kRoughnessSteps), step_of(metallic, kMetallicSteps)};
    const auto [entry, added] = numbers_.try_emplace(steps);
    if (added) {
      const auto surfaces = surfaces_.try_emplace(steps.first, static_cast<float>(steps.first) / kRoughnessSteps).first;
      const Reflectance table = surfaces->second.reflectance(static_cast<float>(steps.second) / kMetallicSteps);
      entry->second = static_cast<std::uint16_t>(1 + mesh_.brdfs.number_of(table));
    }
    return entry->second;
  }

 private:
  Mesh& mesh_;
  std::map<int, MicrofacetSurfaces> surfaces_;  // by steps of roughness
  std::map<std::pair<int, int>, std::uint16_t> numbers_;
};

// The means of the pictures of one finish around a receiver.
struct Means {
  Eigen::Vector3f albedo = Eigen::Vector3f::Zero();
  Eigen::Vector3f emission = Eigen::Vector3f::Zero();
  Eigen::Vector3f facets = Eigen::Vector3f::Zero();
  float weight = 0.0F;

  void add(const VariedMaterial& varied, const Eigen::Vector2f& texture, float more) {
    const auto sum = [&](const std::shared_ptr<const Image>& image, Eigen::Vector3f& total) {
      if (image != nullptr) total += more * repeated(texture, *image);
    };
    sum(varied.albedo, albedo);
    sum(varied.emission, emission);
    sum(varied.facets, facets);
    weight += more;
  }
};

// Steps along a length in texture coordinates: about one a texel of the finest picture.
int steps_along(const VariedMaterial& varied, const Eigen::Vector2f& length) {
  float texels = 1.0F;
  for (const auto* image : {&varied.albedo, &varied.emission, &varied.facets}) {
    if (*image == nullptr) continue;
    texels = std::max({texels, std::abs(length.x()) * static_cast<float>((*image)->width),
                       std::abs(length.y()) * static_cast<float>((*image)->height)});
  }
  return static_cast<int>(std::min(std::ceil(texels), static_cast<float>(kMostSamplesAlong)));
}

// Samples in the middles of equal parts of a face; each counts for the corner that is nearest by its parts, or for all that
// are.
void add_face(const VariedMaterial& varied, const Mesh& mesh, const Face& face, std::vector<Means>& means) {
  const std::array<Eigen::Vector2f, 3> at = {mesh.texture[face[0]], mesh.texture[face[1]], mesh.texture[face[2]]};
  const int n = std::max(
      {steps_along(varied, at[1] - at[0]), steps_along(varied, at[2] - at[1]), steps_along(varied, at[0] - at[2])});
  const Eigen::Vector3f a = mesh.positions[face[1]] - mesh.positions[face[0]];
  constexpr float kLeastArea = 1e-30F;  // a mean over faces without area, too
  const float area = std::max(a.cross(mesh.positions[face[2]] - mesh.positions[face[0]]).norm(), kLeastArea);
  const auto sample = [&](int i, int j, int third) {  // in thirds of a step
    const std::array<int, 3> parts = {3 * n - 3 * (i + j) - 2 * third, 3 * i + third, 3 * j + third};
    const int most = *std::max_element(parts.begin(), parts.end());
    const auto share = static_cast<float>(std::count(parts.begin(), parts.end(), most));
    const float whole = 1.0F / static_cast<float>(3 * n);
    const Eigen::Vector2f place = whole * (static_cast<float>(parts[0]) * at[0] + static_cast<float>(parts[1]) * at[1] +
                                           static_cast<float>(parts[2]) * at[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (parts[k] == most) means[face[k]].add(varied, place, area / share);
    }
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      sample(i, j, 1);
      if (i + j + 1 < n) sample(i, j, 2);
    }
  }
}

// Samples over the square of a texel, as far as the plane of its face goes.
void add_texel(const VariedMaterial& varied, const Mesh& mesh, const Face& face, const Atlases::Head& atlas,
               std::size_t vertex, std::vector<Means>& means) {
  Eigen::Matrix2f charts;
  Eigen::Matrix2f textures;
  for (int k = 0; k < 2; ++k) {
    const std::uint32_t v = face[static_cast<std::size_t>(k) + 1];
    charts.col(k) = mesh.chart[v] - mesh.chart[face[0]];
    textures.col(k) = mesh.texture[v] - mesh.texture[face[0]];
  }
  const Eigen::Matrix2f by_chart = textures * charts.inverse();
  const Eigen::Vector2f size(1.0F / static_cast<float>(atlas.width), 1.0F / static_cast<float>(atlas.height));
  const int n =
      std::max(steps_along(varied, by_chart.col(0) * size.x()), steps_along(varied, by_chart.col(1) * size.y()));
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::Vector2f step((static_cast<float>(i) + 0.5F) / static_cast<float>(n) - 0.5F,
                                 (static_cast<float>(j) + 0.5F) / static_cast<float>(n) - 0.5F);
      const Eigen::Vector2f place = mesh.chart[vertex] + step.cwiseProduct(size);
      means[vertex].add(varied, mesh.texture[face[0]] + by_chart * (place - mesh.chart[face[0]]), 1.0F);
    }
  }
}

void take(const VariedMaterial& varied, const Means& means, std::size_t v, Tables& tables, Mesh& mesh) {
  if (!mesh.tint.empty()) mesh.tint[v] = mesh.albedo[v];
  if (varied.albedo != nullptr) {
    mesh.albedo[v] = mesh.albedo[v].cwiseProduct(means.albedo / means.weight).cwiseMin(1.0F);
  }
  if (varied.emission != nullptr) mesh.emission[v] = mesh.emission[v].cwiseProduct(means.emission / means.weight);
  if (varied.facets != nullptr) {
    const Eigen::Vector3f factors = means.facets / means.weight;
    mesh.brdf.resize(mesh.positions.size(), 0);
    mesh.brdf[v] = tables.number(varied.roughness * factors.y(), varied.metallic * factors.z());
  }
}

}  // namespace

void vary_materials(const Soup& soup, const std::vector<std::uint32_t>& origins,
                    const std::vector<std::uint32_t>& texels, Mesh& mesh) {
  const auto of_face = [&](std::size_t f) -> const VariedMaterial& {
    return soup.finishes[soup.finish_of(origins[f])].varied;
  };
  std::vector<Means> means(mesh.positions.size());
  std::vector<const VariedMaterial*> varied(mesh.positions.size(),
                                            nullptr);  // of a vertex, whose faces have one finish
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!of_face(f).any()) continue;
    add_face(of_face(f), mesh, mesh.faces[f], means);
    for (const std::uint32_t v : mesh.faces[f]) varied[v] = &of_face(f);
  }
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if (!of_face(texels[i]).any()) continue;
    const Atlases::Head& atlas = mesh.atlases.heads.front();
    add_texel(of_face(texels[i]), mesh, mesh.faces[texels[i]], atlas, atlas.first + i, means);
    varied[atlas.first + i] = &of_face(texels[i]);
  }
  Tables tables(mesh);
  for (std::size_t v = 0; v < varied.size(); ++v) {
    if (varied[v] != nullptr) take(*varied[v], means[v], v, tables, mesh);
  }
  if (mesh.normal_map.empty() && mesh.albedo_map.empty()) mesh.texture.clear();
}

}  // namespace sh::prt
