// Chooses the studied vertices and their weights, and compares radiances on them.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "prt/study/study_setup.hpp"

namespace sh::prt {

namespace {

constexpr double kNearest = 0.1;  // of the camera's distance to its target; nearer vertices count as if there

// The area of every vertex over the squared distance to the camera.
std::vector<double> seen_areas(const Mesh& mesh, const Camera& camera) {
  std::vector<double> areas(mesh.positions.size(), 0.0);
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3d a = mesh.positions[face[0]].cast<double>();
    const Eigen::Vector3d b = mesh.positions[face[1]].cast<double>();
    const Eigen::Vector3d c = mesh.positions[face[2]].cast<double>();
    const double third = (b - a).cross(c - a).norm() / 6.0;
    for (const std::uint32_t v : face) areas[v] += third;
  }
  const Eigen::Vector3d eye = mesh.frame.local(camera.position);
  const double nearest = kNearest * (mesh.frame.local(camera.target) - eye).norm();
  for (std::size_t v = 0; v < areas.size(); ++v) {
    const double distance = (mesh.positions[v].cast<double>() - eye).norm();
    areas[v] /= std::max(distance, nearest) * std::max(distance, nearest);
  }
  return areas;
}

double radiance_unit(const StudiedVertices& vertices, const Radiances& reference) {
  double square = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) square += vertices.weight[i] * reference[i].squaredNorm() / 3.0;
  return square > 0.0 ? std::sqrt(square) : 1.0;
}

}  // namespace

StudiedVertices choose_vertices(const Mesh& mesh, const Camera& camera, std::size_t count) {
  const std::vector<double> areas = seen_areas(mesh, camera);
  StudiedVertices chosen;
  chosen.step = std::max<std::size_t>(1, (areas.size() + count / 2) / count);
  for (std::size_t v = 0; v < areas.size(); v += chosen.step) {
    chosen.index.push_back(static_cast<std::uint32_t>(v));
    chosen.weight.push_back(areas[v]);
  }
  const double sum = std::accumulate(chosen.weight.begin(), chosen.weight.end(), 0.0);
  for (double& weight : chosen.weight) weight /= sum;
  return chosen;
}

RadianceError radiance_error(const StudiedVertices& vertices, const Radiances& values, const Radiances& reference) {
  double square = 0.0;
  RadianceError error;
  error.largest = -1.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Eigen::Vector3d difference = values[i] - reference[i];
    square += vertices.weight[i] * difference.squaredNorm() / 3.0;
    if (const double largest = difference.cwiseAbs().maxCoeff(); largest > error.largest) {
      error.largest = largest;
      error.worst_vertex = vertices.index[i];
    }
  }
  const double unit = radiance_unit(vertices, reference);
  error.rms = std::sqrt(square) / unit;
  error.largest = std::max(error.largest, 0.0) / unit;
  return error;
}

VertexErrors vertex_errors(const Mesh& mesh, const Camera& camera, const Radiances& values,
                           const Radiances& reference) {
  const std::size_t count = mesh.positions.size();
  if (values.size() != count || reference.size() != count) {
    throw std::invalid_argument("errors of vertices: expected one radiance a vertex");
  }
  const StudiedVertices all = choose_vertices(mesh, camera, count);
  VertexErrors errors{{}, radiance_error(all, values, reference)};
  const double unit = radiance_unit(all, reference);
  for (std::size_t v = 0; v < count; ++v) {
    errors.relative.push_back(static_cast<float>((values[v] - reference[v]).cwiseAbs().maxCoeff() / unit));
  }
  return errors;
}

}  // namespace sh::prt
