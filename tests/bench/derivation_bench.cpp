// Processor time to derive everything that symbolic/ offers to degree 10, each part by one method, against 5 s.
#include <cstdio>
#include <ctime>

#include "symbolic/basis/basis.hpp"
#include "symbolic/basis/basis_derivatives.hpp"
#include "symbolic/convention/convention.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"
#include "symbolic/zonal/convolution.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace {

using namespace sh::symbolic;

constexpr int kDegree = 10;
constexpr double kLimit = 5;

double total = 0;

template <class F>
void time(const char* what, const F& derive) {
  const std::clock_t start = std::clock();
  derive();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  total += seconds;
  std::printf("%-58s %7.3f s\n", what, seconds);
}

void basis() {
  for (int l = 0; l <= kDegree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const BasisFunction f = basis_function(l, m);
      for (const BasisForm form : {BasisForm::kReduced, BasisForm::kHomogeneous}) {
        gradient(f, form);
        hessian(f, form);
      }
    }
  }
}

void quaternion_rotations() {
  for (int l = 0; l <= kDegree; ++l) quaternion_rotation(l);
}

void recursions() { rotation_bands(kMaxExpandedDegree, quaternion_matrix(), Polynomial(cln::cl_RA(1))); }

void axis_rotations() {
  for (int l = 0; l <= kDegree; ++l) {
    rotation_about_z(l);
    rotation_about_y(l);
    rotation_x90(l);
    for (int row = -l; row <= l; ++row) {
      for (int column = -l; column <= l; ++column) wigner_d(l, row, column);
    }
  }
}

void zonal_functions() {
  for (const ZonalFamily& family : zonal_families()) zonal_coefficients(family, kDegree);
  for (int l = 0; l <= kDegree; ++l) irradiance_factor(l);
}

}  // namespace

int main() {
  time("basis, both forms, gradients, Hessians", basis);
  time("rotation of a quaternion", quaternion_rotations);
  time("rotation by the recursion, in a quaternion, to degree 6", recursions);
  time("rotation about an axis, Wigner's d", axis_rotations);
  time("zonal functions, irradiance factors", zonal_functions);
  time("Gaunt tensor", [] { gaunt_tensor(kDegree); });
  std::printf("%-58s %7.3f s, limit %.0f s: %s\n", "everything to degree 10", total, kLimit,
              total <= kLimit ? "pass" : "miss");
}
