#include "prt/transfer/unshadowed.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

// (normals, bands^2): zonal functions about the normals, factors_l Y_lm(n).
std::vector<float> about(const std::vector<Eigen::Vector3f>& normals, const std::vector<double>& factors) {
  const auto degree = static_cast<int>(factors.size()) - 1;
  const std::size_t count = coefficient_count(degree);
  std::vector<float> transfer(normals.size() * count);
  for_vertices(normals.size(), [&](std::size_t v) {
    zonal_about(
        degree, normals[v], [&](int l) { return factors[l]; }, transfer.data() + v * count);
  });
  return transfer;
}

std::vector<double> hemisphere_factors(int degree) {
  std::vector<double> factors(degree + 1);
  numeric::cap_zonal(degree, 1.0, factors.data());
  for (int l = 0; l <= degree; ++l) factors[l] *= std::sqrt(4.0 * std::numbers::pi / (2 * l + 1));
  return factors;
}

}  // namespace

std::vector<float> unshadowed_transfer(int degree, const std::vector<Eigen::Vector3f>& normals) {
  std::vector<double> factors;
  for (int l = 0; l <= degree; ++l) factors.push_back(numeric::clamped_cosine_factor<double>(l) / std::numbers::pi);
  return about(normals, factors);
}

std::vector<float> unshadowed_transfer(const TransferShape& shape, const Mesh& mesh) {
  if (shape.meets == Meets::kNothing) return {};
  if (shape.meets == Meets::kOperator) {
    return about(mesh.geometric_normals, hemisphere_factors(shape.function_degree()));
  }
  return unshadowed_transfer(shape.degree, mesh.normals);
}

}  // namespace sh::prt
