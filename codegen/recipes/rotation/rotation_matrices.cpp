// Rotations by band matrices, and the value of a rotated function.
#include "codegen/passes/passes.hpp"
#include "codegen/recipes/basis/basis.hpp"
#include "codegen/recipes/rotation/band_matrices.hpp"
#include "codegen/recipes/rotation/rotation.hpp"
#include "codegen/recipes/rotation/rotation_parts.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Matrix;

using Bands = BandMatrices (*)(SignedBuilder&, const std::array<NodeId, 9>&, int);

constexpr const char* kDenseSource =
    "E. P. Wigner, \"Group Theory\", 1959, eq. 15.27, in the entries of r; constants derived exactly";
constexpr const char* kRecursiveSource =
    "J. Ivanic, K. Ruedenberg, J. Phys. Chem. 100, 1996, and J. Phys. Chem. A 102, 1998; constants derived exactly";

// The outputs: c turned by the matrices, band by band.
void set_turned(Kernel& kernel, SignedBuilder& build, const BandMatrices& bands, const std::vector<NodeId>& c) {
  kernel.outputs[0].node = c[0];
  for (int l = 1; l < static_cast<int>(bands.size()); ++l) {
    set_band(kernel, build, l, times(build, bands[l], band_of(c, l)));
  }
}

Kernel rotate_by(Bands make_bands, const std::string& source, int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.citation = source;
  SignedBuilder build(kernel);
  const std::array<NodeId, 9> r = matrix_inputs(build);
  const std::vector<NodeId> c = coefficient_inputs(build, 9, degree);
  set_turned(kernel, build, make_bands(build, r, degree), c);
  return kernel;
}

// Band 1 from the numbers of `dense`: R itself, entry by entry.
BandMatrices first_bands_of(SignedBuilder& build, const RotationNumbers& n, const Complex& a, const Complex& b,
                            int degree) {
  BandMatrices bands(1, Matrix<Value>(1, 1, {{build.constant(symbolic::Surd(1))}}));
  if (degree == 0) return bands;
  const Value xx = build.sum({a.re, -b.re});
  const Value yy = build.sum({a.re, b.re});
  const Value yx = build.sum({a.im, -b.im});
  const Value xy = -build.sum({a.im, b.im});
  bands.emplace_back(3, 3, std::vector<Value>{yy, n.p.im, yx, n.q.im, {n.cosine}, -n.q.re, xy, n.p.re, xx});
  return bands;
}

// The numbers of `dense` as quadratic forms in a = w + iz and b = y - ix: A = a^2, B = b^2, P = 2ab, Q = 2a conj(b).
BandMatrices quaternion_bands(SignedBuilder& build, const std::array<NodeId, 4>& q, int degree) {
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
  SignedBuilder build(kernel);
  const std::array<NodeId, 9> r = matrix_inputs(build);
  const BandMatrices bands = make_bands(build, r, degree);
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      for (int n = -l; n <= l; ++n) {
        const NodeId entry = build.node(bands[l](l + m, l + n));
        kernel.outputs.push_back(
            {entry, "l=" + std::to_string(l) + " m=" + std::to_string(m) + "," + std::to_string(n)});
      }
    }
  }
  return kernel;
}

// The direction that the rotation maps to s: r^-1 s, where r^-1 is the transposed matrix.
std::vector<NodeId> turned_back(SignedBuilder& build, const std::array<NodeId, 9>& r, const std::array<NodeId, 3>& s) {
  std::vector<NodeId> result;
  for (int column = 0; column < 3; ++column) {
    std::vector<Value> terms;
    for (int row = 0; row < 3; ++row) terms.push_back({build.mul(r[3 * row + column], s[row])});
    result.push_back(build.sum(terms, std::string("turned_") + "xyz"[column]).node);
  }
  return result;
}

}  // namespace

Kernel rotate_dense(int degree) { return rotate_by(dense_bands, kDenseSource, degree); }
Kernel rotate_recursive(int degree) { return rotate_by(recursive_bands, kRecursiveSource, degree); }
Kernel rotate_build_dense(int degree) { return build_by(dense_bands, kDenseSource, degree); }
Kernel rotate_build_recursive(int degree) { return build_by(recursive_bands, kRecursiveSource, degree); }

Kernel rotate_quaternion_polynomial(int degree) {
  Kernel kernel = quaternion_kernel(degree);
  kernel.citation = "E. P. Wigner, \"Group Theory\", 1959, eq. 15.27, as polynomials in q; constants derived exactly";
  SignedBuilder build(kernel);
  const std::array<NodeId, 4> q = quaternion_inputs(build);
  const BandMatrices bands = quaternion_bands(build, q, degree);
  set_turned(kernel, build, bands, coefficient_inputs(build, 4, degree));
  return kernel;
}

Kernel rotate_apply_rows(int degree) {
  Kernel kernel = rotation_kernel(degree);
  kernel.citation = "the product of a matrix and a vector";
  kernel.title = "Coefficients of a rotated function from prepared matrices, " + degrees_to(degree);
  kernel.domain = "m as rotate_build leaves it: matrices of 1, 3, 5, ... rows, the first of which is 1";
  kernel.parameters[0] = array(Role::kBandMatrices, "m", degree);
  SignedBuilder build(kernel);
  int next = 0;
  BandMatrices bands;
  for (int l = 0; l <= degree; ++l) {
    std::vector<Value> entries;
    for (int i = 0; i < (2 * l + 1) * (2 * l + 1); ++i, ++next) {
      entries.push_back({build.input(next, numbered("m", next))});
    }
    bands.emplace_back(2 * l + 1, 2 * l + 1, std::move(entries));
  }
  set_turned(kernel, build, bands, coefficient_inputs(build, next, degree));
  return kernel;
}

Kernel rotate_evaluate_turned(int degree) {
  Kernel kernel;
  kernel.title = "The value of a rotated function in a direction, " + degrees_to(degree);
  kernel.domain = kRotationDomain + std::string("; |d| = 1 for d = (x, y, z)");
  kernel.result =
      "f(r^-1 d) = sum of c_lm Y_lm(r^-1 d), c_lm at index l(l+1)+m, orthonormal basis, no Condon-Shortley phase";
  kernel.citation = "the direction turned back, then the basis";
  kernel.parameters =
      with_direction({parameter(Role::kRotationMatrix, "r"), array(Role::kEvaluatedCoefficients, "c", degree)});
  kernel.results = {parameter(Role::kValue, "value")};
  SignedBuilder build(kernel);
  const std::array<NodeId, 9> r = matrix_inputs(build);
  const std::vector<NodeId> c = coefficient_inputs(build, 9, degree);
  const auto [x, y, z] = direction_inputs(build, 9 + coefficient_count(degree));
  // The passes find the short forms of the basis only if x, y, z are inputs.
  const Kernel basis = passes::factor(passes::share(basis_recurrence(degree)));
  const std::vector<NodeId> functions = splice(build, basis, turned_back(build, r, {x, y, z}));
  std::vector<Value> terms;
  for (std::size_t i = 0; i < c.size(); ++i) terms.push_back({build.mul(c[i], functions[i])});
  kernel.outputs = {{build.sum(terms).node, ""}};
  return kernel;
}

}  // namespace sh::codegen::recipes
