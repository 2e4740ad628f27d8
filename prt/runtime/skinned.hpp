// Relights a deforming mesh, whose vertices follow bones. "Blending SH vectors the same way we use blending matrices for
// joints works well for the cosine term" [Green 2003], but not for shadows: they stay those of the pose that was baked, and
// turn with the bones. A vector that turns meets the light as the vector at rest meets light that turns back: the light is
// turned into the axes of every bone once a frame, and a vertex meets the mix of these lights by its weights. Exact where
// all bones turn alike. At degree 1, 4 coefficients a vertex, the mix is that of the normals.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Up to four bones of every vertex, as skinned models of glTF have them.
struct Skin {
  std::vector<std::array<std::uint16_t, 4>> bones;  // (vertices)
  std::vector<std::array<float, 4>> weights;        // (vertices), 0 or more, which sum to 1
};

/// Exit radiance per vertex, (vertices), linear RGB, of diffuse transfer without bounces. rotations: of the bones, from the
/// pose that was baked. The light is in the world; one of lower degree than the transfer is zero in the bands above. In parallel; the same
/// bits for any number of threads. Throws std::invalid_argument, which names the vertex, for a bone that is not there, weights
/// that are negative or do not sum to 1 within 1e-3, and entries that are not one a vertex; and like recolored().
std::vector<Eigen::Vector3f> relight_skinned(const Transfer& transfer, const Skin& skin,
                                             std::span<const Eigen::Matrix3d> rotations,
                                             const LightCoefficients& light);

}  // namespace sh::prt
