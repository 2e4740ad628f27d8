// The albedo at any place of a surface: interpolated between vertices or, where the mesh has a picture of it, that of the
// picture, so that a picture of the surface is as sharp as the texture and not as coarse as the vertices.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "prt/image/image.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/rays/sheets.hpp"

namespace sh::prt {

/// The radiance that diffuse surfaces of albedo 1 would send, (vertices), from that of surfaces of this albedo; `emitted`
/// (vertices, or empty) is the part of it that they emit, which is left out. Black surfaces tell none: 0.
std::vector<Eigen::Vector3f> without_albedo(const std::vector<Eigen::Vector3f>& radiance,
                                            const std::vector<Eigen::Vector3f>& emitted,
                                            const std::vector<Eigen::Vector3f>& albedo);

using DecodedPictures = std::shared_ptr<const std::vector<Image>>;

/// The pictures in Mesh::albedo_maps. Throws std::runtime_error, one line that begins with `name`, for one that cannot be
/// read.
DecodedPictures decoded(const Pictures& pictures, const std::string& name);

class SurfaceColors {
 public:
  /// Without pictures: `albedo` (vertices), linear RGB, in place of the mesh's. The mesh must outlive the result.
  SurfaceColors(const Mesh& mesh, std::vector<Eigen::Vector3f> albedo) : mesh_(mesh), albedo_(std::move(albedo)) {}
  /// The mesh's own, with its decoded pictures.
  SurfaceColors(const Mesh& mesh, DecodedPictures pictures)
      : mesh_(mesh), albedo_(mesh.albedo), pictures_(std::move(pictures)) {}

  /// Linear RGB, 0..1.
  [[nodiscard]] Eigen::Vector3f at(const Hit& hit) const;
  /// Whether a picture shows at the faces around a vertex.
  [[nodiscard]] bool has_picture(std::uint32_t vertex) const {
    return pictures_ != nullptr && !mesh_.albedo_map.empty() && mesh_.albedo_map[vertex] != 0;
  }
  [[nodiscard]] const std::vector<Eigen::Vector3f>& of_vertices() const { return albedo_; }

 private:
  const Mesh& mesh_;
  std::vector<Eigen::Vector3f> albedo_;
  DecodedPictures pictures_;
};

}  // namespace sh::prt
