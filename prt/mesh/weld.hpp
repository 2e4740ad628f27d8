// From loose triangles to an indexed mesh, and meshes into one.
#pragma once
#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// One vertex for each position (exact bits), normal (to 1/8192), albedo and finish, in the order of first use by a
/// face; what no face uses is left out. Faces keep their order. The soup has passed check() and has normals.
/// `source_vertices` is how many vertices the file had: the length of the remap, which names the first vertex made from
/// each.
Mesh weld(const Soup& soup, std::size_t source_vertices);

/// Sets geometric_normals: the mean, by angle, of the faces around each vertex, each turned to the shading normal's
/// side; the shading normal where they cancel.
void set_geometric_normals(Mesh& mesh);

/// Appends `part` to `mesh`, its remap included.
void append(Mesh& mesh, const Mesh& part);

}  // namespace sh::prt
