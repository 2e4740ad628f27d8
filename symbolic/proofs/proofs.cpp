#include "symbolic/proofs/proofs.hpp"

#include "symbolic/convention/convention.hpp"
#include "symbolic/number/derivation.hpp"
#include "symbolic/proofs/identities.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

constexpr int kPoints = 3;

const char* const kSlowIntegrals = "exact integrals and expansions beyond take minutes";
const char* const kBasis = "the basis is derived to degree 50";
const char* const kExpanded = "the expanded polynomials take minutes beyond";
const char* const kQuaternion = "the quaternion form is derived to degree 10";
const char* const kExact = "closed forms and recursion are kept to degree 20, where exact entries stay small";
const char* const kIndependent = "does not depend on the degree";
const char* const kBands = "exact band matrices are kept to degree 20";
const char* const kSlowBands = "exact products of band matrices for every convention take minutes beyond";
const char* const kExponents = "exponents of the square of P_l stay below 128";
const char* const kFifthPower = "the tensor grows with the fifth power";
const char* const kSlowProducts = "products of polynomials of higher degree are slow to integrate";
const char* const kExpansion = "each product is multiplied out and expanded on up to 2 degree + 1 bands";

// The sum of prove(l) over the bands 0..degree.
template <class Prove>
int for_each_band(int degree, Prove prove) {
  int count = 0;
  for (int l = 0; l <= degree; ++l) count += prove(l);
  return count;
}

// The values of `of` at the degrees 0..degree.
template <class Of>
auto values_to(int degree, Of of) {
  std::vector<decltype(of(0))> values;
  for (int l = 0; l <= degree; ++l) values.push_back(of(l));
  return values;
}

BandsAt recursion_at_points(int degree) {
  return [degree](const Matrix<cln::cl_RA>& r) { return rotation_bands<cln::cl_RA>(degree, r, 1); };
}

// The sum of prove(convention, top) over the samples, at a low degree and at this one.
template <class Prove>
int for_each_sample(int degree, Prove prove) {
  int count = 0;
  for (const int top : {std::min(degree, 2), degree}) {
    for (const Convention& convention : sample_conventions(top)) count += prove(convention, top);
  }
  return count;
}

int prove_basis_changes(const Convention& convention, int degree) {
  for_each_band(degree, [&](int l) {
    return prove_basis_change(convention, l, basis_change(convention, l), basis_change_inverse(convention, l));
  });
  return 1;
}

int prove_round_trip(const Convention& convention, int degree) {
  return prove_there_and_back(convention_map({}, convention, degree), convention_map(convention, {}, degree));
}

// Each sample by way of the next one.
int prove_compositions(int degree) {
  const std::vector<Convention> samples = sample_conventions(degree);
  int count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Convention& middle = samples[i];
    const Convention& end = samples[(i + 1) % samples.size()];
    count += prove_through(convention_map({}, middle, degree), convention_map(middle, end, degree),
                           convention_map({}, end, degree));
  }
  return count;
}

// A function with every coefficient different: 1, 1/2, 1/3, ...
int prove_transfer_matrix_to(int degree) {
  std::vector<Surd> known;
  for (int k = 1; k <= coefficient_count(degree); ++k) known.emplace_back(cln::cl_RA(1) / k);
  const ProductShape shape{degree, degree, degree};
  return prove_transfer_matrix(transfer_matrix(known, shape), known, shape);
}

std::vector<Proof> basis_proofs() {
  return {
      {"basis-derivations",
       "GiNaC's definition of Y_lm (Rodrigues' formula) = recurrence over CLN rationals, factors included",
       "two derivations compared term by term", 20, kMaxBasisDegree, kBasis, "functions",
       [](int degree) {
         return prove_derivations_agree(derive_basis(degree), derive_basis(degree, basis_function_by_recurrence));
       }},
      {"orthonormality", "integral of Y_lm Y_l'm' over the sphere = 1 if equal, else 0",
       "exact integration of every pair, monomial by monomial", 20, 20, kSlowIntegrals, "pairs",
       [](int degree) { return prove_orthonormality(derive_basis(degree)); }},
      {"orthonormality-1d", "integral of Y_lm Y_l'm' over the sphere = 1 if equal, else 0",
       "reduced forms: orthogonal azimuthal parts, exact integrals in z", kMaxBasisDegree, kMaxBasisDegree, kBasis,
       "functions",
       [](int degree) { return prove_orthonormality_by_reduction(derive_basis(degree, reduced_basis_function)); }},
      {"harmonicity", "the homogeneous form has degree l and Laplacian 0", "exact differentiation", 10, kMaxBasisDegree,
       kBasis, "functions", [](int degree) { return prove_harmonicity(derive_basis(degree)); }},
      {"addition-theorem", "sum_m Y_lm(u) Y_lm(v) = (2l+1)/(4 pi) |u|^l |v|^l P_l(u.v/|u||v|)",
       "polynomial identity in u and v", 10, 20, kSlowIntegrals, "bands",
       [](int degree) { return prove_addition_theorem(derive_basis(degree)); }},
      {"forms-agree", "reduced form = homogeneous form on the unit sphere", "normal form modulo x^2+y^2+z^2 = 1", 10,
       kMaxBasisDegree, kBasis, "functions", [](int degree) { return prove_forms_agree(derive_basis(degree)); }},
      {"gradients", "s.grad S = l S, H s = (l-1) grad S, trace H = 0, grad S = its ladder to band l-1",
       "polynomial identities", 10, kMaxBasisDegree, kBasis, "functions",
       [](int degree) {
         const Basis basis = derive_basis(degree);
         return prove_gradients(basis, derive_derivatives(basis, BasisForm::kHomogeneous));
       }},
      {"tangential-gradients", "s x grad(reduced) = s x grad(homogeneous) on the unit sphere",
       "normal form modulo x^2+y^2+z^2 = 1", 10, 20, kSlowIntegrals, "functions",
       [](int degree) {
         const Basis basis = derive_basis(degree);
         return prove_tangential_gradients(derive_derivatives(basis, BasisForm::kReduced),
                                           derive_derivatives(basis, BasisForm::kHomogeneous));
       }},
  };
}

std::vector<Proof> rotation_proofs() {
  return {
      {"equivariance", "GiNaC's definition of D satisfies Y_l(M(q) v) = D_l(q) Y_l(v), M(q) = |q|^2 R(q)",
       "polynomial identity in q and v over CLN rationals", kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion,
       "bands",
       [](int degree) { return prove_equivariance(derive_quaternion_rotations(degree), derive_basis(degree)); }},
      {"rotation-orthogonal", "D(q) D(q)^T = |q|^(4l)", "polynomial identity in q", 6, 7, kExpanded, "bands",
       [](int degree) { return prove_orthogonality(derive_quaternion_rotations(degree)); }},
      {"rotation-composition", "D(ab) = D(a) D(b)",
       "polynomial identity in two quaternions (beyond: equivariance implies it, and the next lines test it)", 3, 4,
       kExpanded, "bands", [](int degree) { return prove_composition(derive_quaternion_rotations(degree)); }},
      {"quaternion-recursion", "GiNaC's definition of D_l(q) = recursion in R_ij at R_ij = M_ij(q)",
       "two derivations compared term by term", kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion, "bands",
       [](int degree) {
         return prove_recursion_agrees(derive_quaternion_rotations(degree),
                                       rotation_bands<Polynomial>(degree, quaternion_matrix(), Polynomial(1)));
       }},
      {"recursion-orthogonal", "D(R) D(R)^T = 1 for the recursion in R_ij", "exact, at random rational rotations", 10,
       kMaxRecursionDegree, kExact, "rational rotations",
       [](int degree) { return prove_orthogonality_at_points(recursion_at_points(degree), kPoints); }},
      {"recursion-composition", "D(ab) = D(a) D(b) for the recursion in R_ij", "exact, at random rational rotations",
       10, kMaxRecursionDegree, kExact, "pairs of rational rotations",
       [](int degree) { return prove_composition_at_points(recursion_at_points(degree), kPoints); }},
      {"about-z", "rotation about z = cos, sin of m alpha", "identity in the half angle", kMaxQuaternionDegree,
       kMaxQuaternionDegree, kQuaternion, "bands",
       [](int degree) {
         return for_each_band(degree, [](int l) { return prove_about_z(quaternion_rotation(l), rotation_about_z(l)); });
       }},
      {"wigner-form", "GiNaC's definition of Ry(beta) = Wigner's d(beta) in the real basis",
       "two derivations compared term by term, in the half angle", kMaxAxisDegree, kMaxAxisDegree, kExact, "bands",
       [](int degree) {
         return for_each_band(
             degree, [](int l) { return prove_wigner_form(l, rotation_about_y(l), rotation_about_y_by_wigner(l)); });
       }},
      {"about-y", "GiNaC's definition of Ry(beta) = its quaternion form", "identity in the half angle",
       kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion, "bands",
       [](int degree) {
         return for_each_band(degree, [](int l) { return prove_about_y(quaternion_rotation(l), rotation_about_y(l)); });
       }},
      {"x90", "the constant +-90 degree matrices about x", "quaternion (1,1,0,0), inverse, fourth power",
       kMaxQuaternionDegree, kMaxQuaternionDegree, kQuaternion, "bands",
       [](int degree) {
         return for_each_band(
             degree, [](int l) { return prove_x90(quaternion_rotation(l), rotation_x90(l), rotation_x90(l, false)); });
       }},
      {"z-x90-z", "Ry(beta) = Rx(-90) Rz(beta) Rx(90)", "identity in the half angle", 10, kMaxAxisDegree, kExact,
       "bands",
       [](int degree) {
         return for_each_band(degree, [](int l) {
           return prove_z_x90_z(l, rotation_about_y(l), rotation_about_z(l), rotation_x90(l), rotation_x90(l, false));
         });
       }},
      {"zyz-angles", "Rz(alpha) Ry(beta) Rz(gamma) = R, beta = 0 and pi included", "identity in q and sqrt(h)", 0, 50,
       kIndependent, "cases: every other rotation, both poles",
       [](int) { return prove_zyz_angles(zyz_from_azimuth<Polynomial>); }, true},
      {"euler-orders", "quaternion = product of three turns, twelve orders, two frames", "identity in the half angles",
       0, 50, kIndependent, "pairs of an order and a frame",
       [](int) { return prove_euler_orders(quaternion_from_euler<Polynomial>); }, true},
      {"axis-angle", "Rodrigues' formula = quaternion of the half angle", "identity in half angle and axis", 0, 50,
       kIndependent, "matrix", [](int) { return prove_axis_angle(matrix_from_axis_angle<Polynomial>); }, true},
  };
}

std::vector<Proof> convention_proofs() {
  return {
      {"complex-unitary", "Y_real = W Y_complex with W W* = 1, with and without the Condon-Shortley phase",
       "exact products", 10, kMaxConventionDegree, kBands, "matrices",
       [](int degree) {
         return for_each_band(degree, [](int l) {
           return prove_unitary(real_from_complex(l, false)) + prove_unitary(real_from_complex(l, true));
         });
       }},
      {"complex-rotation", "real rotation matrix = W D W*, D from Wigner's d", "exact, at a rational rotation", 10,
       kMaxConventionDegree, kBands, "bands",
       [](int degree) {
         return prove_complex_rotation(values_to(degree, [](int l) { return real_from_complex(l, true); }));
       }},
      {"axes", "Y_l(P s) = D_l(P) Y_l(s) for the 48 signed permutations P, D(PQ) = D(P) D(Q)",
       "substitution, exact products", 10, 10, "48 matrices with all products take minutes beyond",
       "pairs of a signed permutation and a band",
       [](int degree) { return for_each_band(degree, [](int l) { return prove_axes(axes_band, l); }); }},
      {"convention-functions", "A_l Y_l = the convention's functions written out, A_l A_l^-1 = 1",
       "polynomial identities, every preset and a spread of others", 10, 10, kSlowBands, "conventions",
       [](int degree) { return for_each_sample(degree, prove_basis_changes); }},
      {"convention-round-trip", "ours -> convention -> ours is the identity", "exact products, every preset and others",
       10, 10, kSlowBands, "conventions", [](int degree) { return for_each_sample(degree, prove_round_trip); }},
      {"convention-composition", "ours -> a -> b equals ours -> b", "exact products, every preset and others", 10, 10,
       kSlowBands, "triples", prove_compositions},
  };
}

std::vector<Proof> zonal_proofs() {
  std::vector<Proof> proofs;
  for (const ZonalFamily& family : zonal_families()) {
    proofs.push_back(
        {"zonal-" + family.name,
         "GiNaC's definition z_l = sqrt((2l+1) pi) integral f(t) P_l(t) dt, f = " + family.function + ", = closed form",
         "two derivations compared as functions of the parameters", 20, kMaxZonalDegree, kExponents, "coefficients",
         [&family](int degree) { return prove_zonal_family(family, zonal_coefficients(family, degree)); }});
  }
  proofs.push_back({"cap-complement", "cap + complement = 1", "coefficients as polynomials in c", 10, kMaxZonalDegree,
                    kExponents, "bands", [](int degree) {
                      return prove_cap_complement(zonal_coefficients(zonal_family("cap"), degree),
                                                  zonal_coefficients(zonal_family("cap-complement"), degree));
                    }});
  proofs.push_back({"irradiance-factors", "GiNaC's definition A_l = 2 pi integral_0^1 t P_l(t) dt = closed form",
                    "two derivations compared", 20, kMaxIrradianceDegree, "exponents stay below 128", "factors",
                    [](int degree) { return prove_irradiance_factors(values_to(degree, irradiance_factor)); }});
  proofs.push_back({"convolution-theorem", "integral Y_lm(s) h(s.n) ds = sqrt(4 pi / (2l+1)) h_l Y_lm(n), h = t^k",
                    "multinomial expansion, integrated term by term", 10, 20,
                    "every power of s.n is expanded for every function", "pairs of a function and a power of s.n",
                    [](int degree) { return prove_convolution(values_to(degree, convolution_factor)); }});
  proofs.push_back({"turned-zonal", "sum_m sqrt(4 pi / (2l+1)) Y_lm(d) Y_lm(s) = Y_l0(d.s)",
                    "identity of polynomials in (d, s)", 10, 20,
                    "the identity in two points has a number of terms that grows with the fourth power", "bands",
                    [](int degree) { return prove_turned_zonal(turned_zonal(degree)); }});
  return proofs;
}

std::vector<Proof> gaunt_proofs() {
  return {
      {"gaunt-tensor", "GiNaC's definition G_ijk = integral Y_i Y_j Y_k = Wigner 3j symbols",
       "two derivations compared entry by entry", kMaxGauntDegree, kMaxGauntDegree, kFifthPower, "entries",
       [](int degree) { return prove_gaunt_tensor(gaunt_tensor(degree), degree); }},
      {"gaunt-symmetry", "G_ijk does not change when its indices are permuted", "every order derived by itself",
       kMaxGauntDegree, kMaxGauntDegree, kFifthPower, "ordered entries",
       [](int degree) {
         return prove_gaunt_symmetry(product_form({degree, degree, degree}));
       }},
      {"gaunt-selection-rules", "G_ijk = 0 unless parity, triangle, signs and orders match",
       "the tensor by integration, which does not use the rules", kMaxGauntDegree, kMaxGauntDegree, kFifthPower,
       "entries", [](int degree) { return prove_gaunt_selection_rules(gaunt_tensor(degree)); }},
      {"product-identity", "Y_i Y_j = sum_k G_ijk Y_k on the sphere, k up to 2 degree + 1 bands",
       "polynomials modulo x^2+y^2+z^2 = 1", kMaxProductDegree, kMaxProductDegree, kExpansion, "products",
       [](int degree) {
         return prove_product_identity(product_form({degree, degree, 2 * degree}), degree);
       }},
      {"square-identity", "(sum_i a_i Y_i)^2 = sum_k c_k Y_k on the sphere, c = square_form(a)",
       "polynomials modulo x^2+y^2+z^2 = 1", kMaxProductDegree, kMaxProductDegree, kExpansion, "products",
       [](int degree) { return prove_square_identity(square_form(degree, 2 * degree), degree); }},
      {"zonal-product-identity", "Y_i Y_l0 = sum_k G Y_k on the sphere", "polynomials modulo x^2+y^2+z^2 = 1",
       kMaxProductDegree, kMaxProductDegree, kExpansion, "products",
       [](int degree) {
         return prove_zonal_product_identity(zonal_product_form({degree, degree, 2 * degree}), degree);
       }},
      {"transfer-matrix", "M_ij = integral b Y_i Y_j for a known function b",
       "sum of Gaunt entries against integration of monomials", 3, 6, kSlowProducts, "entries",
       prove_transfer_matrix_to},
  };
}

// The same entry; its run refuses degrees outside its range.
Proof with_range_check(Proof proof) {
  proof.run = [name = proof.name, max = proof.max_degree, limit = proof.limit, run = proof.run](int degree) {
    require_degree("proof " + name, degree, max, limit);
    return run(degree);
  };
  return proof;
}

}  // namespace

std::vector<Proof> all_proofs() {
  std::vector<Proof> all;
  for (const auto& area : {basis_proofs(), rotation_proofs(), convention_proofs(), zonal_proofs(), gaunt_proofs()}) {
    for (const Proof& proof : area) all.push_back(with_range_check(proof));
  }
  return all;
}

ProofResult run_proof(const Proof& proof, int degree) {
  try {
    return {true, std::to_string(proof.run(degree)) + " " + proof.compared};
  } catch (const Refuted& refuted) {
    return {false, refuted.what()};
  } catch (const std::exception& error) {
    return {false, std::string("stopped: ") + error.what()};
  }
}

}  // namespace sh::symbolic
