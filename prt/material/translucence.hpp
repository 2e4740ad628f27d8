// Materials of bodies that let light through. Lengths are in the unit of the scene.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace sh::prt {

/// How the body behind a surface carries light, linear RGB; one of two models:
///   straight  the part transmission * exp(-extinction * way) of the light that arrives from behind, along straight lines
///   dipole    light scatters below the surface [JensenMarschnerLevoyHanrahan01]; `ior` is then not 0
struct Translucence {
  Eigen::Vector3f transmission = Eigen::Vector3f::Zero();  // 0..1
  Eigen::Vector3f extinction = Eigen::Vector3f::Zero();    // 1 / unit
  Eigen::Vector3f absorption = Eigen::Vector3f::Zero();    // sigma_a, 1 / unit
  Eigen::Vector3f scattering = Eigen::Vector3f::Zero();    // reduced, sigma_s', 1 / unit; not 0 if light scatters
  float ior = 0.0F;                                        // of the body over that around it; 0: light does not scatter
  std::uint32_t body = 0;  // light that scatters stays in one: each mesh of a scene is another
  [[nodiscard]] bool scatters() const { return ior > 0.0F; }
  bool operator==(const Translucence&) const = default;
};

inline constexpr float kLeastIor = 1.0F;
inline constexpr float kLargestIor = 3.0F;

/// The materials of a mesh.
struct Translucences {
  std::vector<Translucence> heads;

  /// The number of an equal one, which is added if there is none. Throws std::runtime_error for more than 65535.
  std::size_t number_of(const Translucence& material) {
    const auto found = std::find(heads.begin(), heads.end(), material);
    if (found != heads.end()) return static_cast<std::size_t>(found - heads.begin());
    if (heads.size() == 65535) throw std::runtime_error("more than 65535 translucent materials");
    heads.push_back(material);
    return heads.size() - 1;
  }
  [[nodiscard]] const Translucence& at(std::size_t number) const { return heads[number]; }
};

}  // namespace sh::prt
