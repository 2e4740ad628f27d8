// Shapes made in code, and their building blocks: quadrilaterals, surfaces of revolution, extruded outlines. Each shape
// fits the unit cube centered at the origin, z up; faces are counterclockwise as seen from outside. Curved parts have
// smooth normals, flat parts have flat normals.
#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "prt/mesh/soup.hpp"

namespace sh::prt {

/// The names that make_primitive accepts: arch box cone cylinder hills plane ring sphere stairs torus wing.
std::vector<std::string_view> primitive_names();

/// The shape with linear RGB albedo 0.5, ready for transform() and weld(). `segments` is the number of sides of a full
/// turn of a curved shape, at least 3. Throws std::invalid_argument for an unknown name.
Soup make_primitive(std::string_view name, int segments = 48);

/// Adds two faces with the flat normal; the corners are counterclockwise as seen from outside. Their texture coordinates
/// are (0, 0), (1, 0), (1, 1), (0, 1).
void add_quad(Soup& soup, const std::array<Eigen::Vector3f, 4>& corners);

/// A point of a curve that turns about the z axis, with the normal there; unit length.
struct RingPoint {
  float radius;
  float z;
  float normal_radius;
  float normal_z;
};

/// The points of a smooth part of the curve. The outside lies to its right in the (radius, z) plane, so that the curve
/// runs upwards on the outer side.
using Curve = std::vector<RingPoint>;
/// Texture coordinates: u is the part of the turn, v the part of the points of a curve.
Soup surface_of_revolution(int segments, const std::vector<Curve>& curves);

/// An outline in the xz plane, counterclockwise with x to the right and z up, and triangles that cover it. An edge
/// normal of zero stands for the flat normal; `edge_normals` may be empty.
struct Profile {
  std::vector<Eigen::Vector2f> points;
  std::vector<std::array<Eigen::Vector2f, 2>> edge_normals;  // at the start and end of edge i, points i to i+1
  std::vector<Face> triangles;
};
/// The solid over the outline from y = -1/2 to y = 1/2, without texture coordinates.
Soup extrude(const Profile& profile);

/// A square of bumpy ground, with so many steps along each side, and a closed, thin wing with its nose towards +x.
Soup make_hills(int segments);
Soup make_wing(int segments);

}  // namespace sh::prt
