// Every proof about conventions holds, and is refuted by a small change of what it proves.
#include "symbolic/proofs/convention_proofs.hpp"

#include <gtest/gtest.h>

#include "symbolic/convention/convention.hpp"
#include "symbolic/convention/presets.hpp"

namespace sh::symbolic {
namespace {

RadicalSum one_part_in_a_million() { return RadicalSum(cln::cl_RA(1'000'001) / 1'000'000); }

TEST(ConventionProofs, AllHoldAtLowDegree) {
  for (const Proof& proof : convention_proofs()) {
    const ProofResult result = proof.run(2);
    EXPECT_TRUE(result.proved) << proof.name << ": " << result.detail;
    EXPECT_FALSE(result.detail.empty()) << proof.name;
  }
}

TEST(ConventionProofs, UnitarityCatchesAnEntryAndASign) {
  auto w = real_from_complex(2, true);
  ASSERT_TRUE(prove_unitary(w).proved);
  w(1, 1) = w(1, 1) * one_part_in_a_million();
  EXPECT_FALSE(prove_unitary(w).proved);
  w = real_from_complex(2, true);
  w(1, 1) = -w(1, 1);
  EXPECT_FALSE(prove_unitary(w).proved);
}

TEST(ConventionProofs, ComplexRotationCatchesAMissingPhaseAndAConjugate) {
  const auto all = [](bool phase) {
    std::vector<Matrix<RadicalSum>> w;
    for (int l = 0; l <= 2; ++l) w.push_back(real_from_complex(l, phase));
    return w;
  };
  ASSERT_TRUE(prove_complex_rotation(all(true)).proved);
  EXPECT_FALSE(prove_complex_rotation(all(false)).proved);
  auto conjugated = all(true);
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) conjugated[2](i, j) = conjugated[2](i, j).conjugate();
  }
  EXPECT_FALSE(prove_complex_rotation(conjugated).proved);
}

TEST(ConventionProofs, AxesCatchAnEntryASignOfReflectionsAndTheInverse) {
  const AxesBand off = [](const SignedPermutation& axes, int degree) {
    auto band = axes_band(axes, degree);
    band(0, 1) = band(0, 1) + cln::cl_RA(1) / 1'000'000;
    return band;
  };
  EXPECT_FALSE(prove_axes(off, 2).proved);
  const AxesBand no_reflection = [](const SignedPermutation& axes, int degree) {
    auto band = axes_band(axes, degree);
    for (int i = 0; axes.determinant() < 0 && i < band.rows(); ++i) {
      for (int j = 0; j < band.columns(); ++j) band(i, j) = -band(i, j);
    }
    return band;
  };
  EXPECT_FALSE(prove_axes(no_reflection, 1).proved);
  const AxesBand inverse = [](const SignedPermutation& axes, int degree) { return axes_band(axes.inverse(), degree); };
  EXPECT_FALSE(prove_axes(inverse, 2).proved);
}

TEST(ConventionProofs, BasisChangeCatchesAnEntryAnotherConventionAndAWrongInverse) {
  const Convention c = find_preset("threejs").in_world();
  const auto change = basis_change(c, 2);
  const auto inverse = basis_change_inverse(c, 2);
  ASSERT_TRUE(prove_basis_change(c, 2, change, inverse).proved);
  auto off = change;
  off(2, 2) = off(2, 2) * one_part_in_a_million();
  EXPECT_FALSE(prove_basis_change(c, 2, off, inverse).proved);
  Convention phased = c;
  phased.condon_shortley = true;
  EXPECT_FALSE(prove_basis_change(phased, 2, change, inverse).proved);
  EXPECT_FALSE(prove_basis_change(c, 2, change, change).proved);
}

TEST(ConventionProofs, RoundTripCatchesAnEntryAnotherOrderAndAnotherConvention) {
  const Convention ours;
  const Convention other = find_preset("ambix").convention;
  const ConventionMap there = convention_map(ours, other, 2);
  const ConventionMap back = convention_map(other, ours, 2);
  ASSERT_TRUE(prove_there_and_back(there, back).proved);
  ConventionMap off = back;
  off.forward[2](1, 1) = off.forward[2](1, 1) * one_part_in_a_million();
  EXPECT_FALSE(prove_there_and_back(there, off).proved);
  EXPECT_FALSE(prove_there_and_back(there, convention_map(other, find_preset("directxmath").convention, 2)).proved);
  ConventionMap reordered = back;
  reordered.to_order = IndexOrder::kZeroFirst;
  EXPECT_FALSE(prove_there_and_back(there, reordered).proved);
}

TEST(ConventionProofs, CompositionCatchesAnEntryAndAnExchangedConvention) {
  const Convention a;
  const Convention b = find_preset("scipy").convention;
  const Convention c = find_preset("unreal").in_world();
  const ConventionMap direct = convention_map(a, c, 2);
  ASSERT_TRUE(prove_through(convention_map(a, b, 2), convention_map(b, c, 2), direct).proved);
  EXPECT_FALSE(prove_through(convention_map(a, b, 2), convention_map(b, a, 2), direct).proved);
  ConventionMap off = direct;
  off.forward[1](0, 2) = off.forward[1](0, 2) * one_part_in_a_million();
  EXPECT_FALSE(prove_through(convention_map(a, b, 2), convention_map(b, c, 2), off).proved);
}

}  // namespace
}  // namespace sh::symbolic
