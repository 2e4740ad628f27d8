// Projects pictures on the SH basis. Each pixel is a patch of constant radiance, over which the basis is integrated.
// For lat-long pictures this is exact in azimuth and uses Gauss-Legendre quadrature (to rounding) between the polar
// angles of the pixel's upper and lower edge; band 0 is then the sum of radiance times exact solid angle. Other
// mappings have nodes in every pixel. The quicker rule (basis at the pixel's center times exact solid angle) leaks a
// constant picture into the even bands (prt/IMAGES.md has the numbers).

#include <cmath>
#include <numbers>

#include "numeric/oracle/quadrature.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/light/light.hpp"

namespace sh::prt {
namespace {

constexpr double kPi = std::numbers::pi;

/// Y_lm at azimuth 0, m >= 0, integrated over sin(theta) d(theta) from theta = `from` to `to`; the polar factor of -m,
/// which has the sine instead of the cosine, is the same. A row is at most pi high (a picture of one row), the basis at
/// most of degree 10: 24 nodes integrate it to rounding.
BasisValues polar_integrals(int degree, double from, double to) {
  static const auto kRule = numeric::gauss_legendre<double>(24);
  BasisValues sum{};
  for (std::size_t k = 0; k < kRule.nodes.size(); ++k) {
    const double theta = 0.5 * (from + to) + 0.5 * (to - from) * kRule.nodes[k];
    const double weight = 0.5 * (to - from) * kRule.weights[k] * std::sin(theta);
    add_basis(degree, std::sin(theta), 0.0, std::cos(theta), weight, sum.data());
  }
  return sum;
}

/// cos(m phi), and sin(|m| phi) for m < 0, integrated over each column: (2 degree + 1, width).
Eigen::MatrixXd azimuth_integrals(int degree, int width) {
  Eigen::MatrixXd out(2 * degree + 1, width);
  const double step = 2.0 * kPi / width;
  for (int i = 0; i < width; ++i) {
    const double phi = kPi * (1.0 - (2.0 * i + 1.0) / width);  // the pixel's center
    for (int m = -degree; m <= degree; ++m) {
      const int order = std::abs(m);
      const double extent = m == 0 ? step : 2.0 * std::sin(0.5 * order * step) / order;
      out(degree + m, i) = extent * (m < 0 ? std::sin(order * phi) : std::cos(order * phi));
    }
  }
  return out;
}

LightCoefficients project_row(const Image& image, ImageMapping mapping, int row, int degree) {
  LightCoefficients sum = LightCoefficients::zero(degree);
  std::vector<PixelNode> nodes;
  Eigen::VectorXd pixel(sum.bands_squared());
  for (int column = 0; column < image.width; ++column) {
    pixel_nodes(mapping, image.width, column, row, nodes);
    pixel.setZero();
    for (const PixelNode& node : nodes) {
      add_basis(degree, node.direction.x(), node.direction.y(), node.direction.z(), node.weight, pixel.data());
    }
    sum.matrix() += pixel * image.at(column, row).cast<double>().transpose();
  }
  return sum;
}

LightCoefficients project_lat_long(const Image& image, int degree) {
  LightCoefficients light = LightCoefficients::zero(degree);
  const Eigen::MatrixXd azimuth = azimuth_integrals(degree, image.width);
  std::vector<Eigen::MatrixX3d> sums(image.height);  // (2 degree + 1, 3) a row of pixels
  in_parallel(0, image.height, [&](int row) {
    const Eigen::Map<const Eigen::Matrix3Xf> pixels(image.at(0, row).data(), 3, image.width);
    sums[row] = azimuth * pixels.cast<double>().transpose();
  });
  const double step = kPi / image.height;
  for (int row = 0; row < image.height; ++row) {  // in order: the sum does not depend on the number of threads
    const BasisValues polar = polar_integrals(degree, row * step, (row + 1) * step);
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        light.matrix().row(coefficient_index(l, m)) +=
            polar[coefficient_index(l, std::abs(m))] * sums[row].row(degree + m);
      }
    }
  }
  return light;
}

}  // namespace

LightCoefficients project_image(const Image& image, ImageMapping mapping, int degree) {
  if (mapping == ImageMapping::kLatLong) return project_lat_long(image, degree);
  require_degree(degree);
  std::vector<LightCoefficients> rows(image.height);
  in_parallel(0, image.height, [&](int row) { rows[row] = project_row(image, mapping, row, degree); });
  LightCoefficients sum = LightCoefficients::zero(degree);
  for (const LightCoefficients& row : rows) accumulate(sum, row);  // in order, for any number of threads
  return sum;
}

}  // namespace sh::prt
