// Every family's check, in the order of reports.
#pragma once

#include <string>
#include <vector>

#include "numeric/kernels/checks/family_check.hpp"

namespace sh::numeric {

FamilyCheck basis_check();
FamilyCheck basis_gradient_check();
FamilyCheck basis_normalised_check();
FamilyCheck evaluate_check();
FamilyCheck evaluate_rgb_check();
FamilyCheck evaluate_prepare_check();
FamilyCheck evaluate_prepared_check();
FamilyCheck project_check();
FamilyCheck project_moments_check();
FamilyCheck project_finish_check();
FamilyCheck cap_check();
FamilyCheck zonal_check();
FamilyCheck add_cap_check();
FamilyCheck add_cap_rgb_check();
FamilyCheck irradiance_check();
FamilyCheck irradiance_matrix_check();
FamilyCheck irradiance_evaluate_check();
FamilyCheck lightmap_check();
FamilyCheck lightmap_project_check();
FamilyCheck lightmap_evaluate_check();
FamilyCheck product_check();
FamilyCheck product_full_check();
FamilyCheck square_check();
FamilyCheck product_zonal_check();
FamilyCheck triple_check();
FamilyCheck rotate_check();
FamilyCheck rotate_quaternion_check();
FamilyCheck rotate_z_check();
FamilyCheck rotate_build_check();
FamilyCheck rotate_apply_check();
FamilyCheck rotate_evaluate_check();
FamilyCheck window_hann_check();
FamilyCheck window_lanczos_check();
FamilyCheck window_lanczos2_check();
FamilyCheck window_lanczos4_check();
FamilyCheck window_gaussian_check();
FamilyCheck window_laplacian_check();

std::vector<FamilyCheck> all_checks();

// "basis" for "basis_accurate": the family of which it is a variant, the same function by another recipe.
std::string without_variant(const std::string& family);

// The check of a kernel's family or of the family whose variant it is ("basis" for "basis_accurate"); nullptr if none.
const FamilyCheck* find_check(const std::vector<FamilyCheck>& checks, const std::string& family);

}  // namespace sh::numeric
