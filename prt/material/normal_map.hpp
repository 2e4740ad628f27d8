// Normal maps: pictures of the normals of a surface in its own frame. x follows the texture coordinate u, y follows v, z
// the normal between the vertices (green points up, as in glTF and OpenGL). A pixel is (n + 1) / 2, linear data in any
// file format. (u, v) = (0, 0) is the lower left corner of the picture, (1, 1) its upper right one; it repeats beyond.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "prt/image/image.hpp"

namespace sh::prt {

struct NormalMap {
  std::string name;  // for people
  int width = 0;
  int height = 0;
  std::vector<Eigen::half> texels;  // (height, width, 3), top row first: n, of any length; in -1..1
  bool operator==(const NormalMap&) const = default;
};

/// The map of a picture of linear data. Channels beyond 0..1 are cut. `scale` multiplies x and y (glTF's normalTexture
/// has one); they are cut to -1..1.
NormalMap normal_map_of(std::string name, const Image& image, float scale = 1.0F);

/// Reads a picture as read_image() does, as linear data.
NormalMap read_normal_map(const std::string& file, OnFlaw on_flaw);

/// The maps of a mesh, one after another, as in files.
struct NormalMaps {
  /// 8192 x 8192 texels of 6 bytes.
  static constexpr std::size_t kMostTexels = std::size_t{1} << 26U;

  struct Head {
    std::string name;
    int width = 0;
    int height = 0;
  };
  std::vector<Head> heads;
  std::vector<Eigen::half> texels;

  /// The number of an equal one, which is added if there is none. Throws std::runtime_error for more than kMostTexels in
  /// all.
  std::size_t number_of(const NormalMap& map);
  [[nodiscard]] NormalMap at(std::size_t number) const;
  /// The unit normal in the frame of the surface, bilinear between texels; (0, 0, 1) where the texels have no length.
  [[nodiscard]] Eigen::Vector3f normal(std::size_t number, const Eigen::Vector2f& texture) const;
  /// The texels that the heads count.
  [[nodiscard]] std::size_t texel_count() const { return first_texel(heads.size()); }

 private:
  [[nodiscard]] std::size_t first_texel(std::size_t number) const;
};

}  // namespace sh::prt
