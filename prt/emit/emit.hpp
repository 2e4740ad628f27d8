// The run time of one transfer file as source code: the generated kernels that its kind, degree and kept coefficients
// need, a loop over its vertices in blocks of 16, and its numbers as stored, interleaved by block.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct EmittedFile {
  std::string name;
  std::string bytes;
};

struct EmitOptions {
  std::string name = "transfer";  // letters, digits and _; the namespace is sh_<name>
  /// Coefficients, by l(l+1)+m, that the declared lights have in any channel; the others cost nothing. Empty: all.
  std::vector<std::uint32_t> light;
  /// Glossy kinds in GLSL: the vertices give the radiance that reaches them, the pixels what leaves, with normal maps.
  bool per_pixel = false;
};

/// The operations of a vertex: of the kernels that read the light, and of the same kernels without a mask.
struct EmittedCost {
  int operations = 0;
  int unmasked = 0;
};

struct Emitted {
  std::vector<EmittedFile> files;
  EmittedCost cost;
};

/// relight.hpp is C++17 that compiles alone, and gives the radiance of `prt relight` to rounding; relight.bin holds the
/// numbers that it reads. Throws std::invalid_argument for a kind, degree or light that has no kernel, and for per_pixel.
Emitted emit_cpp(const Transfer& transfer, const EmitOptions& options);

/// relight.vert is a complete vertex shader, GLSL 4.50 core or ES 3.00; relight.bin holds its textures and attributes, and
/// relight.json says where. Where rows or matrices are in clusters, lit.vert or lit_matrices.vert meets them with the light,
/// once a frame. per_pixel: relight.frag goes with relight.vert and gives the radiance that `prt render` shows, to rounding.
/// Throws std::invalid_argument as emit_cpp; per_pixel also for diffuse kinds, for faces with several materials, and for
/// more numbers than graphics cards interpolate.
Emitted emit_glsl(const Transfer& transfer, const EmitOptions& options, bool es);

}  // namespace sh::prt
