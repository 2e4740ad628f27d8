// Relighting: baked transfer vectors times a light's coefficients, several ways [Green 2003, "Rendering SH Diffuse
// Surfaces"]. All run on the rows as they lie in the transfer file (prt/runtime/row_products.hpp), in parallel, with
// the same bits on every machine and for any number of threads. Single precision.
//   a light of every colour        relight: three sums a vertex
//   white light                    relight under a light whose channels are equal: one sum a vertex, the same bits
//   recoloured                     any colour a vertex in place of the albedo: recoloured
//   grey                           one number a vertex, no colour: relight_grey
//   4 coefficients                 any of them under a light of degree 1: the transfer's higher bands are left out
#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Throws std::invalid_argument where a coefficient of the light, of the transfer's degree, is more than a rounding of
/// its largest (1e-6) and the transfer was stored without what it multiplies.
void require_kept(const Transfer& transfer, const LightCoefficients& light);

/// Exit radiance per vertex, (vertices), linear RGB, W m^-2 sr^-1, as transfer.hpp says; slightly negative where a
/// band-limited light rings. A light of lower degree than the transfer has nothing in the bands above. Throws
/// std::invalid_argument where the light's degree is higher.
std::vector<Eigen::Vector3f> relight(const Transfer& transfer, const LightCoefficients& light);

/// The same into memory that is there, without allocating; also where `radiance` does not have one entry a vertex,
/// throws std::invalid_argument.
void relight_into(const Transfer& transfer, const LightCoefficients& light, std::span<Eigen::Vector3f> radiance);

/// The same with `colours`, (vertices), in place of the albedo: under white light one sum a vertex times any colour.
/// Throws std::invalid_argument also for transfer with bounces, which holds its albedo, and for other than one colour a
/// vertex.
std::vector<Eigen::Vector3f> recoloured(const Transfer& transfer, const LightCoefficients& light,
                                        std::span<const Eigen::Vector3f> colours);

/// One vertex of the above, the same bits, where every vertex has a light of its own.
Eigen::Vector3f relight_vertex(const Transfer& transfer, std::size_t vertex, const LightCoefficients& light,
                               const Eigen::Vector3f& colour);

/// sum_i T_i L_i alone, (vertices), for the first channel of the light: what white surfaces send out that do not shine.
/// Throws as `recoloured` does.
std::vector<float> relight_grey(const Transfer& transfer, const LightCoefficients& light);

/// The light with its luminance (Rec. 709) in every channel.
LightCoefficients white(const LightCoefficients& light);

/// The mesh with float vertex properties red, green, blue (linear exit radiance), binary little-endian PLY. The file
/// appears complete or not at all. Throws std::runtime_error naming `file`.
void write_ply(const std::string& file, const Mesh& mesh, const std::vector<Eigen::Vector3f>& radiance);

}  // namespace sh::prt
