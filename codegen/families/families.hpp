// Every family of kernels: its recipes, its exact reference, where it is measured. One file a family.
#pragma once

#include "codegen/families/family.hpp"

namespace sh::codegen {

Family basis_family();
Family basis_gradient_family();
Family basis_normalised_family();
Family evaluate_family();
Family evaluate_rgb_family();
Family evaluate_prepare_family();
Family evaluate_prepared_family();
Family project_family();
Family project_moments_family();
Family project_finish_family();
Family cap_family();
Family zonal_family();
Family add_cap_family();
Family add_cap_rgb_family();
Family irradiance_family();
Family irradiance_matrix_family();
Family irradiance_evaluate_family();
Family lightmap_family();
Family lightmap_project_family();
Family lightmap_evaluate_family();
Family window_hann_family();
Family window_lanczos_family();
Family window_lanczos2_family();
Family window_lanczos4_family();
Family window_gaussian_family();
Family window_laplacian_family();
Family product_family();
/// Degree N times degree N, complete in degree 2 N.
Family product_full_family();
/// Factors of these degrees, projected on one degree; its recipes serve this shape only. Throws std::invalid_argument,
/// one line, unless 0 <= left_degree, right_degree <= symbolic::kMaxProductDegree and 0 <= degree <= their sum.
Family rectangular_product_family(int left_degree, int right_degree, int degree);
Family square_family();
Family product_zonal_family();
Family triple_family();
Family rotate_family();
Family rotate_quaternion_family();
Family rotate_z_family();
Family rotate_build_family();
Family rotate_apply_family();
Family rotate_evaluate_family();

}  // namespace sh::codegen
