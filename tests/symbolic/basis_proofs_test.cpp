// A small change of a basis function refutes every proof about the basis.
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/symbolic/spoiled.hpp"

namespace sh::symbolic {
namespace {

using test::expect_refuted;
using test::negate;
using test::nudge;

constexpr int kDegree = 4;
constexpr int kSpoiled = 18;  // l=4 m=-2

TEST(Proofs, OfFunctionsAndZonalCoefficientsHoldToDegreeFourteen) {
  for (const Proof& proof : all_proofs()) {
    if (proof.compared != "functions" && proof.compared != "coefficients") continue;
    const ProofResult result = run_proof(proof, 14);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << proof.name << ": " << result.detail;
  }
}

TEST(BasisProofs, RefuseDegreesBeyondTheBasis) {
  EXPECT_THROW(derive_basis(-1), std::invalid_argument);
  EXPECT_THROW(derive_basis(51), std::invalid_argument);
}

void coefficient(Basis& basis) { nudge(basis[kSpoiled].homogeneous); }
void lower_term(Basis& basis) { basis[kSpoiled].homogeneous.add_term({1, 0, 0}, 1); }
void factor(Basis& basis) { nudge(basis[kSpoiled].factor); }
void factor_sign(Basis& basis) { negate(basis[kSpoiled].factor); }
void function_given_twice(Basis& basis) { basis[kSpoiled] = basis[kSpoiled + 1]; }
void exchanged_functions(Basis& basis) { std::swap(basis[kSpoiled], basis[kSpoiled + 1]); }
void axial_coefficient(Basis& basis) { nudge(basis[kSpoiled].axial); }
void axial_sign(Basis& basis) { negate(basis[kSpoiled].axial); }
void azimuthal_sign(Basis& basis) { negate(basis[kSpoiled].azimuthal); }

TEST(BasisProofs, CatchASmallChangeOfAFunction) {
  const Basis basis = derive_basis(kDegree);
  expect_refuted(basis, prove_orthonormality, {coefficient, factor, function_given_twice});
  expect_refuted(basis, prove_orthonormality_by_reduction, {factor, axial_coefficient, azimuthal_sign});
  expect_refuted(basis, prove_harmonicity, {coefficient, lower_term});
  expect_refuted(basis, prove_addition_theorem, {coefficient, factor});
  expect_refuted(basis, prove_forms_agree, {coefficient, axial_sign});
}

TEST(BasisProofs, TheRecurrenceRefutesASpoiledDefinition) {
  const Basis other = derive_basis(kDegree, basis_function_by_recurrence);
  expect_refuted(derive_basis(kDegree), [&](const Basis& basis) { prove_derivations_agree(basis, other); },
                 {axial_coefficient, factor_sign, exchanged_functions});
}

TEST(BasisProofs, CatchASmallChangeOfADerivative) {
  using Derivatives = std::vector<BasisDerivatives>;
  const Basis basis = derive_basis(kDegree);
  const Derivatives homogeneous = derive_derivatives(basis, BasisForm::kHomogeneous);
  expect_refuted(homogeneous, [&](const Derivatives& derivatives) { prove_gradients(basis, derivatives); },
                 {[](Derivatives& d) { nudge(d[kSpoiled].gradient[1]); },
                  [](Derivatives& d) { std::swap(d[kSpoiled].gradient[0], d[kSpoiled].gradient[1]); },
                  [](Derivatives& d) { nudge(d[kSpoiled].hessian[3]); }});
  expect_refuted(derive_derivatives(basis, BasisForm::kReduced),
                 [&](const Derivatives& reduced) { prove_tangential_gradients(reduced, homogeneous); },
                 {[](Derivatives& d) { nudge(d[kSpoiled].gradient[0]); }});
}

// What the cross product with s does not see: a multiple of s, and every second derivative.
TEST(BasisProofs, ReducedGradientsAreBoundToTheReducedForm) {
  using Derivatives = std::vector<BasisDerivatives>;
  const Basis basis = derive_basis(kDegree);
  const auto radial = [&](Derivatives& d) {
    for (int axis = 0; axis < 3; ++axis) {
      d[kSpoiled].gradient[axis] += Polynomial::variable(axis) * form_polynomial(basis[kSpoiled], BasisForm::kReduced);
    }
  };
  Derivatives tangential = derive_derivatives(basis, BasisForm::kReduced);
  radial(tangential);
  EXPECT_NO_THROW(prove_tangential_gradients(tangential, derive_derivatives(basis, BasisForm::kHomogeneous)));
  std::vector<test::Change<Derivatives>> changes{radial, [](Derivatives& d) { nudge(d[kSpoiled].gradient[0]); }};
  for (const int k : {0, 1, 2, 3, 4, 5}) {
    changes.emplace_back([k](Derivatives& d) { d[kSpoiled].hessian[k] += Polynomial(1); });
  }
  expect_refuted(
      derive_derivatives(basis, BasisForm::kReduced),
      [&](const Derivatives& reduced) { prove_reduced_gradients(basis, reduced); }, changes);
}

TEST(BasisProofs, FactorsCatchAValueASignAndAnInvertedRatio) {
  const Basis basis = derive_basis(kDegree);
  expect_refuted(Factors(), [&](const Factors& factors) { prove_factors(basis, factors); },
                 {[](Factors& f) {
                    f.factor = [](int l, int m) {
                      Surd k = orthonormal_factor(l, m);
                      if (l == 3 && m == -1) nudge(k);
                      return k;
                    };
                  },
                  [](Factors& f) { f.factor = [](int l, int m) { return -orthonormal_factor(l, m); }; },
                  [](Factors& f) { f.ratio = [](int l, int m, int n) { return factor_ratio(l, n, m); }; },
                  [](Factors& f) {
                    f.entries = [](int l, const Matrix<cln::cl_RA>& t) {
                      return surd_entries(l, t.transposed()).transposed();
                    };
                  }});
}

TEST(ReducedBasis, IsTheReducedFormOfTheBasis) {
  const Basis full = derive_basis(3);
  const Basis reduced = derive_basis(3, reduced_basis_function);
  for (std::size_t i = 0; i < full.size(); ++i) {
    EXPECT_EQ(full[i].axial, reduced[i].axial);
    EXPECT_EQ(full[i].azimuthal, reduced[i].azimuthal);
    EXPECT_EQ(full[i].factor, reduced[i].factor);
  }
}

}  // namespace
}  // namespace sh::symbolic
