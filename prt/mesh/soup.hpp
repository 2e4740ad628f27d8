// Triangles from a file or a generator before they are welded into a Mesh, and the checks that they must pass.
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

/// Vertices may repeat. `normals` and `albedo` are as long as `positions`; `normals` may be empty, then they are
/// computed.
struct Soup {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector3f> albedo;  // linear RGB
  std::vector<Face> faces;              // counterclockwise as seen from outside
  std::vector<std::uint32_t> source;    // vertex of the file each vertex came from; empty: itself
  std::vector<std::uint32_t> finish;    // (faces) into `finishes`; empty: every face has the first
  std::vector<Finish> finishes{Finish{}};

  [[nodiscard]] std::uint32_t finish_of(std::size_t face) const { return finish.empty() ? 0 : finish[face]; }
};

/// Maps points by `map` and normals by its inverse transpose. A map that mirrors also turns the faces around.
void transform(Soup& soup, const Eigen::Affine3f& map);

/// Throws std::runtime_error, one line that begins with `name`, if there are no vertices or no faces, if a face names a
/// missing vertex, or if a coordinate is NaN or infinite.
void check(const Soup& soup, const std::string& name);

/// Drops faces without area (to rounding); returns how many.
std::size_t drop_faces_without_area(Soup& soup);

/// Turns all faces and normals around, so that the inside becomes the outside.
void turn_inside_out(Soup& soup);

/// Turns each face around if the sum of its corner normals points to its back; returns how many. Precondition: the soup
/// has normals and passed check().
std::size_t turn_faces_to_normals(Soup& soup);

/// Computes normals that are missing, zero or not finite from the faces. A soup without any normals gets one vertex per
/// face corner. The normal of a corner is the mean, weighted by angle, of the faces around its position that meet its
/// own face at no more than `crease_degrees`. Returns how many given normals were unusable.
std::size_t complete_normals(Soup& soup, float crease_degrees);

}  // namespace sh::prt
