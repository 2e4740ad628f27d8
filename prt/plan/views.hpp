// From where plans look at glossy surfaces. Exit radiance depends on the eye, which nobody declares; a plan takes it from
// anywhere. Each vertex is seen from kEyes directions above its horizon, the geometric normal, with the density of the
// cosine: that is how often an eye somewhere sees it in a pixel. They are fixed, and neighbors have different ones.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/runtime/glossy.hpp"

namespace sh::prt {

class Views {
 public:
  static constexpr std::size_t kEyes = 16;

  /// Of a vertex of `mesh`, where radiance of this degree reaches it.
  Views(const Mesh& mesh, std::size_t vertex, int degree);

  /// Exit radiance towards each eye, linear RGB, where `reaching` (3, bands^2) reaches the vertex.
  [[nodiscard]] std::array<Eigen::Vector3d, kEyes> radiance(const float* reaching) const;

  /// The unit direction from the vertex to an eye: a spiral in the unit disc [Vogel79] below the hemisphere, turned by
  /// another angle for each vertex.
  static Eigen::Vector3f to_eye(const Mesh& mesh, std::size_t vertex, std::size_t eye);

 private:
  std::array<Eigen::MatrixX3f, kEyes> lobes_;  // (bands^2, 3) each
};

/// The mean over the eyes of the square of exit radiance in the largest channel, for each vertex of `mesh`.
std::vector<double> seen_squares(const TransferredRadiance& reaching, const Mesh& mesh);

/// The largest exit radiance of a glossy mesh that nothing shadows, over all vertices, eyes and channels: the unit of errors.
double largest_glossy_radiance(const Mesh& mesh, const LightCoefficients& light);

/// The largest part of the light that a vertex reflects in any channel: 1 for BRDFs, else albedo and lobe together.
float largest_reflectance(const Mesh& mesh);

}  // namespace sh::prt
