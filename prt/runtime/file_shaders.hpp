// The vertex shaders that relight one transfer file from its numbers as they are stored: the texts of prt/shaders with
// generated functions of any degree. `prt emit` writes shaders with functions of its own for the file's nonzero numbers.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// A pass before relighting, in which the light meets the means and vectors of clusters (prt/shaders/lit.glsl), or before
/// pixels are shaded, in which it meets the receivers (prt/shaders/of_texels.vert): `rows` points in `parts` instances, each
/// of which writes one vec4.
struct LitPass {
  std::string shader;
  std::string texture;  // that the other shader reads: lit, lit_matrices or of_texels
  std::size_t rows = 0;
  std::size_t parts = 0;
};

/// Glossy surfaces shaded at every pixel, as `prt render` does: with perspective between the vertices or, in atlases,
/// between texels, and normal maps.
struct PixelShaders {
  std::string vertex;
  std::string fragment;           // vec3 pixel_radiance(); the main function is left to the caller
  std::size_t vectors = 0;        // 4-vectors between them
  std::optional<LitPass> texels;  // where faces lie in atlases
};

struct FileShaders {
  std::string relight;  // writes `radiance` of a vertex
  std::vector<LitPass> lit;
  std::optional<PixelShaders> pixels;  // of glossy kinds whose faces have one lobe or BRDF each
};

/// GLSL ES 3.00, for a transfer with this kind, these shapes and materials. Textures: `transfer` or `rows`, `matrices`,
/// `tables`, `weights`, `matrix_weights`, of pixels `normals`: four numbers a texel, those of 8 bits RGBA8_SNORM. Diffuse light takes the scale
/// of 8-bit numbers times 127; visibility has the uniform `row_scale` for it. Throws std::invalid_argument for visibility whose product with
/// the light has no generated shader.
FileShaders file_shaders(const Transfer& transfer);

/// The 4-vectors in which vertices hand on what reaches them; 0 if one radiance reaches all.
std::size_t vectors_carried(const Transfer& transfer);
/// All that they hand on to pixels, at most.
std::size_t vectors_between(const Transfer& transfer);

/// GLSL constants map_first, map_width, map_height of prt/shaders/normal_maps.glsl.
std::string places_of_maps(const NormalMaps& maps);

/// 8 n^2 + 4, or 1 at degree 0: the numbers of a light that transfer_prepare makes.
constexpr std::size_t sample_count(int degree) {
  return degree == 0 ? 1 : 8 * static_cast<std::size_t>(degree * degree) + 4;
}

}  // namespace sh::prt
