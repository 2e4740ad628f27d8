// See checks.hpp.
#include "numeric/kernels/checks/checks.hpp"

#include <algorithm>

namespace sh::numeric {

std::string without_variant(const std::string& family) {
  const std::string ending = "_accurate";
  return family.ends_with(ending) ? family.substr(0, family.size() - ending.size()) : family;
}

std::vector<FamilyCheck> all_checks() {
  return {basis_check(),
          basis_gradient_check(),
          basis_normalised_check(),
          evaluate_check(),
          evaluate_rgb_check(),
          evaluate_prepare_check(),
          evaluate_prepared_check(),
          project_check(),
          project_moments_check(),
          project_finish_check(),
          cap_check(),
          zonal_check(),
          add_cap_check(),
          add_cap_rgb_check(),
          irradiance_check(),
          irradiance_matrix_check(),
          irradiance_evaluate_check(),
          lightmap_check(),
          lightmap_project_check(),
          lightmap_evaluate_check(),
          product_check(),
          product_full_check(),
          square_check(),
          product_zonal_check(),
          triple_check(),
          rotate_check(),
          rotate_quaternion_check(),
          rotate_z_check(),
          rotate_build_check(),
          rotate_apply_check(),
          rotate_evaluate_check(),
          window_hann_check(),
          window_lanczos_check(),
          window_lanczos2_check(),
          window_lanczos4_check(),
          window_gaussian_check(),
          window_laplacian_check()};
}

const FamilyCheck* find_check(const std::vector<FamilyCheck>& checks, const std::string& family) {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [&](const FamilyCheck& check) { return check.family == without_variant(family); });
  return found == checks.end() ? nullptr : &*found;
}

}  // namespace sh::numeric
