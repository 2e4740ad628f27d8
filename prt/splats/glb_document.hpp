// The JSON of a GLB file: where the attributes of its splats stand, and how they are placed.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/splats/glb_attributes.hpp"
#include "prt/splats/splat_transform.hpp"

namespace sh::prt {

class InputFile;

struct GlbColumn {
  GlbAttribute attribute;
  int component_type = 0;  // of glTF, such as 5126: float
  bool normalized = false;
  std::uint64_t offset = 0;  // of the first splat, in the file
  std::size_t stride = 0;
  std::size_t size = 0;  // bytes of a splat
};

struct GlbDocument {
  std::size_t count = 0;
  int degree = 0;
  std::vector<GlbColumn> columns;
  Similarity placement;
  std::string color_space;
  std::string kernel;
  std::string generator;
  std::string other_attributes;  // names
};

/// Throws std::runtime_error with one line; see read_glb_splats. All columns lie within the file.
GlbDocument read_glb_document(const InputFile& file);

/// Bytes of a component; 0 for a type that glTF does not have.
std::size_t size_of_component(int component_type);

}  // namespace sh::prt
