// The building blocks of the primitives: quadrilaterals, surfaces of revolution, extruded outlines.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// Adds two faces with the flat normal; the corners are counterclockwise as seen from outside.
void add_quad(Soup& soup, const std::array<Eigen::Vector3f, 4>& corners);

/// A point of a curve that turns about the z axis, with the normal there; unit length.
struct RingPoint {
  float radius;
  float z;
  float normal_radius;
  float normal_z;
};

/// A smooth part of the curve, t = 0..1 in `steps`. The outside lies to its right in the (radius, z) plane, so that the
/// curve runs upwards on the outer side.
struct Curve {
  int steps;
  std::function<RingPoint(float)> at;
};
Soup surface_of_revolution(int segments, const std::vector<Curve>& curves);

/// An outline in the xz plane, counterclockwise with x to the right and z up, and triangles that cover it. An edge
/// normal of zero stands for the flat normal; `edge_normals` may be empty.
struct Profile {
  std::vector<Eigen::Vector2f> points;
  std::vector<std::array<Eigen::Vector2f, 2>> edge_normals;  // at the start and end of edge i, points i to i+1
  std::vector<Face> triangles;
};
/// The solid over the outline from y = -1/2 to y = 1/2.
Soup extrude(const Profile& profile);

}  // namespace sh::prt
