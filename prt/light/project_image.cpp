// Projection of pictures of every mapping on the SH basis, pixel by pixel: prt/light/project.hpp.
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "prt/basis.hpp"
#include "prt/light/project.hpp"

namespace sh::prt {
namespace {

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
      for (std::size_t i = 0; i < pixel.size(); ++i) {
        pixel[i] += node.weight * basis[i];
      }
    }
    const Eigen::Vector3d value = image.at(column, row).cast<double>();
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t i = 0; i < pixel.size(); ++i) {
        sum.at(channel, i) += value[static_cast<int>(channel)] * pixel[i];
      }
    }
  }
  return sum;
}

}  // namespace

LightCoefficients project_image(const Image& image, ImageMapping mapping, int degree) {
  if (mapping == ImageMapping::kLatLong) {
    return project_lat_long(image, degree);
  }
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
