#include "prt/runtime/shading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "prt/kinds/kinds.hpp"
#include "prt/material/lobe.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {

void Shading::require_fit(const Transfer& transfer, int highest) const {
  if (degree < -1 || degree > highest) {
    throw std::invalid_argument(fmt::format("--degree {}: the transfer has degrees 0 to {}", degree, highest));
  }
  for (const float channel : recolor) {
    if (!(channel >= 0.0F && channel <= 1.0F)) {
      throw std::invalid_argument(fmt::format("--recolor {}: expected an albedo from 0 to 1", channel));
    }
  }
  const std::vector<Reflectances::Head>& brdfs = transfer.mesh.brdfs.heads;
  if (!recolor.empty() && std::any_of(brdfs.begin(), brdfs.end(), [](const auto& head) { return head.is_measured; })) {
    throw std::invalid_argument(
        "--recolor: a measured BRDF brings its own colors; only other surfaces can be recolored");
  }
  if (!recolor.empty() && (transfer.kind->has_bounces() || transfer.shape.holds_albedo)) {
    throw std::invalid_argument(
        "--recolor: transfer with bounces or light through bodies holds its albedo; only other kinds can be recolored");
  }
  if (!lobe.empty()) require_lobe(transfer);
}

void Shading::require_lobe(const Transfer& transfer) const {
  if (!transfer.kind->is_glossy() || transfer.kind->has_bounces()) {
    throw std::invalid_argument(
        fmt::format("--lobe: transfer of kind {} shows no other lobe than that of its bake; expected {} or {}",
                    transfer.kind->letters, kGlossyUnshadowed.letters, kGlossyShadowed.letters));
  }
  const Eigen::Vector3f color(lobe[0], lobe[1], lobe[2]);
  if (!(color.minCoeff() >= 0.0F && color.maxCoeff() <= 1.0F && lobe[3] >= 0.0F && lobe[3] <= kMaxExponent)) {
    throw std::invalid_argument(fmt::format(
        "--lobe {}: expected reflectances from 0 to 1 and an exponent from 0 to 1e6", fmt::join(lobe, " ")));
  }
  constexpr float kRounding = 1e-5F;
  float most = 0.0F;
  for (const Eigen::Vector3f& base : albedo(transfer.mesh)) most = std::max(most, (base + color).maxCoeff());
  if (most > 1.0F + kRounding) {
    throw std::invalid_argument(fmt::format(
        "--lobe: reflects {:.3g} together with the albedo; expected at most 1 (--recolor sets another albedo)", most));
  }
}

Transfer Shading::with_lobe(Transfer transfer) const {
  if (lobe.empty()) return transfer;
  Mesh& mesh = transfer.mesh;
  mesh.brdf.clear();
  mesh.brdfs = {};
  mesh.specular.assign(mesh.positions.size(), {lobe[0], lobe[1], lobe[2]});
  mesh.exponent.assign(mesh.positions.size(), lobe[3]);
  return transfer;
}

int Shading::degree_for(int transfer_degree) const {
  return degree < 0 ? transfer_degree : std::min(degree, transfer_degree);
}

LightCoefficients Shading::chosen(const LightCoefficients& light) const {
  return white ? sh::prt::white(light) : light;
}

std::vector<Eigen::Vector3f> Shading::albedo(const Mesh& mesh) const {
  if (recolor.empty()) return mesh.albedo;
  return std::vector<Eigen::Vector3f>(mesh.positions.size(), Eigen::Vector3f(recolor[0], recolor[1], recolor[2]));
}

std::vector<Eigen::Vector3f> Shading::shade(const Transfer& transfer, const LightCoefficients& light) const {
  return recolor.empty() ? relight(transfer, light) : recolored(transfer, light, albedo(transfer.mesh));
}

Eigen::Vector3f Shading::shade_vertex(const Transfer& transfer, std::size_t vertex,
                                      const LightCoefficients& light) const {
  const Eigen::Vector3f albedo =
      recolor.empty() ? transfer.mesh.albedo[vertex] : Eigen::Vector3f(recolor[0], recolor[1], recolor[2]);
  return relight_vertex(transfer, vertex, light, albedo);
}

}  // namespace sh::prt
