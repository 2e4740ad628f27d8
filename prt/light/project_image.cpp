// Projection of pictures on the SH basis: lat-long pictures patch by patch, in closed form along a row; others by nodes
// in every pixel. prt/light/project.hpp.
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/oracle/quadrature.hpp"
#include "prt/basis.hpp"
#include "prt/light/project.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kMaxBands = kMaxDegree + 1;
using Basis = std::array<double, kMaxBands * kMaxBands>;

std::size_t size(int n) { return static_cast<std::size_t>(n); }
std::size_t index(int l, int m) { return size(l * l + l + m); }

/// Gauss-Legendre on [-1, 1]. A row is at most pi high (a picture of one row), the basis at most of degree 10: 24 nodes
/// integrate it to rounding.
const numeric::GaussLegendreRule<double>& rule() {
  static const auto kRule = numeric::gauss_legendre<double>(24);
  return kRule;
}

/// Y_lm at azimuth 0, m >= 0, integrated over sin(theta) d(theta) from theta = `from` to `to`. For -m, with the sine
/// for the cosine, the polar factor is the same.
Basis polar_integrals(int degree, double from, double to) {
  Basis sum{};
  Basis y;
  for (std::size_t k = 0; k < rule().nodes.size(); ++k) {
    const double theta = 0.5 * (from + to) + 0.5 * (to - from) * rule().nodes[k];
    const double weight = 0.5 * (to - from) * rule().weights[k] * std::sin(theta);
    evaluate_basis(degree, std::sin(theta), 0.0, std::cos(theta), y.data());
    for (std::size_t i = 0; i < index(degree, degree) + 1; ++i) sum[i] += weight * y[i];
  }
  return sum;
}

/// cos(m phi) and sin(m phi) integrated over each column, m = 0..degree.
struct AzimuthTable {
  std::vector<std::array<double, kMaxBands>> cosine;  // (width)
  std::vector<std::array<double, kMaxBands>> sine;
};

AzimuthTable azimuth_table(int degree, int width) {
  AzimuthTable table{std::vector<std::array<double, kMaxBands>>(size(width)),
                     std::vector<std::array<double, kMaxBands>>(size(width))};
  const double step = 2.0 * kPi / width;
  for (int i = 0; i < width; ++i) {
    const double phi = kPi * (1.0 - (2.0 * i + 1.0) / width);  // the pixel's centre
    for (int m = 0; m <= degree; ++m) {
      const double extent = m == 0 ? step : 2.0 * std::sin(0.5 * m * step) / m;
      table.cosine[size(i)][size(m)] = extent * std::cos(m * phi);
      table.sine[size(i)][size(m)] = extent * std::sin(m * phi);
    }
  }
  return table;
}

/// A row's radiance against cos(m phi) and sin(m phi).
struct RowSums {
  std::array<Eigen::Vector3d, kMaxBands> cosine;
  std::array<Eigen::Vector3d, kMaxBands> sine;
};

RowSums row_sums(const Image& image, int row, int degree, const AzimuthTable& table) {
  RowSums sums;
  sums.cosine.fill(Eigen::Vector3d::Zero());
  sums.sine.fill(Eigen::Vector3d::Zero());
  for (int i = 0; i < image.width; ++i) {
    const Eigen::Vector3d pixel = image.at(i, row).cast<double>();
    for (std::size_t m = 0; m <= size(degree); ++m) {
      sums.cosine[m] += table.cosine[size(i)][m] * pixel;
      sums.sine[m] += table.sine[size(i)][m] * pixel;
    }
  }
  return sums;
}

void add_row(LightCoefficients& light, const RowSums& sums, const Basis& polar) {
  for (int l = 0; l <= light.degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Eigen::Vector3d& azimuth = m < 0 ? sums.sine[size(-m)] : sums.cosine[size(m)];
      for (std::size_t channel = 0; channel < 3; ++channel) {
        light.at(channel, index(l, m)) += polar[index(l, std::abs(m))] * azimuth[static_cast<int>(channel)];
      }
    }
  }
}

LightCoefficients project_row(const Image& image, ImageMapping mapping, int row, int degree) {
  LightCoefficients sum = LightCoefficients::zero(degree);
  std::vector<PixelNode> nodes;
  std::vector<double> basis(sum.bands_squared());
  std::vector<double> pixel(sum.bands_squared());
  for (int column = 0; column < image.width; ++column) {
    pixel_nodes(mapping, image.width, column, row, nodes);
    std::fill(pixel.begin(), pixel.end(), 0.0);
    for (const PixelNode& node : nodes) {
      evaluate_basis(degree, node.direction.x(), node.direction.y(), node.direction.z(), basis.data());
      for (std::size_t i = 0; i < pixel.size(); ++i) pixel[i] += node.weight * basis[i];
    }
    const Eigen::Vector3d value = image.at(column, row).cast<double>();
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t i = 0; i < pixel.size(); ++i) sum.at(channel, i) += value[static_cast<int>(channel)] * pixel[i];
    }
  }
  return sum;
}

}  // namespace

LightCoefficients project_lat_long(const Image& image, int degree) {
  LightCoefficients light = LightCoefficients::zero(degree);
  const AzimuthTable table = azimuth_table(degree, image.width);
  std::vector<RowSums> sums(size(image.height));
  tbb::parallel_for(0, image.height, [&](int row) { sums[size(row)] = row_sums(image, row, degree, table); });
  for (int row = 0; row < image.height; ++row) {  // in order: the sum does not depend on the number of threads
    const double step = kPi / image.height;
    add_row(light, sums[size(row)], polar_integrals(degree, row * step, (row + 1) * step));
  }
  return light;
}

LightCoefficients project_image(const Image& image, ImageMapping mapping, int degree) {
  if (mapping == ImageMapping::kLatLong) return project_lat_long(image, degree);
  require_degree(degree);
  std::vector<LightCoefficients> rows(static_cast<std::size_t>(image.height));
  tbb::parallel_for(0, image.height,
                    [&](int row) { rows[static_cast<std::size_t>(row)] = project_row(image, mapping, row, degree); });
  LightCoefficients sum = LightCoefficients::zero(degree);
  for (const LightCoefficients& row : rows) {  // in order: the sum does not depend on the number of threads
    accumulate(sum, row);
  }
  return sum;
}

}  // namespace sh::prt
