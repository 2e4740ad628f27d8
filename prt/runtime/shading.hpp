// Choices of a user who relights: how many bands, white light, other albedo.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct Shading {
  int degree = -1;              // bands above are left out; -1: none
  bool white = false;           // the light's luminance in every channel
  std::vector<float> recolour;  // linear RGB albedo in place of the transfer's; empty: that one

  /// Throws std::invalid_argument where a choice does not fit the transfer, or the degree is above `highest`.
  void require_fit(const Transfer& transfer, int highest) const;
  /// The degree that the light needs for a transfer of that degree.
  [[nodiscard]] int degree_for(int transfer_degree) const;
  /// A light of that degree as chosen.
  [[nodiscard]] LightCoefficients chosen(const LightCoefficients& light) const;
  /// Exit radiance, (vertices), under what `chosen` gave, turned or shadowed at will.
  [[nodiscard]] std::vector<Eigen::Vector3f> shade(const Transfer& transfer, const LightCoefficients& light) const;
  /// That of one vertex, the same bits, not with bounces.
  [[nodiscard]] Eigen::Vector3f shade_vertex(const Transfer& transfer, std::size_t vertex,
                                             const LightCoefficients& light) const;
};

}  // namespace sh::prt
