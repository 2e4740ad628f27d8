#include "prt/plan/views.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prt/angles.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

Eigen::Vector3f Views::to_eye(const Mesh& mesh, std::size_t vertex, std::size_t eye) {
  constexpr double kGolden = 1.0 / std::numbers::phi;
  const double square = (static_cast<double>(eye) + 0.5) / static_cast<double>(kEyes);
  const double turn = kGolden * static_cast<double>(eye) + std::numbers::sqrt2 * static_cast<double>(vertex);
  const double angle = 2.0 * std::numbers::pi * (turn - std::floor(turn));
  const double radius = std::sqrt(square);
  const Eigen::Vector3d local(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0 - square));
  return (frame_about(mesh.geometric_normals[vertex]) * local.cast<float>()).normalized();
}

Views::Views(const Mesh& mesh, std::size_t vertex, int degree) {
  const auto count = static_cast<Eigen::Index>(coefficient_count(degree));
  const Material material = material_of(mesh, vertex, mesh.albedo[vertex]);
  for (std::size_t eye = 0; eye < kEyes; ++eye) {
    lobes_[eye].setZero(count, 3);
    for_exit_lobes(material, degree, mesh.normals[vertex], to_eye(mesh, vertex, eye),
                   [&](const Eigen::Vector3f& color, const float* lobe) {
                     lobes_[eye] += Eigen::Map<const Eigen::VectorXf>(lobe, count) * color.transpose();
                   });
  }
}

std::array<Eigen::Vector3d, Views::kEyes> Views::radiance(const float* reaching) const {
  std::array<Eigen::Vector3d, kEyes> radiance;
  const Eigen::Map<const Eigen::MatrixX3f> light(reaching, lobes_[0].rows(), 3);
  for (std::size_t eye = 0; eye < kEyes; ++eye) {
    radiance[eye] = lobes_[eye].cwiseProduct(light).colwise().sum().cast<double>();
  }
  return radiance;
}

std::vector<double> seen_squares(const TransferredRadiance& reaching, const Mesh& mesh) {
  std::vector<double> squares(mesh.positions.size(), 0.0);
  for_vertices(squares.size(), [&](std::size_t v) {
    for (const Eigen::Vector3d& seen : Views(mesh, v, reaching.degree()).radiance(reaching.at(v))) {
      squares[v] += std::pow(seen.cwiseAbs().maxCoeff(), 2) / static_cast<double>(Views::kEyes);
    }
  });
  return squares;
}

double largest_glossy_radiance(const Mesh& mesh, const LightCoefficients& light) {
  const std::vector<float> reaching(light.values.begin(), light.values.end());
  std::vector<double> largest(mesh.positions.size(), 0.0);
  for_vertices(largest.size(), [&](std::size_t v) {
    for (const Eigen::Vector3d& seen : Views(mesh, v, light.degree).radiance(reaching.data())) {
      largest[v] = std::max(largest[v], seen.maxCoeff());
    }
  });
  return *std::max_element(largest.begin(), largest.end());
}

float largest_reflectance(const Mesh& mesh) {
  float largest = 0.0F;
  for (std::size_t v = 0; v < mesh.albedo.size(); ++v) {
    const Material material = material_of(mesh, v, mesh.albedo[v]);
    largest = std::max(largest, material.brdf ? 1.0F : (material.albedo + material.specular).maxCoeff());
  }
  return largest;
}

}  // namespace sh::prt
