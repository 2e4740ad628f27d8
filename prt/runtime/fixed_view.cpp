#include "prt/runtime/fixed_view.hpp"

#include "prt/chunks.hpp"
#include "prt/mesh/fit_lobes.hpp"
#include "prt/runtime/glossy.hpp"

namespace sh::prt {

namespace {

// Rows of three channels: what `radiance` of the vertices is where each function of the basis is the light.
template <class Radiance>
Transfer rows_of(const Transfer& glossy, const char* solver, const Radiance& radiance) {
  const std::size_t count = coefficient_count(glossy.degree());
  Transfer rows = Transfer::of(kInterreflected, glossy.degree());
  rows.scene = glossy.scene;
  rows.mesh = glossy.mesh;
  rows.mesh.specular.clear();
  rows.mesh.exponent.clear();
  leave_out_gloss(rows.mesh);
  rows.directions = glossy.directions;
  rows.sampler = glossy.sampler;
  rows.seed = glossy.seed;
  rows.instruction_set = glossy.instruction_set;
  rows.missing = glossy.missing;
  rows.emitted = glossy.emitted;
  rows.bounces.solver = solver;
  rows.coefficients.resize(rows.mesh.positions.size() * rows.shape.length());
  for (std::size_t i = 0; i < count; ++i) {
    LightCoefficients light = LightCoefficients::zero(glossy.degree());
    light.matrix().row(Eigen::Index(i)).setOnes();
    const std::vector<Eigen::Vector3f> values = radiance(TransferredRadiance(glossy, light));
    for (std::size_t v = 0; v < values.size(); ++v) {
      for (std::size_t c = 0; c < 3; ++c) rows.row(v)[c * count + i] = values[v][static_cast<Eigen::Index>(c)];
    }
  }
  return rows;
}

}  // namespace

Transfer seen_from(const Transfer& glossy, const Eigen::Vector3d& eye) {
  return rows_of(glossy, "fixed view", [&](const TransferredRadiance& reaching) {
    return reflected_radiance(glossy, reaching, eye, glossy.mesh.albedo);
  });
}

Transfer diffuse_vectors(const Transfer& glossy) {
  Mesh fitted = glossy.mesh;
  fit_lobes(fitted, glossy.degree());
  return rows_of(glossy, "diffuse part", [&](const TransferredRadiance& reaching) {
    std::vector<Eigen::Vector3f> radiance(fitted.positions.size());
    for_vertices(radiance.size(), [&](std::size_t v) {
      const Eigen::Vector3f& normal = fitted.normals[v];
      radiance[v] = exit_radiance({.albedo = fitted.albedo[v]}, glossy.degree(), reaching.at(v), normal, normal);
    });
    return radiance;
  });
}

}  // namespace sh::prt
