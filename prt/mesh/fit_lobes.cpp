#include "prt/mesh/fit_lobes.hpp"

#include <fmt/format.h>

#include "prt/chunks.hpp"

namespace sh::prt {

std::string described(const FittedBrdf& fitted) {
  return fmt::format("BRDF `{}` as a lobe of exponent {:.3g}: off by {:.2g} of itself (rms over views)", fitted.name,
                     fitted.fit.exponent, fitted.fit.error);
}

std::vector<FittedBrdf> fit_lobes(Mesh& mesh, int degree) {
  std::vector<FittedBrdf> fitted(mesh.brdfs.heads.size());
  in_parallel(0, static_cast<int>(fitted.size()), [&](int i) {
    const auto number = static_cast<std::size_t>(i);
    fitted[number] = {mesh.brdfs.heads[number].name, fit_lobe(mesh.brdfs.table(number), degree)};
  });
  if (mesh.brdf.empty()) return fitted;
  mesh.specular.resize(mesh.positions.size(), Eigen::Vector3f::Zero());
  mesh.exponent.resize(mesh.positions.size(), 0.0F);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.brdf[v] == 0) continue;
    const std::size_t number = mesh.brdf[v] - std::size_t{1};
    const LobeFit& fit = fitted[number].fit;
    const auto colors = colors_of_parts(mesh.brdfs.heads[number].is_measured, mesh.albedo[v]);
    mesh.albedo[v].setZero();
    mesh.specular[v].setZero();
    for (std::size_t part = 0; part < kReflectionParts; ++part) {
      mesh.albedo[v] += static_cast<float>(fit.diffuse[part]) * colors[part];
      mesh.specular[v] += static_cast<float>(fit.specular[part]) * colors[part];
    }
    mesh.exponent[v] = fit.exponent;
  }
  mesh.brdf.clear();
  mesh.brdfs = {};
  return fitted;
}

}  // namespace sh::prt
