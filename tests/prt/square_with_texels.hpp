// A square whose receivers are the texels of its atlas.
#pragma once
#include "prt/mesh/atlas.hpp"
#include "prt/mesh/primitives.hpp"
#include "prt/mesh/weld.hpp"

namespace sh::prt::test {

inline Mesh square_with_texels(int size, bool mirrored = false) {
  Soup soup = make_primitive("plane");
  soup.chart = soup.texture;
  for (Eigen::Vector2f& at : soup.chart) at.x() = mirrored ? 1.0F - at.x() : at.x();
  Mesh mesh = weld(soup);
  add_atlas(mesh, mesh.faces.size(), size, "square");
  return mesh;
}

}  // namespace sh::prt::test
