// The declared lights in all orientations that are allowed: how much a part of a transfer vector can matter under them.
// A rotation of the light mixes coefficients only within groups and keeps each group's norm: the orders of a band for
// any rotation, the orders m and -m of a band for one about z, each coefficient its own where the light stays. So
//   |sum_i t_i (R L)_i| <= sum over groups |t_g| |L_g|       (Cauchy-Schwarz in every group),
// for all R allowed at once; where the light stays the sum itself is used.
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

  /// Largest |sum_i t_i L_i| of a channel; t (bands^2).
  [[nodiscard]] double largest_product(std::size_t channel, const std::vector<double>& t) const;
  /// The same for numbers of any sign, each at most e_i >= 0.
  [[nodiscard]] double largest_product_of_errors(std::size_t channel, const std::vector<double>& e) const;
  /// Indices of the groups in which any channel has more than a rounding error of its largest coefficient.
  [[nodiscard]] std::vector<std::uint32_t> needed() const;
  /// |L_l| of a channel, the same for any rotation.
  [[nodiscard]] double band_norm(std::size_t channel, int l) const;

  [[nodiscard]] const LightCoefficients& coefficients() const { return light_; }
  [[nodiscard]] LightTurns turns() const { return turns_; }

 private:
  LightCoefficients light_;
  LightTurns turns_;
  std::vector<std::vector<std::uint32_t>> groups_;
};

}  // namespace sh::prt
