// Welds loose triangles into an indexed mesh and joins meshes.
#pragma once
#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// One vertex for each position (exact bits), normal (to 1/8192), albedo and finish, in the order of first use by a
/// face; unused vertices are dropped. Faces keep their order. Precondition: the soup has passed check() and has
/// normals. `source_vertices` is the number of vertices of the file and the length of the remap, which names the first
/// vertex made from each.
Mesh weld(const Soup& soup, std::size_t source_vertices);

/// Sets geometric_normals to the mean, weighted by angle, of the normals of the faces around each vertex. Each face
/// normal is first turned to the side of the shading normal. If they cancel, the shading normal is taken.
void set_geometric_normals(Mesh& mesh);

/// Appends `part` and its remap to `mesh`.
void append(Mesh& mesh, const Mesh& part);

}  // namespace sh::prt
