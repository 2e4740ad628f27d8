// The formulas and tables that codegen/ takes from symbolic/, as values.
//
// The catalogue of proofs takes every formula from here, and the proofs refute a copy in which one formula differs
// (mutation.hpp). What a proof compares it with does not come from here.
#pragma once

#include <functional>
#include <vector>

#include "symbolic/basis/basis_derivatives.hpp"
#include "symbolic/convention/convention_map.hpp"
#include "symbolic/product/product_form.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/window.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic {

struct Formulas {
  // Basis: of degree l and order m, along an axis.
  std::function<BasisFunction(int l, int m)> basis = basis_function;
  std::function<BasisFunction(int l, int m)> reduced_basis = reduced_basis_function;
  std::function<Surd(int l, int m)> factor = orthonormal_factor;
  std::function<Surd(int l, int m, int n)> factor_ratio = symbolic::factor_ratio;
  std::function<Gradient(const BasisFunction& f, BasisForm form)> gradient = symbolic::gradient;
  std::function<Hessian(const BasisFunction& f, BasisForm form)> hessian = symbolic::hessian;
  std::function<std::vector<LadderTerm>(int l, int m, int axis)> ladder = gradient_ladder;

  // Rotations: bands as rational matrices, l + m and l + n are rows and columns.
  std::function<Matrix<Polynomial>()> quaternion_matrix = symbolic::quaternion_matrix;
  std::function<Quaternion<Polynomial>(const Quaternion<Polynomial>& a, const Quaternion<Polynomial>& b)>
      quaternion_product = symbolic::quaternion_product<Polynomial>;
  std::function<QuaternionRotation(int l)> rotation = quaternion_rotation;
  std::function<std::vector<Matrix<Polynomial>>(int degree, const Matrix<Polynomial>& r)> recursion =
      [](int degree, const Matrix<Polynomial>& r) { return rotation_bands<Polynomial>(degree, r, Polynomial(1)); };
  std::function<std::vector<Matrix<cln::cl_RA>>(int degree, const Matrix<cln::cl_RA>& r)> recursion_at =
      [](int degree, const Matrix<cln::cl_RA>& r) { return rotation_bands<cln::cl_RA>(degree, r, 1); };
  std::function<std::vector<std::vector<Coupling>>(int l)> couplings = band_couplings;
  std::function<cln::cl_RA(int l, int n)> column_scale = symbolic::column_scale;
  std::function<Matrix<Polynomial>(int l)> about_z = rotation_about_z;
  std::function<Matrix<Polynomial>(int l)> about_y = rotation_about_y;
  std::function<Matrix<cln::cl_RA>(int l, bool positive)> x90 = rotation_x90;
  std::function<Matrix<Surd>(int l, const Matrix<cln::cl_RA>& rational)> surd_entries = symbolic::surd_entries;
  ZyzFormula zyz_angles = zyz_from_azimuth<Polynomial>;
  EulerFormula euler = quaternion_from_euler<Polynomial>;
  AxisAngleFormula axis_angle = matrix_from_axis_angle<Polynomial>;

  // Conventions.
  std::function<Surd(const Convention& c, int l, int m)> convention_factor = symbolic::convention_factor;
  std::function<ConventionFunction(const Convention& c, int l, int m)> convention_function =
      symbolic::convention_function;
  std::function<Matrix<RadicalSum>(const Convention& c, int l)> basis_change = symbolic::basis_change;
  std::function<Matrix<RadicalSum>(const Convention& c, int l)> basis_change_inverse = symbolic::basis_change_inverse;
  std::function<ConventionMap(const Convention& from, const Convention& to, int degree)> convention_map =
      symbolic::convention_map;
  std::function<Surd(Folded folded, int l)> folded_factor = symbolic::folded_factor;
  std::function<int(IndexOrder order, int degree)> storage_size = symbolic::storage_size;
  std::function<int(IndexOrder order, int degree, int l, int m)> storage_position = symbolic::storage_position;
  std::function<Matrix<RadicalSum>(int l, bool condon_shortley)> real_from_complex = symbolic::real_from_complex;
  AxesBand axes_band = symbolic::axes_band;

  // Zonal functions and windows.
  std::function<ZonalTerm(const ZonalFamily& family, int l)> zonal = [](const ZonalFamily& family, int l) {
    return family.integral(l);
  };
  std::function<Surd(int l)> irradiance_factor = symbolic::irradiance_factor;
  std::function<Surd(int l)> irradiance_factor_integral = symbolic::irradiance_factor_integral;
  std::function<Surd(int l)> convolution_factor = symbolic::convolution_factor;
  std::function<std::vector<TurnedZonal>(int degree)> turned_zonal = symbolic::turned_zonal;
  std::function<Polynomial(int l)> window_hann = symbolic::window_hann;
  std::function<Polynomial(int l)> window_lanczos_sine = symbolic::window_lanczos_sine;
  std::function<int(int l)> window_gaussian_exponent = symbolic::window_gaussian_exponent;
  std::function<cln::cl_RA(int l)> window_laplacian_penalty = symbolic::window_laplacian_penalty;

  // Products.
  std::function<GauntTensor(int degree)> gaunt = gaunt_tensor;
  std::function<bool(int i, int j, int k)> gaunt_rule = gaunt_may_differ_from_zero;
  Wigner3j wigner_3j = symbolic::wigner_3j;
  std::function<std::vector<BilinearForm>(const ProductShape& shape)> product = product_form;
  std::function<std::vector<BilinearForm>(int degree, int result)> square = square_form;
  std::function<std::vector<BilinearForm>(const ProductShape& shape)> zonal_product = zonal_product_form;
  std::function<Matrix<RadicalSum>(const std::vector<Surd>& known, const ProductShape& shape)> transfer_matrix =
      symbolic::transfer_matrix;
};

}  // namespace sh::symbolic
