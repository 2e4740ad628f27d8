// Options of the commands that relight: how many bands, white light, other albedo.
#pragma once
#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <vector>

#include "prt/commands/commands.hpp"
#include "prt/light/light.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

struct ShadingOptions {
  int degree = -1;              // bands above are left out; -1: those of the transfer
  bool white = false;           // the light's luminance in every channel
  std::vector<float> recolour;  // linear RGB albedo instead of the transfer's; empty: that one

  void add_to(CLI::App& command);
  /// The lights as this transfer meets them, under that window or their own. Throws std::invalid_argument for options
  /// that do not fit it.
  [[nodiscard]] LightCoefficients light(const std::vector<Light>& lights, const Transfer& transfer,
                                        const WindowOptions& window) const;
  /// Exit radiance, (vertices). Throws as `light` does.
  [[nodiscard]] std::vector<Eigen::Vector3f> shade(const Transfer& transfer, const LightCoefficients& light) const;
};

}  // namespace sh::prt
