// Relighting: multiplies baked transfer vectors by the coefficients of a light, in several ways [Green 2003, "Rendering
// SH Diffuse Surfaces"]. All ways read the rows in the order of the transfer file (generated
// drivers `relight*`; batch/stored.hpp for what a file stores otherwise), run in parallel and give the same bits on every
// machine and for any number of threads. Single precision.
//   a light of any color           relight: three sums a vertex
//   white light                    relight under a light whose channels are equal: memory is the limit, not its sums
//   recolored                      any color a vertex in place of the albedo: recolored
//   gray                           one number a vertex, no color: relight_gray
//   4 coefficients                 any of these under a light of degree 1, which is zero in the higher bands
#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Throws std::invalid_argument if the light needs a column that the transfer was stored without: a coefficient of the
/// light there is larger than rounding (1e-6 of the light's largest coefficient). The light has the degree of the
/// transfer. Columns of visibility are those of no single coefficient: any light may come.
void require_kept(const Transfer& transfer, const LightCoefficients& light);

/// The same, and also if the light has a higher degree than the transfer.
void require_light(const Transfer& transfer, const LightCoefficients& light);

/// Exit radiance per vertex, (vertices), linear RGB, W m^-2 sr^-1, as transfer.hpp says; slightly negative where a
/// band-limited light rings. A light of lower degree than the transfer is zero in the bands above. Throws
/// std::invalid_argument if the light has a higher degree, and for glossy transfer, whose exit radiance depends on the
/// direction (prt/runtime/glossy.hpp).
std::vector<Eigen::Vector3f> relight(const Transfer& transfer, const LightCoefficients& light);

/// The same, but writes into `radiance` and allocates nothing. Also throws std::invalid_argument unless `radiance` has
/// one entry a vertex.
void relight_into(const Transfer& transfer, const LightCoefficients& light, std::span<Eigen::Vector3f> radiance);

/// The same with `colours`, (vertices), in place of the albedo. Also throws std::invalid_argument for transfer with bounces, which holds its albedo, and unless there is one
/// color a vertex.
std::vector<Eigen::Vector3f> recolored(const Transfer& transfer, const LightCoefficients& light,
                                       std::span<const Eigen::Vector3f> colors);

/// The same for one vertex, with the same bits, for callers whose vertices have different lights.
Eigen::Vector3f relight_vertex(const Transfer& transfer, std::size_t vertex, const LightCoefficients& light,
                               const Eigen::Vector3f& color);

/// sum_i T_i L_i alone, (vertices), for the first channel of the light: the exit radiance of white surfaces without
/// emission. Throws for the same reasons as `recoloured`.
std::vector<float> relight_gray(const Transfer& transfer, const LightCoefficients& light);

/// The light with its luminance (Rec. 709) in every channel.
LightCoefficients white(const LightCoefficients& light);

/// The mesh with float vertex properties red, green, blue (linear exit radiance), binary little-endian PLY; x, y, z are
/// float, or double if the mesh has a frame of its own. The file appears complete or not at all. Throws
/// std::runtime_error naming `file`.
void write_ply(const std::string& file, const Mesh& mesh, const std::vector<Eigen::Vector3f>& radiance);

}  // namespace sh::prt
