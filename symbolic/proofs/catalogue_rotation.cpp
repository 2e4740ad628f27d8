#include "symbolic/proofs/catalogue.hpp"

namespace sh::symbolic {
namespace {

constexpr int kPoints = 3;
constexpr int kAnyDegree = 50;

const char* const kExpanded = "the expanded polynomials take minutes beyond";
const char* const kQuaternion = "the quaternion form is derived to degree 10";
const char* const kExact = "closed forms and recursion are kept to degree 20, where exact entries stay small";
const char* const kIndependent = "does not depend on the degree";

std::vector<QuaternionRotation> quaternion_bands(const Formulas& f, int degree) {
  return values_to(degree, f.rotation);
}

BandsAt recursion_at_points(const SharedFormulas& f, int degree) {
  return [f, degree](const Matrix<cln::cl_RA>& r) { return f->recursion_at(degree, r); };
}

std::vector<Proof> band_proofs(const SharedFormulas& f) {
  return {
      {"quaternion-matrix", "M(q) v = q v q*, M(a) M(b) = M(ab), |ab| = |a| |b|", "polynomial identities", 0,
       kAnyDegree, kIndependent, "identities",
       [f](int) { return prove_quaternion_matrix(f->quaternion_matrix(), f->quaternion_product); }, true},
      {"equivariance", "GiNaC's definition of D satisfies Y_l(M(q) v) = D_l(q) Y_l(v), M(q) = |q|^2 R(q)",
       "polynomial identity in q and v over CLN rationals", kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion,
       "bands",
       [f](int degree) {
         return prove_equivariance(quaternion_bands(*f, degree), derive_basis(degree, f->basis),
                                   f->quaternion_matrix());
       }},
      {"rotation-orthogonal", "D(q) D(q)^T = |q|^(4l)", "polynomial identity in q", 6, 7, kExpanded, "bands",
       [f](int degree) { return prove_orthogonality(quaternion_bands(*f, degree)); }},
      {"rotation-composition", "D(ab) = D(a) D(b)",
       "polynomial identity in two quaternions (beyond: equivariance implies it)", 3, 4, kExpanded, "bands",
       [f](int degree) { return prove_composition(quaternion_bands(*f, degree)); }},
      {"recursion-tables", "x_i S_(l-1) = its couplings to S_l and r^2 dS_(l-1)/dx_i / (2l-1); scales of the columns",
       "polynomial identities", kMaxRecursionDegree, kMaxRecursionDegree, kExact, "bands",
       [f](int degree) {
         return prove_recursion_tables(derive_basis(degree, f->basis), {f->couplings, f->column_scale});
       }},
      {"quaternion-recursion", "GiNaC's definition of D_l(q) = recursion in R_ij at R_ij = M_ij(q)",
       "two derivations compared term by term", kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion, "bands",
       [f](int degree) {
         return prove_recursion_agrees(quaternion_bands(*f, degree), f->recursion(degree, f->quaternion_matrix()));
       }},
      {.name = "recursion-orthogonal",
       .statement = "D(R) D(R)^T = 1 for the recursion in R_ij",
       .method = "exact, at random rational rotations",
       .max_degree = kMaxRecursionDegree,
       .limit = kExact,
       .compared = "rational rotations",
       .run = [f](int degree) { return prove_orthogonality_at_points(recursion_at_points(f, degree), kPoints); },
       .spot_check = true},
      {.name = "recursion-composition",
       .statement = "D(ab) = D(a) D(b) for the recursion in R_ij",
       .method = "exact, at random rational rotations",
       .max_degree = kMaxRecursionDegree,
       .limit = kExact,
       .compared = "pairs of rational rotations",
       .run = [f](int degree) { return prove_composition_at_points(recursion_at_points(f, degree), kPoints); },
       .spot_check = true},
  };
}

std::vector<Proof> axis_proofs(const SharedFormulas& f) {
  return {
      {"about-z", "Y_l(R v) = D_l(R) Y_l(v) for the turn R by (c, s) about z", "polynomial identity in c, s and v",
       kMaxAxisDegree, kMaxAxisDegree, kExact, "bands",
       [f](int degree) { return prove_about_z(values_to(degree, f->about_z)); }},
      {"wigner-form", "GiNaC's definition of Ry(beta) = Wigner's d(beta) in the real basis",
       "two derivations compared term by term, in the half angle", kMaxAxisDegree, kMaxAxisDegree, kExact, "bands",
       [f](int degree) {
         return for_each_band(
             degree, [&](int l) { return prove_wigner_form(l, f->about_y(l), rotation_about_y_by_wigner(l)); });
       }},
      {"about-y", "GiNaC's definition of Ry(beta) = its quaternion form", "identity in the half angle",
       kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion, "bands",
       [f](int degree) {
         return for_each_band(degree, [&](int l) { return prove_about_y(f->rotation(l), f->about_y(l)); });
       }},
      {"x90", "the constant +-90 degree matrices about x", "quaternion (1,1,0,0), inverse, fourth power",
       kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion, "bands",
       [f](int degree) {
         return for_each_band(degree,
                              [&](int l) { return prove_x90(f->rotation(l), f->x90(l, true), f->x90(l, false)); });
       }},
      {"z-x90-z", "Ry(beta) = Rx(-90) Rz(beta) Rx(90)", "identity in the half angle", kMaxAxisDegree, kMaxAxisDegree,
       kExact, "bands",
       [f](int degree) {
         return for_each_band(degree, [&](int l) {
           return prove_z_x90_z(l, f->about_y(l), f->about_z(l), f->x90(l, true), f->x90(l, false));
         });
       }},
      {"zyz-angles", "Rz(alpha) Ry(beta) Rz(gamma) = R, beta = 0 and pi included", "identity in q and sqrt(h)", 0,
       kAnyDegree, kIndependent, "cases: every other rotation, both poles",
       [f](int) { return prove_zyz_angles(f->zyz_angles); }, true},
      {"euler-orders", "quaternion = product of three turns, twelve orders, two frames", "identity in the half angles",
       0, kAnyDegree, kIndependent, "pairs of an order and a frame", [f](int) { return prove_euler_orders(f->euler); },
       true},
      {"axis-angle", "Rodrigues' formula = quaternion of the half angle", "identity in half angle and axis", 0,
       kAnyDegree, kIndependent, "matrix", [f](int) { return prove_axis_angle(f->axis_angle); }, true},
  };
}

}  // namespace

std::vector<Proof> rotation_catalogue(const SharedFormulas& f) {
  std::vector<Proof> proofs = band_proofs(f);
  for (const Proof& proof : axis_proofs(f)) proofs.push_back(proof);
  return proofs;
}

}  // namespace sh::symbolic
