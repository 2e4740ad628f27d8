// The declared lights in all allowed orientations, and bounds on the effect of a part of a transfer vector under them.
// A rotation of the light mixes coefficients only within groups and keeps the norm of each group. The groups are all
// orders of a band for any rotation, the orders m and -m of a band for a rotation about z, and single coefficients if
// the light does not turn. Therefore
//   |sum_i t_i (R L)_i| <= sum over groups |t_g| |L_g|       (Cauchy-Schwarz in every group),
// for all allowed R at once. If the light does not turn, the sum itself is used.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/scene/plan_options.hpp"

namespace sh::prt {

class TurningLight {
 public:
  TurningLight(LightCoefficients light, LightTurns turns);

  /// The largest |sum_i t_i L_i| of a channel over all orientations; t (bands^2).
  [[nodiscard]] double largest_product(std::size_t channel, const std::vector<double>& t) const;
  /// The same for unknown t with |t_i| <= e_i.
  [[nodiscard]] double largest_product_of_errors(std::size_t channel, const std::vector<double>& e) const;
  /// Indices of the groups in which any channel has more than a rounding error of its largest coefficient.
  [[nodiscard]] std::vector<std::uint32_t> needed() const;
  /// The norm |L_l| of a channel; rotations do not change it.
  [[nodiscard]] double band_norm(std::size_t channel, int l) const;

  [[nodiscard]] const LightCoefficients& coefficients() const { return light_; }
  [[nodiscard]] LightTurns turns() const { return turns_; }

 private:
  LightCoefficients light_;
  LightTurns turns_;
  std::vector<std::vector<std::uint32_t>> groups_;
};

}  // namespace sh::prt
