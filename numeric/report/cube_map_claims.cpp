// Claims on cube maps as quadrature rules: source_claims.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/oracle/basis.hpp"
#include "numeric/report/projection_convergence.hpp"
#include "numeric/report/source_claims.hpp"
#include "numeric/sampling/eigenvalues.hpp"
#include "numeric/sampling/sphere_nodes.hpp"

namespace sh::numeric {
namespace {

constexpr int kDegree = 5;  // six bands
constexpr int kFunctions = coefficient_count(kDegree);
constexpr double kPercent = 100;

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
                              fmt::format("E = sum ds y y^T - 1, ds at the texel's centre, not scaled; with exact "
                                          "solid angles {:.2g} %",
                                          kPercent * with_exact)));
  };
  add(first, e.mean_squared, exact.mean_squared);
  add(first + 1, e.worst_squared, exact.worst_squared);
}

SourceClaim total_area() {
  return claim_of("GP-38", 0, 4 * std::numbers::pi * (1 + error_of(128, kWeights[0]).area),
                  "exact solid angles; the sum of the estimates at the centres is off by 1.5e-5 of it");
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
                  "centre",
                  ratio > 1);
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

}  // namespace sh::numeric
