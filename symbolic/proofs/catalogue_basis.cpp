#include "symbolic/proofs/catalogue.hpp"

namespace sh::symbolic {
namespace {

constexpr int kEmitted = 20;

const char* const kSlowIntegrals = "exact integrals and expansions beyond take minutes";
const char* const kBasis = "the basis is derived to degree 50";

std::vector<BasisDerivatives> derivatives_of(const Formulas& f, const Basis& basis, BasisForm form) {
  std::vector<BasisDerivatives> result;
  for (const BasisFunction& y : basis) result.push_back({f.gradient(y, form), f.hessian(y, form)});
  return result;
}

}  // namespace

std::vector<Proof> basis_catalogue(const SharedFormulas& f) {
  return {
      {"basis-derivations",
       "GiNaC's definition of Y_lm (Rodrigues' formula) = recurrence over CLN rationals, factors included",
       "two derivations compared term by term", kEmitted, kMaxBasisDegree, kBasis, "functions",
       [f](int degree) {
         return prove_derivations_agree(derive_basis(degree, f->basis),
                                        derive_basis(degree, basis_function_by_recurrence));
       }},
      {"orthonormality", "integral of Y_lm Y_l'm' over the sphere = 1 if equal, else 0",
       "exact integration of every pair, monomial by monomial", kEmitted, kEmitted, kSlowIntegrals, "pairs",
       [f](int degree) { return prove_orthonormality(derive_basis(degree, f->basis)); }},
      {"orthonormality-1d", "integral of Y_lm Y_l'm' over the sphere = 1 if equal, else 0",
       "reduced forms: orthogonal azimuthal parts, exact integrals in z", kMaxBasisDegree, kMaxBasisDegree, kBasis,
       "functions",
       [f](int degree) { return prove_orthonormality_by_reduction(derive_basis(degree, f->reduced_basis)); }},
      {"harmonicity", "the homogeneous form has degree l and Laplacian 0", "exact differentiation", kEmitted,
       kMaxBasisDegree, kBasis, "functions",
       [f](int degree) { return prove_harmonicity(derive_basis(degree, f->basis)); }},
      {"addition-theorem", "sum_m Y_lm(u) Y_lm(v) = (2l+1)/(4 pi) |u|^l |v|^l P_l(u.v/|u||v|)",
       "polynomial identity in u and v", kEmitted, kEmitted, kSlowIntegrals, "bands",
       [f](int degree) { return prove_addition_theorem(derive_basis(degree, f->basis)); }},
      {"forms-agree", "reduced form = homogeneous form on the unit sphere", "normal form modulo x^2+y^2+z^2 = 1",
       kEmitted, kMaxBasisDegree, kBasis, "functions",
       [f](int degree) { return prove_forms_agree(derive_basis(degree, f->basis)); }},
      {"gradients", "s.grad S = l S, trace H = 0, grad S and H = their ladders to the bands l-1 and l-2",
       "polynomial identities", kEmitted, kMaxBasisDegree, kBasis, "functions",
       [f](int degree) {
         const Basis basis = derive_basis(degree, f->basis);
         return prove_gradients(basis, derivatives_of(*f, basis, BasisForm::kHomogeneous), f->ladder);
       }},
      {"reduced-gradients", "gradient and Hessian of q(z) Re or Im (x+iy)^a = the product rule",
       "polynomial identities", kEmitted, kMaxBasisDegree, kBasis, "functions",
       [f](int degree) {
         const Basis basis = derive_basis(degree, f->basis);
         return prove_reduced_gradients(basis, derivatives_of(*f, basis, BasisForm::kReduced));
       }},
      {"tangential-gradients", "s x grad(reduced) = s x grad(homogeneous) on the unit sphere",
       "normal form modulo x^2+y^2+z^2 = 1", kEmitted, kEmitted, kSlowIntegrals, "functions",
       [f](int degree) {
         const Basis basis = derive_basis(degree, f->basis);
         return prove_tangential_gradients(derivatives_of(*f, basis, BasisForm::kReduced),
                                           derivatives_of(*f, basis, BasisForm::kHomogeneous));
       }},
      {"factors", "k_lm > 0, k_lm^2 integral S_lm^2 = 1, D_mn = (k_m / k_n) T_mn", "exact integration", kEmitted,
       kMaxBasisDegree, kBasis, "functions",
       [f](int degree) {
         return prove_factors(derive_basis(degree, reduced_basis_function),
                              {f->factor, f->factor_ratio, f->surd_entries});
       }},
  };
}

}  // namespace sh::symbolic
