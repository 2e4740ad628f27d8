#include "prt/runtime/sharp_layer.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "generated/cpp/evaluate.hpp"
#include "numeric/oracle/legendre_rings.hpp"
#include "numeric/oracle/quadrature.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/material/lobe.hpp"

namespace sh::prt {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kOrders = SharpLayer::kHighest + 1;

// Analysis: fine enough that a sun does not fall between the nodes.
constexpr int kFineRings = 512;
constexpr int kFineAround = 1024;
// Synthesis: four nodes for each wave of the highest band.
constexpr int kRings = 256;
constexpr int kAround = 512;

// Rings of equidistant azimuths 2 pi (j + 1/2) / around.
struct Grid {
  std::vector<double> z, sine;  // of the rings
  Eigen::MatrixXd waves;        // (around, 2 orders): cosine and sine of m times the azimuth
  numeric::LegendreRings legendre;

  Grid(const std::vector<double>& heights, int around)
      : z(heights), sine(sines(heights)), waves(around, 2 * kOrders), legendre(SharpLayer::kHighest, z, sine) {
    for (int j = 0; j < around; ++j) {
      for (int m = 0; m < kOrders; ++m) {
        const double angle = 2.0 * kPi * m * (j + 0.5) / around;
        waves(j, 2 * m) = std::cos(angle);
        waves(j, 2 * m + 1) = std::sin(angle);
      }
    }
  }
  static std::vector<double> sines(const std::vector<double>& heights) {
    std::vector<double> all;
    for (const double height : heights) all.push_back(std::sqrt((1.0 - height) * (1.0 + height)));
    return all;
  }
};

Grid grid_of_map() {
  std::vector<double> heights;
  for (int i = 0; i < kRings; ++i) heights.push_back(std::cos(kPi * (i + 0.5) / kRings));
  return {heights, kAround};
}

// One channel of a function: (rings, around) values, or for every order (kHighest - m + 1, 2) coefficients.
using Values = Eigen::MatrixXd;
using Coefficients = std::vector<std::vector<double>>;

Coefficients analyzed(const Grid& grid, const std::vector<double>& weights, const Values& values) {
  const Eigen::VectorXd weight =
      2.0 * kPi / static_cast<double>(values.cols()) * Eigen::VectorXd::Map(weights.data(), values.rows());
  const Eigen::MatrixXd waves = weight.asDiagonal() * (values * grid.waves);
  Coefficients coefficients(kOrders);
  in_parallel(0, kOrders, [&](int m) {
    const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> of_order =
        (m == 0 ? 1.0 : 2.0) * waves.middleCols<2>(2 * m);
    coefficients[m].resize(static_cast<std::size_t>(2 * (kOrders - m)));
    grid.legendre.analysis(SharpLayer::kHighest, m, {of_order.data(), static_cast<std::size_t>(of_order.size())},
                           coefficients[m]);
  });
  return coefficients;
}

// The bands above `degree`, times the factors of the lobe.
Values synthesized(const Grid& grid, const Coefficients& coefficients, int degree, float exponent) {
  Eigen::MatrixXd waves(grid.z.size(), 2 * kOrders);
  in_parallel(0, kOrders, [&](int m) {
    std::vector<double> scaled = coefficients[m];
    for (int l = m; l < kOrders; ++l) {
      const double factor = l > degree ? phong_factor(l, static_cast<double>(exponent)) : 0.0;
      scaled[static_cast<std::size_t>(2 * (l - m))] *= factor;
      scaled[static_cast<std::size_t>(2 * (l - m) + 1)] *= factor;
    }
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> of_order(waves.rows(), 2);
    grid.legendre.synthesis(SharpLayer::kHighest, m, scaled,
                            {of_order.data(), static_cast<std::size_t>(of_order.size())});
    waves.middleCols<2>(2 * m) = of_order;
  });
  return waves * grid.waves.transpose();
}

// Red, green and blue.
std::array<Values, 3> sampled(const Grid& grid, const SkyRadiance& sky) {
  std::array<Values, 3> values;
  values.fill(Values(grid.z.size(), grid.waves.rows()));
  in_parallel(0, static_cast<int>(grid.z.size()), [&](int ring) {
    for (Eigen::Index j = 0; j < grid.waves.rows(); ++j) {
      const double sine = grid.sine[ring];
      const Eigen::Vector3f seen = sky({sine * grid.waves(j, 2), sine * grid.waves(j, 3), grid.z[ring]});
      for (Eigen::Index c = 0; c < 3; ++c) values[c](ring, j) = static_cast<double>(seen[c]);
    }
  });
  if (!std::all_of(values.begin(), values.end(), [](const Values& channel) { return channel.allFinite(); })) {
    throw std::runtime_error("a light is not finite; expected finite radiance for the sharp part of lobes");
  }
  return values;
}

}  // namespace

SharpLayer::SharpLayer(const SkyRadiance& sky, int degree, Mesh mesh)
    : fits_(fit_lobes(mesh, kMaxDegree)), specular_(std::move(mesh.specular)), exponent_(std::move(mesh.exponent)) {
  for (std::size_t v = 0; v < specular_.size(); ++v) {
    if (!specular_[v].isZero(0.0F)) maps_[exponent_[v]];
    if (maps_.size() > kMostExponents) {
      throw std::invalid_argument(fmt::format(
          "more than {} different exponents of lobes: expected fewer for their sharp part", kMostExponents));
    }
  }
  if (maps_.empty()) return;
  const auto rule = numeric::gauss_legendre<double>(kFineRings);
  const Grid fine(rule.nodes, kFineAround);
  const Grid grid = grid_of_map();
  const std::array<Values, 3> values = sampled(fine, sky);
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    const Coefficients coefficients = analyzed(fine, rule.weights, values[channel]);
    for (auto& [exponent, map] : maps_) {
      const Values found = synthesized(grid, coefficients, degree, exponent);
      map.resize(static_cast<std::size_t>(found.size()));
      for (Eigen::Index i = 0; i < found.size(); ++i) {
        map[i][channel] = static_cast<float>(found(i / kAround, i % kAround));
      }
    }
  }
}

Eigen::Vector3f SharpLayer::at(float exponent, const Eigen::Vector3f& direction) const {
  const auto found = maps_.find(exponent);
  if (found == maps_.end()) return Eigen::Vector3f::Zero();
  const float latitude = std::acos(std::clamp(direction.z(), -1.0F, 1.0F)) / static_cast<float>(kPi);
  const float azimuth = std::atan2(direction.y(), direction.x()) / static_cast<float>(2.0 * kPi);
  const float row = std::clamp(latitude * kRings - 0.5F, 0.0F, kRings - 1.0F);
  const float column = (azimuth < 0.0F ? azimuth + 1.0F : azimuth) * kAround - 0.5F;
  const int i = std::min(static_cast<int>(row), kRings - 2);
  const int j = static_cast<int>(std::floor(column));
  const auto value = [&](int ring, int step) -> const Eigen::Vector3f& {
    return found->second[static_cast<std::size_t>(ring * kAround + (step + kAround) % kAround)];
  };
  const float down = row - static_cast<float>(i);
  const float right = column - static_cast<float>(j);
  return (1.0F - down) * ((1.0F - right) * value(i, j) + right * value(i, j + 1)) +
         down * ((1.0F - right) * value(i + 1, j) + right * value(i + 1, j + 1));
}

Eigen::Vector3f SharpLayer::at(std::size_t vertex, const Eigen::Vector3f& direction) const {
  if (specular_.empty() || specular_[vertex].isZero(0.0F)) return Eigen::Vector3f::Zero();
  return specular_[vertex].cwiseProduct(at(exponent_[vertex], direction));
}

float visibility_towards(const Transfer& transfer, const Hit& hit, const Eigen::Vector3f& direction) {
  if (transfer.shape.meets != Meets::kOperator) return 1.0F;
  const int degree = transfer.shape.degree + transfer.shape.result_degree;
  std::array<float, coefficient_count(kMaxDegree)> between{};
  const Face& face = transfer.mesh.faces[hit.face];
  const std::array<float, 3> parts = hit.parts();
  const std::size_t count = coefficient_count(degree);
  std::vector<float> room;
  for (std::size_t k = 0; k < 3; ++k) {
    as_array(between.data(), count) += parts[k] * as_array(transfer.row(face[k], room), count);
  }
  float seen = 0.0F;
  at_degree(degree, [&](auto known) {
    seen = sh::evaluate<known()>(between.data(), direction.x(), direction.y(), direction.z());
  });
  return std::clamp(seen, 0.0F, 1.0F);
}

}  // namespace sh::prt
