#include "prt/mesh/varied_materials.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "prt/image/bilinear.hpp"
#include "prt/material/microfacet.hpp"

namespace sh::prt {

namespace {

Eigen::Vector3f sampled(const Image& image, const Eigen::Vector2f& texture) {
  return repeated(texture, image.width, image.height,
                  [&](int column, int row) -> const Eigen::Vector3f& { return image.at(column, row); });
}

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

}  // namespace

void vary_materials(const Soup& soup, const std::vector<std::uint32_t>& origins, Mesh& mesh) {
  std::vector<std::uint8_t> is_done(mesh.positions.size(), 0);
  Tables tables(mesh);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const VariedMaterial& varied = soup.finishes[soup.finish_of(origins[f])].varied;
    if (!varied.any()) continue;
    for (const std::uint32_t v : mesh.faces[f]) {  // all of this finish
      if (std::exchange(is_done[v], 1) != 0) continue;
      if (varied.albedo != nullptr) {
        mesh.albedo[v] = mesh.albedo[v].cwiseProduct(sampled(*varied.albedo, mesh.texture[v])).cwiseMin(1.0F);
      }
      if (varied.facets != nullptr) {
        const Eigen::Vector3f factors = sampled(*varied.facets, mesh.texture[v]);
        mesh.brdf.resize(mesh.positions.size(), 0);
        mesh.brdf[v] = tables.number(varied.roughness * factors.y(), varied.metallic * factors.z());
      }
    }
  }
  if (mesh.normal_map.empty()) mesh.texture.clear();
}

}  // namespace sh::prt
