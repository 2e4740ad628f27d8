// From linear radiance to what a screen shows: exposure, tone curve, sRGB.
// The curve is, unless another is asked for, the Khronos PBR Neutral tone mapper (Khronos Group, 2024): colours below
// 0.76 keep hue and contrast, brighter ones are compressed towards 1 and never reach it, so highlights do not clip.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace sh::prt {

/// The factor that brings the 95th percentile of the brightest channel of `radiance` to 0.7; 1 where all is black.
float automatic_exposure(std::span<const Eigen::Vector3f> radiance);

/// The tone curve: linear Rec. 709, any value >= 0 -> [0, 1).
Eigen::Vector3f khronos_pbr_neutral(Eigen::Vector3f color);

/// The global operator L / (1 + L) of [Reinhard02] equation 3 on the Rec. 709 luminance; the colour keeps its hue, and
/// a saturated one may leave [0, 1].
Eigen::Vector3f reinhard(const Eigen::Vector3f& color);

/// Linear clips at 1.
enum class ToneCurve { kNeutral, kReinhard, kLinear };

/// exposure * radiance through curve and encoding; (pixels, 3) bytes, rounded to nearest.
std::vector<std::uint8_t> tone_map(std::span<const Eigen::Vector3f> radiance, float exposure,
                                   ToneCurve curve = ToneCurve::kNeutral);

}  // namespace sh::prt
