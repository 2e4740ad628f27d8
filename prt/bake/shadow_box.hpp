// The box around an object that its shadows under known lights need. Seen from the distance d, the object lies in the cap
// that its bounding sphere, of radius r, covers: sin(half-angle) = r / d. The box holds every point at which the light in
// this cap, as irradiance of a receiver that faces it, is above a part of the largest irradiance. The light is the one that
// the volume meets: of its degree, and possibly negative.
#pragma once
#include <Eigen/Geometry>
#include <optional>

#include "prt/light/light_coefficients.hpp"
#include "prt/scene/options.hpp"

namespace sh::prt {

/// The least part: the shadows of all lights end nearer than 1,000 radii, to where they are looked for.
inline constexpr double kFaintestShadow = 1e-5;

/// The box around an object within `bounds`, which it contains; both in the world. part: kFaintestShadow or more. turns: rotations of the
/// light for which it holds. Nothing for a light that gives no surface irradiance. Directions are tried at the nodes of a
/// grid of 5 degrees.
std::optional<Eigen::AlignedBox3d> shadow_box(const Eigen::AlignedBox3d& bounds, const LightCoefficients& light,
                                              LightTurns turns, double part);

}  // namespace sh::prt
