// Maps linear radiance to screen colors: exposure, tone curve, sRGB. The default curve is the Khronos PBR Neutral tone
// mapper (Khronos Group, 2024): colors below 0.76 keep hue and contrast; brighter colors are compressed towards 1 and
// never reach it, so that highlights do not clip.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace sh::prt {

/// The factor that brings the 95th percentile of the brightest channel of `radiance` to 0.7; 1 if everything is black.
float automatic_exposure(std::span<const Eigen::Vector3f> radiance);

/// The tone curve: linear Rec. 709, any value >= 0 -> [0, 1).
Eigen::Vector3f khronos_pbr_neutral(Eigen::Vector3f color);

/// The global operator L / (1 + L) of [Reinhard02] equation 3 on the Rec. 709 luminance; the color keeps its hue, and a
/// saturated color may leave [0, 1].
Eigen::Vector3f reinhard(const Eigen::Vector3f& color);

/// The tone curves; kLinear clips at 1.
enum class ToneCurve { kNeutral, kReinhard, kLinear };

/// Applies exposure, curve and sRGB encoding; returns (pixels, 3) bytes, rounded to nearest.
std::vector<std::uint8_t> tone_map(std::span<const Eigen::Vector3f> radiance, float exposure,
                                   ToneCurve curve = ToneCurve::kNeutral);

}  // namespace sh::prt
