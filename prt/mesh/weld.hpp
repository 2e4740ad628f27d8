// Makes the finished mesh: welds loose triangles, splits large faces, adds backs, joins meshes.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "prt/mesh/mesh.hpp"
#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// One vertex for each position (exact bits), normal (to 1/8192), albedo, finish and, if it has pictures, texture
/// coordinates (exact bits), in the order of first use by a face; unused vertices are dropped. Faces keep their order.
/// Precondition: the soup has passed check() and has normals. `source_vertices` is the number of vertices of the file
/// and the length of the remap, which names the first vertex made from each; 0 for a soup made in code, which gets no
/// remap.
Mesh weld(const Soup& soup, std::size_t source_vertices = 0);

/// Sets geometric_normals to the mean, weighted by angle, of the normals of the faces around each vertex. Each face
/// normal is first turned to the side of the shading normal. If they cancel, the shading normal is taken.
void set_geometric_normals(Mesh& mesh);

/// Appends `part` and its remap to `mesh`.
void append(Mesh& mesh, const Mesh& part);

/// Appends a copy of the finish of a vertex, as far as the mesh has any.
void repeat_finish(Mesh& mesh, std::uint32_t vertex);

/// Gives every face with is_two_sided (faces) != 0 a back: the same triangle turned around, with its own vertices and
/// reversed normals. Each side then gathers, sends out and shows its own light, like the sides of a thin surface. All
/// other code handles one-sided faces only; rays distinguish the two sides (prt/rays/tracer.hpp).
void add_backs(Mesh& mesh, const std::vector<std::uint8_t>& is_two_sided);

/// The longest edge allowed around a point; positive.
using EdgeLimit = std::function<float(const Eigen::Vector3f&)>;

inline constexpr std::size_t kMaxFaces = std::size_t{1} << 25U;

/// Halves edges until none is longer than `limit` at its middle. The two end points alone decide whether an edge is
/// halved. Faces on both sides therefore agree, even at hard edges where they share no vertex, and no cracks open. Old
/// vertices keep their numbers. Returns, for each new face, the old face that it is a part of. Counts ahead: before any
/// work it throws std::runtime_error, one line that begins with `name` and says what would do, if more than kMaxFaces
/// faces would be left. Throws output::Interrupted on request.
std::vector<std::uint32_t> tessellate(Mesh& mesh, const EdgeLimit& limit, const std::string& name);

}  // namespace sh::prt
