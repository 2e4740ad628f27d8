// The user's choices for relighting: the number of bands, white light, another material.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct Shading {
  int degree = -1;               // higher bands are left out; -1 keeps all
  bool white = false;            // the light's luminance in every channel
  std::vector<float> recolor{};  // linear RGB albedo that replaces the transfer's; empty: no change
  std::vector<float> lobe{};     // linear RGB reflectance and exponent, in place of lobes and BRDFs; empty: no change

  /// Throws std::invalid_argument if a choice does not fit the transfer, or if the degree is above `highest`.
  void require_fit(const Transfer& transfer, int highest) const;
  /// The transfer with the chosen lobe.
  [[nodiscard]] Transfer with_lobe(Transfer transfer) const;
  /// The degree that the light needs for a transfer of this degree.
  [[nodiscard]] int degree_for(int transfer_degree) const;
  /// Applies the choices to a light of that degree.
  [[nodiscard]] LightCoefficients chosen(const LightCoefficients& light) const;
  /// The albedo of every vertex.
  [[nodiscard]] std::vector<Eigen::Vector3f> albedo(const Mesh& mesh) const;
  /// Exit radiance, (vertices), under a light from `chosen`, which may be turned or shadowed afterwards.
  [[nodiscard]] std::vector<Eigen::Vector3f> shade(const Transfer& transfer, const LightCoefficients& light) const;
  /// The same for one vertex, with the same bits; not for transfer with bounces.
  [[nodiscard]] Eigen::Vector3f shade_vertex(const Transfer& transfer, std::size_t vertex,
                                             const LightCoefficients& light) const;

 private:
  void require_lobe(const Transfer& transfer) const;
};

}  // namespace sh::prt
