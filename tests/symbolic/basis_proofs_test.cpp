// Every proof about the basis holds, and is refuted by a small change of what it proves.
#include "symbolic/proofs/basis_proofs.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sh::symbolic {
namespace {

constexpr int kDegree = 4;
constexpr std::size_t kMutated = 18;  // l=4 m=-2

const cln::cl_RA& one_part_in_a_million() {
  static const cln::cl_RA value = cln::cl_RA(1'000'001) / 1'000'000;
  return value;
}

// The first term of p times 1 + 1e-6.
Polynomial nudged(const Polynomial& p) {
  Polynomial result = p;
  const auto& [monomial, coefficient] = *p.terms().begin();
  result.add_term(monomial, coefficient * (one_part_in_a_million() - 1));
  return result;
}

class BasisProofs : public ::testing::Test {
 protected:
  Basis basis_ = derive_basis(kDegree);
};

TEST_F(BasisProofs, AllHoldToDegreeFourteen) {
  for (const Proof& proof : basis_proofs()) {
    const ProofResult result = proof.run(14);
    EXPECT_TRUE(result.proved) << proof.name << ": " << result.detail;
    EXPECT_FALSE(result.detail.empty()) << proof.name;
  }
}

TEST_F(BasisProofs, RefuseDegreesBeyondTheBasis) {
  EXPECT_THROW(derive_basis(-1), std::invalid_argument);
  EXPECT_THROW(derive_basis(51), std::invalid_argument);
}

TEST_F(BasisProofs, OrthonormalityCatchesACoefficientOffByOnePartInAMillion) {
  basis_[kMutated].homogeneous = nudged(basis_[kMutated].homogeneous);
  EXPECT_FALSE(prove_orthonormality(basis_).proved);
}

TEST_F(BasisProofs, OrthonormalityCatchesAFactorOffByOnePartInAMillion) {
  basis_[kMutated].factor = basis_[kMutated].factor * Surd(one_part_in_a_million());
  EXPECT_FALSE(prove_orthonormality(basis_).proved);
  EXPECT_FALSE(prove_orthonormality_by_reduction(basis_).proved);
}

TEST_F(BasisProofs, OrthonormalityCatchesAFunctionGivenTwice) {
  basis_[kMutated] = basis_[kMutated + 1];
  EXPECT_FALSE(prove_orthonormality(basis_).proved);
}

TEST_F(BasisProofs, ReductionCatchesAxialAndAzimuthalChanges) {
  Basis axial = basis_;
  axial[kMutated].axial = nudged(axial[kMutated].axial);
  EXPECT_FALSE(prove_orthonormality_by_reduction(axial).proved);
  Basis azimuthal = basis_;
  azimuthal[kMutated].azimuthal = cln::cl_RA(-1) * azimuthal[kMutated].azimuthal;
  EXPECT_FALSE(prove_orthonormality_by_reduction(azimuthal).proved);
}

TEST_F(BasisProofs, HarmonicityCatchesACoefficientAndALowerTerm) {
  Basis coefficient = basis_;
  coefficient[kMutated].homogeneous = nudged(coefficient[kMutated].homogeneous);
  EXPECT_FALSE(prove_harmonicity(coefficient).proved);
  Basis lower = basis_;
  lower[kMutated].homogeneous.add_term({1, 0, 0}, 1);
  EXPECT_FALSE(prove_harmonicity(lower).proved);
}

TEST_F(BasisProofs, AdditionTheoremCatchesAFactorAndACoefficient) {
  Basis factor = basis_;
  factor[kMutated].factor = factor[kMutated].factor * Surd(one_part_in_a_million());
  EXPECT_FALSE(prove_addition_theorem(factor).proved);
  Basis coefficient = basis_;
  coefficient[kMutated].homogeneous = nudged(coefficient[kMutated].homogeneous);
  EXPECT_FALSE(prove_addition_theorem(coefficient).proved);
}

TEST_F(BasisProofs, EqualFormsCatchASignInOneOfThem) {
  basis_[kMutated].axial = cln::cl_RA(-1) * basis_[kMutated].axial;
  EXPECT_FALSE(prove_forms_agree(basis_).proved);
}

TEST_F(BasisProofs, EqualFormsCatchACoefficientOffByOnePartInAMillion) {
  basis_[kMutated].homogeneous = nudged(basis_[kMutated].homogeneous);
  EXPECT_FALSE(prove_forms_agree(basis_).proved);
}

TEST_F(BasisProofs, TheRecurrenceRefutesASpoiledDefinition) {
  const Basis other = derive_basis_by_recurrence(kDegree);
  Basis coefficient = basis_;
  coefficient[kMutated].axial = nudged(coefficient[kMutated].axial);
  EXPECT_FALSE(prove_derivations_agree(coefficient, other).proved);
  Basis factor = basis_;
  factor[kMutated].factor = -factor[kMutated].factor;
  EXPECT_FALSE(prove_derivations_agree(factor, other).proved);
  Basis index = basis_;
  std::swap(index[kMutated], index[kMutated + 1]);
  EXPECT_FALSE(prove_derivations_agree(index, other).proved);
}

TEST_F(BasisProofs, GradientsCatchAComponentAnAxisAndAHessianEntry) {
  const auto derivatives = derive_derivatives(basis_, BasisForm::kHomogeneous);
  auto component = derivatives;
  component[kMutated].gradient[1] = nudged(component[kMutated].gradient[1]);
  EXPECT_FALSE(prove_gradients(basis_, component).proved);
  auto axis = derivatives;
  std::swap(axis[kMutated].gradient[0], axis[kMutated].gradient[1]);
  EXPECT_FALSE(prove_gradients(basis_, axis).proved);
  auto entry = derivatives;
  entry[kMutated].hessian[3] = nudged(entry[kMutated].hessian[3]);
  EXPECT_FALSE(prove_gradients(basis_, entry).proved);
}

TEST_F(BasisProofs, TangentialGradientsCatchAComponent) {
  auto reduced = derive_derivatives(basis_, BasisForm::kReduced);
  const auto homogeneous = derive_derivatives(basis_, BasisForm::kHomogeneous);
  reduced[kMutated].gradient[0] = nudged(reduced[kMutated].gradient[0]);
  EXPECT_FALSE(prove_tangential_gradients(reduced, homogeneous).proved);
}

TEST(ReducedBasis, IsTheReducedFormOfTheBasis) {
  const Basis full = derive_basis(3);
  const Basis reduced = derive_reduced_basis(3);
  for (std::size_t i = 0; i < full.size(); ++i) {
    EXPECT_EQ(full[i].axial, reduced[i].axial);
    EXPECT_EQ(full[i].azimuthal, reduced[i].azimuthal);
    EXPECT_EQ(full[i].factor, reduced[i].factor);
  }
}

}  // namespace
}  // namespace sh::symbolic
