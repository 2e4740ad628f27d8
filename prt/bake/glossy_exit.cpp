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
#include "prt/large_pages.hpp"
#include "prt/material/lobe.hpp"
#include "prt/material/reflected.hpp"
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
      size(count * row) {
  renew_on_large_pages(values, mesh.positions.size() * size);
}

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

std::vector<BlockedAt> rays_to_fronts(Gatherer& gatherer, std::size_t vertex) {
  gatherer.gather(vertex);
  std::vector<BlockedAt> rays;
  for (const BlockedRay& ray : gatherer.closest_hits()) {
    if (ray.hit.face == Hit::kNothing) continue;
    if (ray.hit.from_behind) continue;
    rays.push_back({ray.direction, ray.hit});
  }
  return rays;
}

GlossyExit::GlossyExit(const Mesh& mesh, MatrixTable& reaching)
    : mesh_(mesh),
      matrices_(reaching),
      in_order_(std::max(kRaysAtOnce, reaching.count)),
      diffuse_(mesh.positions.size() * reaching.row, 0.0F) {
  std::iota(in_order_.begin(), in_order_.end(), 0U);
  for_vertices(mesh.positions.size(), [&](std::size_t v) {
    const Weights cosine = weights_about(reaching.degree, mesh.normals[v], [](int l) { return phong_factor(l, 1.0); });
    add_weighed(cosine.data(), v, mesh.albedo[v], diffuse_.data() + v * reaching.row);
    if (!mesh.brdf_of(v) && has_lobe(v)) turn(v);
  });
}

// row (matrices_.row) += weights times the matrix of a vertex, each channel times its part of the color.
void GlossyExit::add_weighed(const float* weights, std::size_t vertex, const Eigen::Vector3f& color, float* row) const {
  const std::size_t count = matrices_.count;
  alignas(64) std::array<float, kMostRow> sums;
  sum_rows(matrices_.of(vertex), matrices_.row, in_order_.data(), count, weights, sums.data());
  for (std::size_t c = 0; c < matrices_.channels; ++c) {
    as_array(row + c * count, count) += color[Eigen::Index(c)] * as_array(sums.data() + c * count, count);
  }
}

// F -> U
void GlossyExit::turn(std::size_t vertex) {
  const std::size_t count = matrices_.count;
  const std::size_t row = matrices_.row;
  const int degree = matrices_.degree;
  const Eigen::Vector3f& normal = mesh_.normals[vertex];
  const Eigen::Matrix3f half_turn = 2.0F * normal * normal.transpose() - Eigen::Matrix3f::Identity();  // -H
  float* const matrix = matrices_.of(vertex);
  const std::vector<float> reaching(matrix, matrix + matrices_.size);
  for (int l = 0; l <= degree; ++l) {
    const auto size = phong_factor(l, static_cast<double>(mesh_.exponent[vertex]));
    const auto factor = static_cast<float>(l % 2 == 0 ? size : -size);
    const std::size_t first = coefficient_count(l - 1);
    for (std::size_t j = first; j < coefficient_count(l); ++j) {
      Weights turned{};
      turned[j] = factor;
      rotate_function(degree, half_turn, turned.data(), turned.data());
      float* const out = matrix + j * row;
      sum_rows(&reaching[first * row], row, in_order_.data(), 2 * l + 1, &turned[first], out);
      for (std::size_t c = 0; c < matrices_.channels; ++c) {
        as_array(out + c * count, count) *= mesh_.specular[vertex][Eigen::Index(c)];
      }
    }
  }
  constexpr float kInverseY00 = 2.0F / std::numbers::inv_sqrtpi_v<float>;
  as_array(matrix, row) += kInverseY00 * as_array(&diffuse_[vertex * row], row);
}

// Adds what leaves a hit against the ray, whose direction has these basis values, to `row`.
void GlossyExit::add_exit(const BlockedAt& ray, const float* basis, float* row) const {
  const std::size_t count = matrices_.count;
  const Face& face = mesh_.faces[ray.hit.face];
  const std::array<float, 3> parts = ray.hit.parts();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t q = face[k];
    if (const BrdfTable brdf = mesh_.brdf_of(q)) {
      for_reflected_lobes(
          brdf, mesh_.albedo[q], matrices_.degree, mesh_.normals[q], -ray.direction,
          [&](const Eigen::Vector3f& color, const float* lobe) { add_weighed(lobe, q, parts[k] * color, row); });
    } else if (has_lobe(q)) {
      alignas(64) std::array<float, kMostRow> sums;
      sum_rows(matrices_.of(q), matrices_.row, in_order_.data(), count, basis, sums.data());
      as_array(row, matrices_.row) += parts[k] * as_array(sums.data(), matrices_.row);
    } else {
      as_array(row, matrices_.row) += parts[k] * as_array(&diffuse_[q * matrices_.row], matrices_.row);
    }
  }
}

void GlossyExit::collect(const std::vector<BlockedAt>& rays, std::size_t directions, float* out) const {
  const auto weight = static_cast<float>(4.0 * std::numbers::pi / static_cast<double>(directions));
  const std::size_t count = matrices_.count;
  const std::size_t row = matrices_.row;
  std::fill_n(out, matrices_.size, 0.0F);
  Eigen::Matrix<float, Eigen::Dynamic, kRaysAtOnce, Eigen::RowMajor> arriving(count, kRaysAtOnce);
  std::vector<float> leaving(kRaysAtOnce * row);
  std::vector<float> part(row);
  Weights basis;
  for (std::size_t first = 0; first < rays.size(); first += kRaysAtOnce) {
    const std::size_t some = std::min(kRaysAtOnce, rays.size() - first);
    std::fill(leaving.begin(), leaving.end(), 0.0F);
    for (std::size_t j = 0; j < some; ++j) {
      const BlockedAt& ray = rays[first + j];
      evaluate_basis(matrices_.degree, ray.direction.x(), ray.direction.y(), ray.direction.z(), basis.data());
      arriving.col(Eigen::Index(j)) = weight * as_array(basis.data(), count);
      add_exit(ray, basis.data(), leaving.data() + j * row);
    }
    for (std::size_t i = 0; i < count; ++i) {
      sum_rows(leaving.data(), row, in_order_.data(), some, &arriving(Eigen::Index(i), 0), part.data());
      as_array(out + i * row, row) += as_array(part);
    }
  }
}

}  // namespace sh::prt
