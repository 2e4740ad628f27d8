// Closed-form solutions for scenes that have one.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "prt/scene/scene.hpp"

namespace sh::prt {

struct TransferRows;

/// The shadowed transfer vectors of `vertices`, (vertices, bands^2), exact at the vertices themselves (the rays of a
/// bake start slightly off the surface). Empty for scenes without Scene::disc.
std::optional<TransferRows> exact_transfer(const Scene& scene, const std::vector<std::uint32_t>& vertices, int degree);

/// The part of the unshadowed vector that the disc blocks, (bands^2): the integral of cos/pi Y_lm over the disc of this
/// radius about (0, 0, height), as seen from `point` on the ground z = 0, which faces straight up. It uses
/// Gauss-Legendre nodes in the radius and equidistant azimuths, with cos cos' / r^2 dA as solid angle. The integrand is
/// smooth: errors are below 1e-12 if height is at least a quarter of the radius.
std::vector<double> hidden_by_disc(const Eigen::Vector3d& point, double radius, double height, int degree);

/// The part of the cosine that the disc hides, 0..1: the form factor of a differential area and a parallel disc in
/// closed form [Howell82]. It checks band 0 independently.
double disc_form_factor(double off_axis, double radius, double height);

}  // namespace sh::prt
