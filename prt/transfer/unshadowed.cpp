#include "prt/transfer/unshadowed.hpp"

#include <cstddef>
#include <numbers>

#include "generated/cpp/basis.hpp"
#include "generated/cpp/cap.hpp"
#include "generated/cpp/irradiance.hpp"
#include "generated/cpp/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

// (normals, bands^2): row(normal, numbers) for every normal.
template <class Row>
std::vector<float> for_normals(int degree, const std::vector<Eigen::Vector3f>& normals, const Row& row) {
  const std::size_t count = coefficient_count(degree);
  std::vector<float> transfer(normals.size() * count);
  at_degree(degree, [&](auto known) {
    for_vertices(normals.size(), [&](std::size_t v) { row(known, normals[v], transfer.data() + v * count); });
  });
  return transfer;
}

// The zonal coefficients of the visible hemisphere.
std::vector<float> hemisphere(int degree) {
  std::vector<double> zonal(degree + 1);
  at_degree(degree, [&](auto known) { sh::cap<known()>(1.0, zonal.data()); });
  return {zonal.begin(), zonal.end()};
}

}  // namespace

std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals) {
  return for_normals(degree, normals, [](auto known, const Eigen::Vector3f& n, float* row) {
    sh::basis<known()>(n.x(), n.y(), n.z(), row);
    sh::irradiance<known()>(row);
    as_array(row, coefficient_count(known())) *= std::numbers::inv_pi_v<float>;
  });
}

std::vector<float> unshadowed_transfer(const TransferShape& shape, const Mesh& mesh) {
  if (shape.meets == Meets::kNothing) return {};
  if (shape.meets == Meets::kDot) return unshadowed_transfer(shape.degree, mesh.normals);
  const std::vector<float> zonal = hemisphere(shape.function_degree());
  return for_normals(shape.function_degree(), mesh.geometric_normals,
                     [&](auto known, const Eigen::Vector3f& n, float* row) {
                       sh::zonal<known()>(zonal.data(), n.x(), n.y(), n.z(), row);
                     });
}

}  // namespace sh::prt
