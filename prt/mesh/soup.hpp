// Triangles as a file or a generator gives them, before they are welded into a Mesh, and the checks they must pass.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "prt/mesh/material.hpp"
#include "prt/mesh/mesh.hpp"

namespace sh::prt {

/// Vertices may repeat. `normals` is empty (then they are made) or as long as `positions`, as `albedo` is.
struct Soup {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector3f> albedo;  // linear RGB
  std::vector<Face> faces;              // counter-clockwise seen from outside
  std::vector<std::uint32_t> source;    // vertex of the file each vertex came from; empty: itself
  std::vector<std::uint32_t> finish;    // (faces) into `finishes`; empty: every face has the first
  std::vector<Finish> finishes{Finish{}};

  [[nodiscard]] std::uint32_t finish_of(std::size_t face) const { return finish.empty() ? 0 : finish[face]; }
};

/// Points by the map, normals by its inverse transpose; a map that mirrors turns the faces around too.
void transform(Soup& soup, const Eigen::Affine3f& map);

/// Throws std::runtime_error, one line that begins with `name`, for no vertices, no faces, a face that names a vertex
/// that is not there, a NaN or infinite coordinate.
void check(const Soup& soup, const std::string& name);

/// Drops faces without area (to rounding); returns how many.
std::size_t drop_faces_without_area(Soup& soup);

/// Turns the whole around: what was behind is before.
void turn_inside_out(Soup& soup);

/// Turns faces whose corners' normals, together, point behind them; returns how many. The soup has normals and passed
/// check().
std::size_t turn_faces_to_normals(Soup& soup);

/// Normals that are missing, zero or not finite come from the faces. A soup without any gets a vertex per face corner:
/// a corner's normal is the mean, by angle, of the faces around its position that meet its own face at no more than
/// `crease_degrees`. Returns how many given normals were of no use.
std::size_t complete_normals(Soup& soup, float crease_degrees);

}  // namespace sh::prt
