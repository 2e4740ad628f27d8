// Bounds for plans: the declared lights in all allowed orientations, and transfer vectors of any vertex.
//
// A rotation of the light mixes coefficients only within groups and keeps the norm of each group. The groups are all
// orders of a band for any rotation, the orders m and -m of a band for a rotation about z, and single coefficients if
// the light does not turn. Therefore
//   |sum_i t_i (R L)_i| <= sum over groups |t_g| |L_g|       (Cauchy-Schwarz in every group),
// for all allowed R at once.
//
// Bounds on transfer vectors hold for any occlusion. They assume albedo 1; bounds for other albedos are proportional.
// Without bounces a vector is the projection of V(s) max(0, n.s) / pi, 0 <= V <= 1. The norm of its band l is its
// product with the best h of unit norm in that band. It is at most 1/pi times the integral of the cosine times
// max(0, h)
//   = 1/(2 pi) integral of cos (|h| + h) <= 1/(2 pi) sqrt(2 pi / 3) sqrt(1/2) + |DU_l| / 2
// (Cauchy-Schwarz on the hemisphere, which by parity holds half of h^2; DU_l is band l of the unshadowed vector). With
// bounces the vector is the projection of a weight that is nowhere negative and, since no energy is gained, integrates
// to at most 1:
//   |T_l| <= largest value of h = sqrt((2l+1) / 4 pi).
// The visibility of glossy kinds is the first of these without the cosine over pi: with H_l, band l of the hemisphere,
//   |V_l| <= 1/2 sqrt(2 pi) sqrt(1/2) + |H_l| / 2.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/mesh/mesh.hpp"
#include "prt/scene/options.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

class TurningLight {
 public:
  TurningLight(LightCoefficients light, LightTurns turns);

  /// A bound on |sum_i t_i L_i| of a channel over all orientations, for any t with |t_i| <= e_i; e (bands^2).
  [[nodiscard]] double largest_product_of_errors(std::size_t channel, const std::vector<double>& e) const;
  /// The largest product of any channel with a t of which only the norms |t_l| <= band(l) of the bands l >= first are
  /// known; its other bands are zero.
  [[nodiscard]] double largest_product_of_bands(int first, const std::function<double(int l)>& band) const;
  /// Indices of the groups in which any channel has more than a rounding error of its largest coefficient.
  [[nodiscard]] std::vector<std::uint32_t> needed() const;
  /// The norm |L_l| of a channel; rotations do not change it.
  [[nodiscard]] double band_norm(std::size_t channel, int l) const;

  [[nodiscard]] const LightCoefficients& coefficients() const { return light_; }

 private:
  LightCoefficients light_;
  std::vector<std::vector<std::uint32_t>> groups_;
};

/// The norm |T_l| of an unshadowed vertex: A_l/pi sqrt((2l+1) / 4 pi).
double unshadowed_band_norm(int l);

/// The norm |H_l| of the coefficients of a hemisphere.
double hemisphere_band_norm(int l);

/// The bound above that applies to the numbers of this kind; mirrors gather paths like bounces.
double transfer_band_bound(const TransferKind& kind, bool mirrors, int l);

/// The largest exit radiance of the unshadowed `mesh` under the light without rotation, over all vertices and channels.
/// It is the unit of errors.
double largest_unshadowed_radiance(const Mesh& mesh, const LightCoefficients& light);

}  // namespace sh::prt
