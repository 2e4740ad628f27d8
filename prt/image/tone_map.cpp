#include "prt/image/tone_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numeric/output/srgb.hpp"

namespace sh::prt {

float automatic_exposure(std::span<const Eigen::Vector3f> radiance) {
  constexpr double kPercentile = 0.95;
  constexpr float kTarget = 0.7F;
  if (radiance.empty()) return 1.0F;
  std::vector<float> brightest;
  brightest.reserve(radiance.size());
  for (const Eigen::Vector3f& color : radiance) brightest.push_back(color.maxCoeff());
  const auto middle =
      brightest.begin() + static_cast<std::ptrdiff_t>(kPercentile * static_cast<double>(brightest.size() - 1));
  std::nth_element(brightest.begin(), middle, brightest.end());
  return *middle > 0.0F ? kTarget / *middle : 1.0F;
}

Eigen::Vector3f khronos_pbr_neutral(Eigen::Vector3f color) {
  constexpr float kToe = 0.04F;  // F0 of common dielectrics, which the curve subtracts again
  constexpr float kStart = 0.8F - kToe;
  constexpr float kDesaturation = 0.15F;
  const float darkest = color.minCoeff();
  color.array() -= darkest < 2.0F * kToe ? darkest - 6.25F * darkest * darkest : kToe;
  const float peak = color.maxCoeff();
  if (peak < kStart) return color;
  const float room = 1.0F - kStart;
  const float compressed = 1.0F - room * room / (peak + room - kStart);
  color *= compressed / peak;
  const float gray = 1.0F - 1.0F / (kDesaturation * (peak - compressed) + 1.0F);
  return (1.0F - gray) * color + gray * Eigen::Vector3f::Constant(compressed);
}

Eigen::Vector3f reinhard(const Eigen::Vector3f& color) {
  return color / (1.0F + color.dot(Eigen::Vector3f(0.2126F, 0.7152F, 0.0722F)));
}

std::vector<std::uint8_t> tone_map(std::span<const Eigen::Vector3f> radiance, float exposure, ToneCurve curve) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * radiance.size());
  for (const Eigen::Vector3f& color : radiance) {
    Eigen::Vector3f shown = exposure * color.cwiseMax(0.0F);
    if (curve == ToneCurve::kNeutral) shown = khronos_pbr_neutral(shown);
    if (curve == ToneCurve::kReinhard) shown = reinhard(shown);
    for (const float channel : shown) {
      bytes.push_back(
          static_cast<std::uint8_t>(std::lround(255.0F * output::srgb_encode(std::clamp(channel, 0.0F, 1.0F)))));
    }
  }
  return bytes;
}

}  // namespace sh::prt
