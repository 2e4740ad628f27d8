// Closed answers of scenes that have one.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "prt/scene/scene.hpp"

namespace sh::prt {

struct TransferRows;

/// The shadowed transfer vectors of those vertices, exact at the vertices themselves (a bake's rays start a hair off);
/// none for scenes other than Scene::disc's. (vertices, bands^2)
std::optional<TransferRows> exact_transfer(const Scene& scene, const std::vector<std::uint32_t>& vertices, int degree);

/// cos/pi Y_lm integrated over the disc of that radius about (0, 0, height), which faces straight down, as seen from a
/// point of the ground z = 0 that faces straight up: what the disc takes from the unshadowed vector. (bands^2)
/// Gauss-Legendre nodes in the radius times equidistant azimuths over the disc, cos cos' / r^2 dA for solid angles: the
/// integrand is smooth, errors below 1e-12 for height at least a quarter of the radius.
std::vector<double> hidden_by_disc(const Eigen::Vector3d& point, double radius, double height, int degree);

/// The part of the cosine that the disc hides, 0..1: the form factor of a differential area and a parallel disc in
/// closed form [Howell82], an independent check of band 0.
double disc_form_factor(double off_axis, double radius, double height);

}  // namespace sh::prt
