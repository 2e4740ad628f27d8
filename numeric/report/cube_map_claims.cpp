// Claims on cube maps, as quadrature rules and as pictures that are read between their texels: source_claims.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "numeric/report/projection_convergence.hpp"
#include "numeric/report/source_claims.hpp"
#include "numeric/sampling/eigenvalues.hpp"
#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::numeric {
namespace {

constexpr int kDegree = 5;  // six bands
constexpr int kFunctions = coefficient_count(kDegree);
constexpr double kPercent = 100;
using Values = Eigen::Matrix<double, kFunctions, 1>;
using Matrix = Eigen::Matrix<double, kFunctions, kFunctions>;

struct NamedWeight {
  const char* name;
  TexelWeight weight;
};
constexpr std::array<NamedWeight, 3> kWeights{{{"exact", TexelWeight::kExact},
                                               {"differential", TexelWeight::kDifferential},
                                               {"differential scaled", TexelWeight::kDifferentialScaled}}};

CubeMapError error_of(int size, const NamedWeight& kind) {
  const auto nodes = cube_map_nodes(size, kind.weight);
  const auto exact = cube_map_nodes(size, TexelWeight::kExact);
  CubeMapError error{size, kind.name, 0, 0, 0, 0};
  Eigen::MatrixXd e = -Eigen::MatrixXd::Identity(kFunctions, kFunctions);
  Eigen::VectorXd y(kFunctions);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    basis(kDegree, nodes[i].x, nodes[i].y, nodes[i].z, y.data());
    e += nodes[i].weight * y * y.transpose();
    error.worst_texel = std::max(error.worst_texel, std::abs(nodes[i].weight / exact[i].weight - 1));
    sum += nodes[i].weight;
  }
  error.area = sum / (4 * std::numbers::pi) - 1;
  error.mean_squared = e.squaredNorm() / kFunctions;
  const double worst = symmetric_eigenvalues(e).cwiseAbs().maxCoeff();
  error.worst_squared = worst * worst;
  return error;
}

// |E|^2 on average and at worst, in percent, of `size` x `size` images: the readings from `first` on of S-32.
void add_band_limited(std::vector<SourceClaim>& claims, int first, int size) {
  const CubeMapError e = error_of(size, kWeights[1]);
  const CubeMapError exact = error_of(size, kWeights[0]);
  const auto add = [&](int reading, double measured, double with_exact) {
    claims.push_back(claim_of("S-32", reading, kPercent * measured,
                              fmt::format("E = sum ds y y^T - 1, ds at the texel's center, not scaled; with exact "
                                          "solid angles {:.2g} %",
                                          kPercent * with_exact)));
  };
  add(first, e.mean_squared, exact.mean_squared);
  add(first + 1, e.worst_squared, exact.worst_squared);
}

SourceClaim total_area() {
  return claim_of("GP-38", 0, 4 * std::numbers::pi * (1 + error_of(128, kWeights[0]).area),
                  "exact solid angles; the sum of the estimates at the centers is off by 1.5e-5 of it");
}

// Errors of the projection of the smooth test function with six 32 x 32 images.
SourceClaim estimate_against_exact() {
  const TestFunction& smooth = test_functions()[1];
  const auto error = [&](const char* rule) {
    return converge(sphere_rule_named(rule), smooth, {6 * 32 * 32}, 1).points[0].error_max;
  };
  const double ratio = error("cube_map_differential") / error("cube_map");
  return claim_of("GP-36", 0, ratio,
                  "six 32 x 32 images, estimate scaled to 4 pi; its errors cancel part of those of sampling at the "
                  "center",
                  ratio > 1);
}

Values basis_on_face(std::size_t face, double u, double v) {
  const double scale = (face < 3 ? 1 : -1) / std::sqrt(1 + u * u + v * v);
  std::array<double, 3> d{};
  d[face % 3] = scale;
  d[(face + 1) % 3] = u * scale;
  d[(face + 2) % 3] = v * scale;
  Values y;
  basis(kDegree, d[0], d[1], d[2], y.data());
  return y;
}

// The basis at the centers of the texels of a face, read bilinearly; beyond the last center its value goes on.
class Image {
 public:
  Image(std::size_t face, int size) : size_(size) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        texels_.push_back(basis_on_face(face, (2.0 * column + 1) / size - 1, (2.0 * row + 1) / size - 1));
      }
    }
  }

  [[nodiscard]] Values at(double u, double v) const {
    const double column = 0.5 * (u + 1) * size_ - 0.5;
    const double row = 0.5 * (v + 1) * size_ - 0.5;
    const double a = column - std::floor(column);
    const double b = row - std::floor(row);
    const auto left = static_cast<int>(std::floor(column));
    const auto low = static_cast<int>(std::floor(row));
    return (1 - b) * ((1 - a) * texel(left, low) + a * texel(left + 1, low)) +
           b * ((1 - a) * texel(left, low + 1) + a * texel(left + 1, low + 1));
  }

 private:
  [[nodiscard]] const Values& texel(int column, int row) const {
    const int place = std::clamp(row, 0, size_ - 1) * size_ + std::clamp(column, 0, size_ - 1);
    return texels_[place];
  }
  int size_;
  std::vector<Values> texels_;
};

// Adds INT e e^T over a cell of half a texel, in which the image is smooth; e = the value read from the image less the
// basis itself.
void add_cell(Matrix& sum, const Image& image, std::size_t face, double u0, double v0, double width) {
  static const auto kRule = gauss_legendre<double>(3);
  const double half = 0.5 * width;
  for (std::size_t i = 0; i < kRule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < kRule.nodes.size(); ++j) {
      const double u = u0 + half * (1 + kRule.nodes[i]);
      const double v = v0 + half * (1 + kRule.nodes[j]);
      const double square = 1 + u * u + v * v;
      const double weight = kRule.weights[i] * kRule.weights[j] * half * half / (square * std::sqrt(square));
      const Values e = image.at(u, v) - basis_on_face(face, u, v);
      sum += weight * e * e.transpose();
    }
  }
}

}  // namespace

std::vector<CubeMapError> cube_map_errors(const std::vector<int>& sizes) {
  std::vector<CubeMapError> errors;
  for (const int size : sizes) {
    for (const NamedWeight& weight : kWeights) errors.push_back(error_of(size, weight));
  }
  return errors;
}

std::vector<SourceClaim> cube_map_claims() {
  std::vector<SourceClaim> claims;
  add_band_limited(claims, 0, 4);
  add_band_limited(claims, 2, 8);
  claims.push_back(total_area());
  claims.push_back(estimate_against_exact());
  return claims;
}

BilinearError bilinear_error(int size) {
  Matrix sum = Matrix::Zero();
  const double width = 1.0 / size;
  for (std::size_t face = 0; face < 6; ++face) {
    const Image image(face, size);
    for (int row = 0; row < 2 * size; ++row) {
      for (int column = 0; column < 2 * size; ++column) {
        add_cell(sum, image, face, column * width - 1, row * width - 1, width);
      }
    }
  }
  return {sum.trace() / kFunctions, symmetric_eigenvalues(sum).maxCoeff()};
}

std::vector<SourceClaim> bilinear_claims() {
  const std::string how =
      "INT (image read between texels - signal)^2; it falls by 12 with twice the edge, the printed numbers by 4: "
      "theirs "
      "are those of 8, 11 and 16 texels";
  std::vector<SourceClaim> claims;
  for (const int size : {8, 16, 32}) {
    const BilinearError error = bilinear_error(size);
    for (const double squared : {error.mean_squared, error.worst_squared}) {
      claims.push_back(claim_of("S-33", static_cast<int>(claims.size()), 100 * squared, how));
    }
  }
  return claims;
}

}  // namespace sh::numeric
