#include <string>

#include "codegen/recipes/rotation/band_matrices.hpp"
#include "codegen/recipes/rotation/rotation.hpp"
#include "codegen/recipes/rotation/rotation_parts.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Matrix;
using symbolic::to_size;

using Bands = BandMatrices (*)(Builder&, const std::array<NodeId, 9>&, int);

constexpr const char* kDenseSource =
    "E. P. Wigner, \"Group Theory\", 1959, eq. 15.27, in the entries of r; constants derived exactly";
constexpr const char* kRecursiveSource =
    "J. Ivanic, K. Ruedenberg, J. Phys. Chem. 100, 1996, and J. Phys. Chem. A 102, 1998; constants derived exactly";

std::vector<Signed> times(Builder& build, const Matrix<Signed>& matrix, const std::vector<Signed>& v) {
  std::vector<Signed> result;
  for (int i = 0; i < matrix.rows(); ++i) {
    std::vector<Signed> terms;
    for (int j = 0; j < matrix.columns(); ++j) terms.push_back(product(build, matrix(i, j), v[j]));
    result.push_back(sum(build, terms));
  }
  return result;
}

Kernel rotate_by(Bands make_bands, const std::string& source, int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.citation = source;
  Builder build(kernel);
  const RotationInputs in = rotation_inputs(build, degree);
  const BandMatrices bands = make_bands(build, in.r, degree);
  copy_band_zero(kernel, in);
  for (int l = 1; l <= degree; ++l) set_band(kernel, build, l, times(build, bands[l], in.band(l)));
  return kernel;
}

// Band 1 from the numbers of `dense`: R itself, entry by entry.
BandMatrices first_bands_of(Builder& build, const RotationNumbers& n, const Complex& a, const Complex& b, int degree) {
  BandMatrices bands(1, Matrix<Signed>(1, 1, {{build.constant(symbolic::Surd(1))}}));
  if (degree == 0) return bands;
  const Signed xx = sum(build, {a.re, -b.re});
  const Signed yy = sum(build, {a.re, b.re});
  const Signed yx = sum(build, {a.im, -b.im});
  const Signed xy = -sum(build, {a.im, b.im});
  bands.emplace_back(3, 3, std::vector<Signed>{yy, n.p.im, yx, n.q.im, {n.cosine}, -n.q.re, xy, n.p.re, xx});
  return bands;
}

// The numbers of `dense` as quadratic forms in a = w + iz and b = y - ix: A = a^2, B = b^2, P = 2ab, Q = 2a conj(b).
BandMatrices quaternion_bands(Builder& build, const std::array<NodeId, 4>& q, int degree) {
  const auto& [w, x, y, z] = q;
  const auto doubled = [&build](NodeId v) { return build.add(v, v); };
  const NodeId ww = build.mul(w, w);
  const NodeId zz = build.mul(z, z);
  const NodeId xx = build.mul(x, x);
  const NodeId yy = build.mul(y, y);
  const NodeId a_re = build.sub(ww, zz, "a_re");
  const NodeId a_im = doubled(build.mul(w, z));
  const NodeId b_re = build.sub(yy, xx, "b_re");
  const NodeId b_im = doubled(build.mul(x, y));
  const NodeId wy = build.mul(w, y);
  const NodeId xz = build.mul(x, z);
  const NodeId yz = build.mul(y, z);
  const NodeId wx = build.mul(w, x);
  const NodeId p_re = doubled(build.add(wy, xz));
  const NodeId p_im = doubled(build.sub(yz, wx));
  const NodeId q_re = doubled(build.sub(wy, xz));
  const NodeId q_im = doubled(build.add(yz, wx));
  const NodeId aa = build.add(ww, zz);
  const NodeId cosine = build.sub(aa, build.add(xx, yy), "cos_b");
  const Complex a{{a_re}, {a_im}};
  const Complex b{{b_re}, {b_im, true}};
  const Complex twice_a{{doubled(a_re)}, {doubled(a_im)}};
  const Complex twice_b{{doubled(b_re)}, {doubled(b_im), true}};
  const RotationNumbers numbers{cosine, twice_a, twice_b, {{p_re}, {p_im}}, {{q_re}, {q_im}}};
  BandMatrices bands = first_bands_of(build, numbers, a, b, degree);
  if (degree >= 2) append_dense_bands(build, bands, numbers, degree);
  return bands;
}

Kernel build_by(Bands make_bands, const std::string& source, int degree) {
  Kernel kernel;
  kernel.citation = source;
  kernel.title = "The matrices that rotate coefficients of " + degrees_to(degree);
  kernel.domain = kRotationDomain;
  kernel.result =
      "D_0(r), D_1(r), ..., (2l+1)^2 numbers each, row by row, for rotate_apply: c' = D(r) c, so that "
      "f'(s) = f(r^-1 s), rows and columns in the order m = -l..l, orthonormal basis, no Condon-Shortley phase";
  kernel.parameters = {parameter(Role::kRotationMatrix, "r")};
  kernel.results = {array(Role::kBandMatrices, "m", degree)};
  Builder build(kernel);
  const std::array<NodeId, 9> r = matrix_inputs(build);
  const BandMatrices bands = make_bands(build, r, degree);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n) {
        const NodeId entry = settled(build, bands[l](l + m, l + n));
        kernel.outputs.push_back(
            {entry, "l=" + std::to_string(l) + " m=" + std::to_string(m) + "," + std::to_string(n)});
      }
    }
  }
  return kernel;
}

}  // namespace

Kernel rotate_dense(int degree) { return rotate_by(dense_bands, kDenseSource, degree); }
Kernel rotate_recursive(int degree) { return rotate_by(recursive_bands, kRecursiveSource, degree); }
Kernel rotate_build_dense(int degree) { return build_by(dense_bands, kDenseSource, degree); }
Kernel rotate_build_recursive(int degree) { return build_by(recursive_bands, kRecursiveSource, degree); }

Kernel rotate_quaternion_polynomial(int degree) {
  Kernel kernel = quaternion_kernel(degree);
  kernel.citation = "E. P. Wigner, \"Group Theory\", 1959, eq. 15.27, as polynomials in q; constants derived exactly";
  Builder build(kernel);
  const std::array<NodeId, 4> q = quaternion_inputs(build);
  const BandMatrices bands = quaternion_bands(build, q, degree);
  RotationInputs in;
  in.c = coefficient_inputs(build, 4, degree);
  copy_band_zero(kernel, in);
  for (int l = 1; l <= degree; ++l) set_band(kernel, build, l, times(build, bands[l], in.band(l)));
  return kernel;
}

Kernel rotate_apply_rows(int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.citation = "the product of a matrix and a vector";
  kernel.title = "Coefficients of a rotated function from prepared matrices, " + degrees_to(degree);
  kernel.domain = "m as rotate_build leaves it: matrices of 1, 3, 5, ... rows, the first of which is 1";
  kernel.parameters[0] = array(Role::kBandMatrices, "m", degree);
  Builder build(kernel);
  int next = 0;
  BandMatrices bands;
  for (int l = 0; l <= degree; ++l) {
    bands.emplace_back(2 * l + 1, 2 * l + 1);
    for (int i = 0; i < (2 * l + 1) * (2 * l + 1); ++i, ++next) {
      bands.back()(i / (2 * l + 1), i % (2 * l + 1)) = {build.input(next, "m" + std::to_string(next))};
    }
  }
  RotationInputs in;
  in.c = coefficient_inputs(build, next, degree);
  copy_band_zero(kernel, in);
  for (int l = 1; l <= degree; ++l) set_band(kernel, build, l, times(build, bands[l], in.band(l)));
  return kernel;
}

}  // namespace sh::codegen::recipes
