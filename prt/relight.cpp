// The product T.L per vertex: prt/relight.hpp.
#include "prt/relight.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <stdexcept>

namespace sh::prt {
namespace {

/// L in single precision, the three channels of one basis function side by side in one SIMD register; the fourth is 0.
std::vector<Eigen::Array4f> interleaved(const LightCoefficients& light) {
  std::vector<Eigen::Array4f> out;
  for (std::size_t i = 0; i < light.bands_squared(); ++i) {
    out.emplace_back(static_cast<float>(light.at(0, i)), static_cast<float>(light.at(1, i)),
                     static_cast<float>(light.at(2, i)), 0.0F);
  }
  return out;
}

}  // namespace

std::vector<Eigen::Vector3f> relight(const Transfer& transfer, const LightCoefficients& light) {
  if (transfer.degree != light.degree) {
    throw std::invalid_argument(fmt::format("the light has degree {}, the transfer degree {}; they must be the same",
                                            light.degree, transfer.degree));
  }
  const std::vector<Eigen::Array4f> l = interleaved(light);
  std::vector<Eigen::Vector3f> radiance(transfer.mesh.positions.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, radiance.size(), 1024), [&](const auto& range) {
    for (std::size_t vertex = range.begin(); vertex != range.end(); ++vertex) {
      const float* t = &transfer.coefficients[vertex * l.size()];
      Eigen::Array4f sum = Eigen::Array4f::Zero();
      for (std::size_t i = 0; i < l.size(); ++i) {
        sum += t[i] * l[i];
      }
      radiance[vertex] = transfer.mesh.albedo[vertex].cwiseProduct(sum.head<3>().matrix());
    }
  });
  return radiance;
}

}  // namespace sh::prt
