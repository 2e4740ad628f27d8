// The lobes with which a place on a surface gathers the radiance that reaches it: what leaves towards the eye is the sum of
// color times (lobe times incident radiance) over them [SloanKautzSnyder02, equation 12].
#pragma once
#include <Eigen/Core>
#include <array>
#include <numbers>

#include "numeric/oracle/zonal.hpp"
#include "prt/material/lobe.hpp"
#include "prt/material/reflected.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/zonal.hpp"

namespace sh::prt {

/// The reflection of a place on a surface: linear RGB reflectances, and the exponent of the glossy lobe; or the table of a
/// BRDF, to which the albedo is the color of its parts (prt/material/reflectance.hpp).
struct Material {
  Eigen::Vector3f albedo = Eigen::Vector3f::Zero();
  Eigen::Vector3f specular = Eigen::Vector3f::Zero();
  float exponent = 0.0F;
  BrdfTable brdf = {};
};

/// Calls visit(color, lobe) for every lobe that is not black: the clamped cosine over pi about the normal and the glossy
/// lobe about the mirrored direction of view, or the parts of the BRDF; lobe (bands^2). `normal` and `to_eye` are unit.
template <class Visit>
void for_exit_lobes(const Material& material, int degree, const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye,
                    const Visit& visit) {
  if (material.brdf) return for_reflected_lobes(material.brdf, material.albedo, degree, normal, to_eye, visit);
  std::array<float, coefficient_count(kMaxDegree)> lobe;
  if (!material.albedo.isZero(0.0F)) {
    const auto cosine = [](int l) { return numeric::clamped_cosine_factor<double>(l) / std::numbers::pi; };
    zonal_about(degree, normal, cosine, lobe.data());
    visit(material.albedo, lobe.data());
  }
  if (!material.specular.isZero(0.0F)) {
    const auto exponent = static_cast<double>(material.exponent);
    zonal_about(
        degree, mirrored(-to_eye, normal), [exponent](int l) { return phong_factor(l, exponent); }, lobe.data());
    visit(material.specular, lobe.data());
  }
}

}  // namespace sh::prt
