#include "prt/runtime/fixed_view.hpp"

#include "prt/runtime/glossy.hpp"

namespace sh::prt {

Transfer seen_from(const Transfer& glossy, const Eigen::Vector3d& eye) {
  const std::size_t count = coefficient_count(glossy.degree());
  Transfer seen = Transfer::of(kInterreflected, glossy.degree());
  seen.scene = glossy.scene;
  seen.mesh = glossy.mesh;
  seen.mesh.specular.clear();
  seen.mesh.exponent.clear();
  leave_out_gloss(seen.mesh);
  seen.directions = glossy.directions;
  seen.sampler = glossy.sampler;
  seen.seed = glossy.seed;
  seen.instruction_set = glossy.instruction_set;
  seen.missing = glossy.missing;
  seen.emitted = glossy.emitted;
  seen.bounces.solver = "fixed view";
  seen.coefficients.resize(seen.mesh.positions.size() * seen.shape.length());
  for (std::size_t i = 0; i < count; ++i) {
    LightCoefficients light = LightCoefficients::zero(glossy.degree());
    light.matrix().row(Eigen::Index(i)).setOnes();
    const std::vector<Eigen::Vector3f> radiance =
        reflected_radiance(glossy, TransferredRadiance(glossy, light), eye, glossy.mesh.albedo);
    for (std::size_t v = 0; v < radiance.size(); ++v) {
      for (std::size_t c = 0; c < 3; ++c) seen.row(v)[c * count + i] = radiance[v][static_cast<Eigen::Index>(c)];
    }
  }
  return seen;
}

}  // namespace sh::prt
