#include "prt/bake/glossy_exit.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include "prt/arrays.hpp"
#include "prt/bake/gray.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/material/lobe.hpp"
#include "prt/material/reflected.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/rays/row_sums.hpp"
#include "prt/transfer/visibility.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kRaysAtOnce = 64;
constexpr std::size_t kMostRow = padded_row(3 * coefficient_count(kHighestProduct));

using Weights = std::array<float, coefficient_count(kHighestProduct)>;

template <class Factor>
Weights weights_about(int degree, const Eigen::Vector3f& direction, const Factor& factor) {
  Weights values;
  zonal_about(degree, direction, factor, values.data());
  return values;
}

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

TransferShape glossy_matrix_shape(const Mesh& mesh, int degree) {
  TransferShape shape = kGlossyInterreflected.indirect(degree);
  if (is_gray(mesh.albedo) && is_gray(mesh.specular) && is_gray(mesh.brdfs)) shape.channels = 1;
  return shape;
}

MatrixTable::MatrixTable(const Mesh& mesh, int the_degree)
    : degree(the_degree),
      count(coefficient_count(degree)),
      channels(glossy_matrix_shape(mesh, degree).channels),
      row(padded_row(channels * count)),
      size(count * row),
      values(mesh.positions.size() * size, 0.0F) {}

void MatrixTable::take_direct(const Rows& visibility) {
  const std::size_t vertices = values.size() / size;
  std::vector<float> products(vertices * 3 * count);
  for (std::size_t first = 0; first < count; first += 3) {
    const std::size_t some = std::min<std::size_t>(3, count - first);
    std::vector<float> lights(3 * count, 0.0F);
    for (std::size_t k = 0; k < some; ++k) lights[k * count + first + k] = 1.0F;
    times_visibility(degree, visibility, prepared_light(degree, lights.data()), products.data());
    for_vertices(vertices, [&](std::size_t v) {
      const Eigen::Map<Eigen::MatrixXf> columns(&products[v * 3 * count], Eigen::Index(count), Eigen::Index(some));
      Eigen::Map<Matrix> matrix(of(v), Eigen::Index(count), Eigen::Index(row));
      for (std::size_t c = 0; c < channels; ++c) matrix.middleCols(c * count + first, some) = columns;
    });
  }
}

void MatrixTable::add(const std::vector<float>& matrices, const TransferShape& shape, float part) {
  for_vertices(values.size() / size, [&](std::size_t v) {
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t i = 0; i < count; ++i) {
        const float* from = matrices.data() + v * shape.length() + c * shape.count() + i * shape.columns();
        as_array(of(v) + i * row + c * count, count) += part * as_array(from, count);
      }
    }
  });
}

void MatrixTable::add(const MatrixTable& other, float part) {
  for_vertices(values.size() / size,
               [&](std::size_t v) { as_array(of(v), size) += part * as_array(other.of(v), size); });
}

void MatrixTable::copy(const float* matrix, const TransferShape& shape, float* out) const {
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < count; ++i) {
      std::copy_n(matrix + i * row + c * count, count, out + c * shape.count() + i * shape.columns());
    }
  }
}

std::vector<float> MatrixTable::copies(const TransferShape& shape) const {
  const std::size_t vertices = values.size() / size;
  std::vector<float> all(vertices * shape.length(), 0.0F);
  for_vertices(vertices, [&](std::size_t v) { copy(of(v), shape, all.data() + v * shape.length()); });
  return all;
}

std::vector<BlockedAt> rays_to_fronts(Gatherer& gatherer, const Mesh& mesh, std::size_t vertex) {
  gatherer.gather(vertex);
  std::vector<BlockedAt> rays;
  for (const BlockedRay& ray : gatherer.closest_hits()) {
    if (ray.hit.face == Hit::kNothing) continue;
    if (face_normal(mesh.positions, mesh.faces[ray.hit.face]).dot(ray.direction) >= 0.0F) continue;
    rays.push_back({ray.direction, ray.hit});
  }
  return rays;
}

GlossyExit::GlossyExit(const Mesh& mesh, const MatrixTable& reaching)
    : mesh_(mesh),
      reaching_(reaching),
      in_order_(std::max(kRaysAtOnce, reaching.count)),
      diffuse_(mesh.positions.size() * reaching.row, 0.0F) {
  for (const float exponent : mesh.exponent) {
    for (int l = 0; l <= reaching.degree; ++l) {
      lobes_.push_back(static_cast<float>(phong_factor(l, static_cast<double>(exponent))));
    }
  }
  std::iota(in_order_.begin(), in_order_.end(), 0U);
  for_vertices(mesh.positions.size(), [&](std::size_t v) {
    const Weights cosine = weights_about(reaching.degree, mesh.normals[v], [](int l) { return phong_factor(l, 1.0); });
    add_weighed(cosine.data(), v, mesh.albedo[v], diffuse_.data() + v * reaching.row);
  });
}

// row (reaching.row) += weights times the matrix of a vertex, each channel times its part of the color.
void GlossyExit::add_weighed(const float* weights, std::size_t vertex, const Eigen::Vector3f& color, float* row) const {
  const std::size_t count = reaching_.count;
  alignas(64) std::array<float, kMostRow> sums;
  sum_rows(reaching_.of(vertex), reaching_.row, in_order_.data(), count, weights, sums.data());
  for (std::size_t c = 0; c < reaching_.channels; ++c) {
    as_array(row + c * count, count) += color[Eigen::Index(c)] * as_array(sums.data() + c * count, count);
  }
}

// Adds what leaves a hit against the ray to `row`.
void GlossyExit::add_exit(const BlockedAt& ray, float* row) const {
  const Face& face = mesh_.faces[ray.hit.face];
  const std::array<float, 3> parts = ray.hit.parts();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t q = face[k];
    if (const BrdfTable brdf = mesh_.brdf_of(q)) {
      for_reflected_lobes(
          brdf, mesh_.albedo[q], reaching_.degree, mesh_.normals[q], -ray.direction,
          [&](const Eigen::Vector3f& color, const float* weights) { add_weighed(weights, q, parts[k] * color, row); });
      continue;
    }
    as_array(row, reaching_.row) += parts[k] * as_array(&diffuse_[q * reaching_.row], reaching_.row);
    if (mesh_.specular.empty() || mesh_.specular[q].isZero(0.0F)) continue;
    const Eigen::Vector3f about = mirrored(ray.direction, mesh_.normals[q]);
    const float* factors = &lobes_[q * (reaching_.degree + 1)];
    const Weights lobe = weights_about(reaching_.degree, about, [factors](int l) { return factors[l]; });
    add_weighed(lobe.data(), q, parts[k] * mesh_.specular[q], row);
  }
}

void GlossyExit::collect(const std::vector<BlockedAt>& rays, std::size_t directions, float* out) const {
  const auto weight = static_cast<float>(4.0 * std::numbers::pi / static_cast<double>(directions));
  const std::size_t count = reaching_.count;
  const std::size_t row = reaching_.row;
  std::fill_n(out, reaching_.size, 0.0F);
  Eigen::Matrix<float, Eigen::Dynamic, kRaysAtOnce, Eigen::RowMajor> arriving(count, kRaysAtOnce);
  std::vector<float> leaving(kRaysAtOnce * row);
  std::vector<float> part(row);
  for (std::size_t first = 0; first < rays.size(); first += kRaysAtOnce) {
    const std::size_t some = std::min(kRaysAtOnce, rays.size() - first);
    std::fill(leaving.begin(), leaving.end(), 0.0F);
    for (std::size_t j = 0; j < some; ++j) {
      const BlockedAt& ray = rays[first + j];
      const Weights basis = weights_about(reaching_.degree, ray.direction, [&](int) { return weight; });
      arriving.col(Eigen::Index(j)) = as_array(basis.data(), count);
      add_exit(ray, leaving.data() + j * row);
    }
    for (std::size_t i = 0; i < count; ++i) {
      sum_rows(leaving.data(), row, in_order_.data(), some, &arriving(Eigen::Index(i), 0), part.data());
      as_array(out + i * row, row) += as_array(part);
    }
  }
}

}  // namespace sh::prt
