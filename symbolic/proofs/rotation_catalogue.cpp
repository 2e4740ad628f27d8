// The catalogue of proofs about rotations: what is derived, how far, and why not further.
#include "symbolic/proofs/rotation_proofs.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

constexpr int kPoints = 3;

const char* const kExpanded = "the expanded polynomials take minutes beyond";
const char* const kQuaternion = "the quaternion form is derived to degree 10";
const char* const kExact = "closed forms and recursion are kept to degree 20, where exact entries stay small";
const char* const kIndependent = "does not depend on the degree";

BandsAt recursion_at_points(int degree) {
  return [degree](const Matrix<cln::cl_RA>& r) { return rotation_bands<cln::cl_RA>(degree, r, 1); };
}

// Runs a proof of one band for bands 0..degree.
template <class Prove>
ProofResult for_each_band(int degree, Prove prove) {
  for (int l = 0; l <= degree; ++l) {
    ProofResult result = prove(l);
    if (!result.proved) return result;
  }
  return proved(std::to_string(degree + 1) + " bands");
}

std::vector<Proof> outright_proofs() {
  return {
      {"equivariance", "GiNaC's definition of D satisfies Y_l(M(q) v) = D_l(q) Y_l(v), M(q) = |q|^2 R(q)",
       "polynomial identity in q and v over CLN rationals", kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion,
       [](int degree) { return prove_equivariance(derive_quaternion_rotations(degree), derive_basis(degree)); }},
      {"rotation-orthogonal", "D(q) D(q)^T = |q|^(4l)", "polynomial identity in q", 6, 7, kExpanded,
       [](int degree) { return prove_orthogonality(derive_quaternion_rotations(degree)); }},
      {"rotation-composition", "D(ab) = D(a) D(b)",
       "polynomial identity in two quaternions (beyond: equivariance implies it, and the next lines test it)", 3, 4,
       kExpanded, [](int degree) { return prove_composition(derive_quaternion_rotations(degree)); }},
      {"quaternion-recursion", "GiNaC's definition of D_l(q) = recursion in R_ij at R_ij = M_ij(q)",
       "two derivations compared term by term", kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion,
       [](int degree) {
         return prove_recursion_agrees(derive_quaternion_rotations(degree),
                                       rotation_bands<Polynomial>(degree, quaternion_matrix(), Polynomial(1)));
       }},
  };
}

std::vector<Proof> point_proofs() {
  return {
      {"recursion-orthogonal", "D(R) D(R)^T = 1 for the recursion in R_ij", "exact, at random rational rotations", 10,
       kMaxRecursionDegree, kExact,
       [](int degree) { return prove_orthogonality_at_points(recursion_at_points(degree), kPoints); }},
      {"recursion-composition", "D(ab) = D(a) D(b) for the recursion in R_ij", "exact, at random rational rotations",
       10, kMaxRecursionDegree, kExact,
       [](int degree) { return prove_composition_at_points(recursion_at_points(degree), kPoints); }},
  };
}

std::vector<Proof> axis_proofs() {
  return {
      {"about-z", "rotation about z = cos, sin of m alpha", "identity in the half angle", kMaxQuaternionDegree,
       kMaxQuaternionDegree, kQuaternion,
       [](int degree) {
         return for_each_band(degree, [](int l) { return prove_about_z(quaternion_rotation(l), rotation_about_z(l)); });
       }},
      {"wigner-form", "GiNaC's definition of Ry(beta) = Wigner's d(beta) in the real basis",
       "two derivations compared term by term, in the half angle", kMaxAxisDegree, kMaxAxisDegree, kExact,
       [](int degree) {
         return for_each_band(
             degree, [](int l) { return prove_wigner_form(l, rotation_about_y(l), rotation_about_y_by_wigner(l)); });
       }},
      {"about-y", "GiNaC's definition of Ry(beta) = its quaternion form", "identity in the half angle",
       kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion,
       [](int degree) {
         return for_each_band(degree, [](int l) { return prove_about_y(quaternion_rotation(l), rotation_about_y(l)); });
       }},
      {"x90", "the constant +-90 degree matrices about x", "quaternion (1,1,0,0), inverse, fourth power",
       kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion,
       [](int degree) {
         return for_each_band(
             degree, [](int l) { return prove_x90(quaternion_rotation(l), rotation_x90(l), rotation_x90(l, false)); });
       }},
      {"z-x90-z", "Ry(beta) = Rx(-90) Rz(beta) Rx(90)", "identity in the half angle", 10, kMaxAxisDegree, kExact,
       [](int degree) {
         return for_each_band(degree, [](int l) {
           return prove_z_x90_z(l, rotation_about_y(l), rotation_about_z(l), rotation_x90(l), rotation_x90(l, false));
         });
       }},
  };
}

std::vector<Proof> input_proofs() {
  return {
      {"zyz-angles", "Rz(alpha) Ry(beta) Rz(gamma) = R, beta = 0 and pi included", "identity in q and sqrt(h)", 0, 50,
       kIndependent, [](int) { return prove_zyz_angles(zyz_from_azimuth<Polynomial>); }, true},
      {"euler-orders", "quaternion = product of three turns, twelve orders, two frames", "identity in the half angles",
       0, 50, kIndependent, [](int) { return prove_euler_orders(quaternion_from_euler<Polynomial>); }, true},
      {"axis-angle", "Rodrigues' formula = quaternion of the half angle", "identity in half angle and axis", 0, 50,
       kIndependent, [](int) { return prove_axis_angle(matrix_from_axis_angle<Polynomial>); }, true},
  };
}

}  // namespace

std::vector<Proof> rotation_proofs() {
  std::vector<Proof> all;
  for (const auto& part : {outright_proofs(), point_proofs(), axis_proofs(), input_proofs()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace sh::symbolic
