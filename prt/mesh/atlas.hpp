// Atlases: pictures over the surface of a mesh whose texels are receivers of light, as lightmaps of engines are. A texel is
// a vertex without faces. Its place on the surface is where its center lies, or, at the border of a part of the surface, the
// middle of what the surface covers of it.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

struct Mesh;

/// The most texels of an atlas along a side.
inline constexpr int kMostTexelsAlong = 8192;

/// The atlases of a mesh. (u, v) = (0, 0) is the lower left corner of an atlas, (1, 1) its upper right one.
struct Atlases {
  struct Head {
    int width = 0;
    int height = 0;
    std::uint32_t first = 0;  // vertex of the first texel; those of the others follow
    std::uint32_t count = 0;  // of texels on the surface
  };
  std::vector<Head> heads;
  std::vector<std::uint32_t> pixels;  // (texels) of one atlas after another: column + width * row, the top row first
  /// (texels) half the distance between neighbors on the surface; empty of a mesh from a transfer file.
  std::vector<float> reach;

  /// The entry of the first texel of an atlas in `pixels` and `reach`.
  [[nodiscard]] std::size_t entry(std::size_t number) const {
    std::size_t first = 0;
    for (std::size_t i = 0; i < number; ++i) first += heads[i].count;
    return first;
  }
};

/// Adds an atlas of size x size texels over the first `faces` faces of a mesh, by the coordinates in Mesh::chart; a texel
/// is there if any face covers a part of it. It takes what lies between the corners of its face, the normal of the face,
/// and its finish; its own `chart` is its center. Returns the faces of the texels. Throws std::runtime_error, one line that
/// begins with `name`, for coordinates that are missing or beyond 0..1, where two faces cover the center of one texel, and
/// if no face covers any.
std::vector<std::uint32_t> add_atlas(Mesh& mesh, std::size_t faces, int size, const std::string& name);

/// The place of the center of a pixel, an entry of Atlases::pixels, in its atlas.
Eigen::Vector2f center_of_pixel(const Atlases::Head& atlas, std::uint32_t pixel);

/// The vertices of texels beside each other that are neighbors on the surface, too: each pair once, in order.
std::vector<std::array<std::uint32_t, 2>> neighboring_texels(const Mesh& mesh);

}  // namespace sh::prt
