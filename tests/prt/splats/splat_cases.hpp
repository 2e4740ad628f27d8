// Splats, their colors and covariances in double precision, and PLY files of them: written from the formats'
// definitions, by nothing that prt/splats/ uses.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace sh::prt::test {

/// As the .ply files of 3D Gaussian splatting hold it.
struct Splat {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector4d rotation = Eigen::Vector4d::UnitX();  // w, x, y, z, of any length
  Eigen::Vector3d log_scale = Eigen::Vector3d::Zero();
  double opacity = 0.0;          // logit
  Eigen::MatrixXd coefficients;  // (3, bands^2), in the convention of the files
};

using Splats = std::vector<Splat>;

/// Single-precision numbers, the first splats extreme: flat, opaque, transparent, far away, black, long quaternions.
Splats random_splats(int count, int degree, unsigned seed);

/// 1/2 + sum c Y(direction), by the definition of the convention (numeric/identify/convention.hpp). Unit direction.
Eigen::Vector3d color_of(const Splat& splat, const Eigen::Vector3d& direction);
/// R S S^T R^T.
Eigen::Matrix3d covariance_of(const Splat& splat);

struct PlyText {
  std::string format = "binary_little_endian";
  std::string after_format = {};        // further lines
  std::vector<std::string> first = {};  // names of further properties, of type int; splat i has the value 7 i + k
  std::vector<std::string> last = {};
  std::string tail_header = {};  // after the properties
  std::string tail = {};         // after the data
  bool normals = true;
  bool doubles = false;
};

/// The bytes of a file.
std::string ply_of(const Splats& splats, const PlyText& text = {});

/// The splats of a binary little-endian file whose properties are all of 4 bytes.
Splats splats_of_ply(const std::string& bytes);

/// Rotations by name: none, near none, half and third turns, random ones.
struct NamedRotation {
  std::string name;
  Eigen::Matrix3d matrix;
};
std::vector<NamedRotation> rotations();

/// Random unit directions.
std::vector<Eigen::Vector3d> directions(int count, unsigned seed);

/// The largest difference between the color of `turned` towards M d and that of `splat` towards d, at 100 directions.
double color_difference(const Splat& splat, const Splat& turned, const Eigen::Matrix3d& matrix);

}  // namespace sh::prt::test
