// The product T.L per vertex: prt/runtime/relight.hpp.
#include "prt/runtime/relight.hpp"

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

/// sum_i T_i L_i, T (bands^2).
Eigen::Vector3f irradiance_over_pi(const float* t, const std::vector<Eigen::Array4f>& l) {
  Eigen::Array4f sum = Eigen::Array4f::Zero();
  for (std::size_t i = 0; i < l.size(); ++i) {
    sum += t[i] * l[i];
  }
  return sum.head<3>();
}

/// sum_i T_ci L_ci, T (3, bands^2).
Eigen::Vector3f exit_radiance(const float* t, const std::vector<Eigen::Array4f>& l) {
  Eigen::Array4f sum = Eigen::Array4f::Zero();
  for (std::size_t i = 0; i < l.size(); ++i) {
    sum += Eigen::Array4f(t[i], t[l.size() + i], t[2 * l.size() + i], 0.0F) * l[i];
  }
  return sum.head<3>();
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
      const float* t = &transfer.coefficients[vertex * transfer.row_length()];
      radiance[vertex] = transfer.channels() == 3 ? exit_radiance(t, l)
                                                  : transfer.mesh.albedo[vertex].cwiseProduct(irradiance_over_pi(t, l));
      if (!transfer.emitted.empty()) {
        radiance[vertex] += transfer.emitted[vertex];
      }
    }
  });
  return radiance;
}

}  // namespace sh::prt
