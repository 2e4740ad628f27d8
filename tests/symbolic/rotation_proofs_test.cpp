// Every proof about rotations holds, and is refuted by a small change of what it proves.
#include "symbolic/proofs/rotation_proofs.hpp"

#include <gtest/gtest.h>

#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::symbolic {
namespace {

using RationalMatrix = Matrix<cln::cl_RA>;

constexpr int kDegree = 3;
const cln::cl_RA& nudge() {
  static const cln::cl_RA value = cln::cl_RA(1) / 1'000'000;
  return value;
}

// The last term of an entry times 1 + 1e-6.
void nudge_entry(Polynomial& p) {
  const auto [monomial, coefficient] = *p.terms().rbegin();
  p.add_term(monomial, coefficient * nudge());
}

void negate(Polynomial& p) { p = cln::cl_RA(-1) * p; }

class RotationProofs : public ::testing::Test {
 protected:
  std::vector<QuaternionRotation> bands_ = derive_quaternion_rotations(kDegree);
  QuaternionRotation& last() { return bands_.back(); }
  Polynomial& entry() { return last().entries(1, 4); }
};

TEST_F(RotationProofs, AllHoldAtLowDegree) {
  for (const Proof& proof : rotation_proofs()) {
    const ProofResult result = proof.run(2);
    EXPECT_TRUE(result.proved) << proof.name << ": " << result.detail;
    EXPECT_FALSE(result.detail.empty()) << proof.name;
  }
}

TEST_F(RotationProofs, EquivarianceCatchesACoefficientASignAndATransposition) {
  const Basis basis = derive_basis(kDegree);
  ASSERT_TRUE(prove_equivariance(bands_, basis).proved);
  const auto good = bands_;
  nudge_entry(entry());
  EXPECT_FALSE(prove_equivariance(bands_, basis).proved);
  bands_ = good;
  negate(entry());
  EXPECT_FALSE(prove_equivariance(bands_, basis).proved);
  bands_ = good;
  last().entries = last().entries.transposed();
  EXPECT_FALSE(prove_equivariance(bands_, basis).proved);
}

TEST_F(RotationProofs, EquivarianceCatchesACoefficientOfTheBasis) {
  Basis basis = derive_basis(kDegree);
  nudge_entry(basis.back().homogeneous);
  EXPECT_FALSE(prove_equivariance(bands_, basis).proved);
}

TEST_F(RotationProofs, OrthogonalityCatchesACoefficientAndASign) {
  const auto good = bands_;
  nudge_entry(entry());
  EXPECT_FALSE(prove_orthogonality(bands_).proved);
  bands_ = good;
  negate(entry());
  EXPECT_FALSE(prove_orthogonality(bands_).proved);
}

TEST_F(RotationProofs, CompositionCatchesACoefficientAndATransposition) {
  bands_.resize(3);
  const auto good = bands_;
  nudge_entry(last().entries(0, 2));
  EXPECT_FALSE(prove_composition(bands_).proved);
  bands_ = good;
  last().entries = last().entries.transposed();  // composes the other way round
  EXPECT_FALSE(prove_composition(bands_).proved);
}

TEST_F(RotationProofs, ComparisonWithTheRecursionCatchesACoefficientOfEither) {
  auto recursion = rotation_bands<Polynomial>(kDegree, quaternion_matrix(), Polynomial(1));
  ASSERT_TRUE(prove_recursion_agrees(bands_, recursion).proved);
  const auto good = bands_;
  nudge_entry(entry());
  EXPECT_FALSE(prove_recursion_agrees(bands_, recursion).proved);
  nudge_entry(recursion[2](0, 0));
  EXPECT_FALSE(prove_recursion_agrees(good, recursion).proved);
}

BandsAt spoiled_recursion(void (*spoil)(RationalMatrix& band)) {
  return [spoil](const RationalMatrix& r) {
    auto bands = rotation_bands<cln::cl_RA>(kDegree, r, 1);
    spoil(bands.back());
    return bands;
  };
}

TEST(RotationPointProofs, CatchAnEntryOffByOnePartInAMillionAndASign) {
  for (const auto spoil : {+[](RationalMatrix& band) { band(2, 5) = band(2, 5) * (1 + nudge()); },
                           +[](RationalMatrix& band) { band(2, 5) = -band(2, 5); }}) {
    EXPECT_FALSE(prove_orthogonality_at_points(spoiled_recursion(spoil), 1).proved);
    EXPECT_FALSE(prove_composition_at_points(spoiled_recursion(spoil), 1).proved);
  }
}

TEST(RotationPointProofs, CompositionCatchesTheInverseRotation) {
  const BandsAt inverse = [](const RationalMatrix& r) {
    return rotation_bands<cln::cl_RA>(kDegree, r.transposed(), 1);
  };
  EXPECT_TRUE(prove_orthogonality_at_points(inverse, 1).proved);
  EXPECT_FALSE(prove_composition_at_points(inverse, 1).proved);
}

TEST_F(RotationProofs, AboutZCatchesACoefficientAndTheOtherTurningSense) {
  Matrix<Polynomial> z = rotation_about_z(kDegree);
  nudge_entry(z(0, 0));
  EXPECT_FALSE(prove_about_z(last(), z).proved);
  EXPECT_FALSE(prove_about_z(last(), rotation_about_z(kDegree).transposed()).proved);
}

TEST_F(RotationProofs, TurnsAboutYCatchACoefficientAndTheOtherTurningSense) {
  const Matrix<Polynomial> by_wigner = rotation_about_y_by_wigner(kDegree);
  Matrix<Polynomial> y = rotation_about_y(kDegree);
  ASSERT_TRUE(prove_wigner_form(kDegree, y, by_wigner).proved);
  ASSERT_TRUE(prove_about_y(last(), y).proved);
  nudge_entry(y(6, 5));
  EXPECT_FALSE(prove_wigner_form(kDegree, y, by_wigner).proved);
  EXPECT_FALSE(prove_about_y(last(), y).proved);
  Matrix<Polynomial> reversed = rotation_about_y(kDegree);
  for (int i = 0; i < reversed.rows(); ++i) {
    for (int j = 0; j < reversed.columns(); ++j) {
      if ((i + j) % 2 != 0) negate(reversed(i, j));
    }
  }
  EXPECT_FALSE(prove_wigner_form(kDegree, reversed, by_wigner).proved);
  EXPECT_FALSE(prove_about_y(last(), reversed).proved);
}

TEST_F(RotationProofs, QuarterTurnsCatchAnEntryAndAnExchange) {
  const RationalMatrix plus = rotation_x90(kDegree);
  const RationalMatrix minus = rotation_x90(kDegree, false);
  ASSERT_TRUE(prove_x90(last(), plus, minus).proved);
  RationalMatrix off = plus;
  off(3, 1) = off(3, 1) + nudge();
  EXPECT_FALSE(prove_x90(last(), off, minus).proved);
  EXPECT_FALSE(prove_x90(last(), minus, plus).proved);
  RationalMatrix off_minus = minus;
  off_minus(2, 2) = off_minus(2, 2) + nudge();
  EXPECT_FALSE(prove_x90(last(), plus, off_minus).proved);
}

TEST(RotationDecompositionProofs, ZX90ZCatchesACoefficientAnAngleAndAnExchange) {
  const Matrix<Polynomial> y = rotation_about_y(kDegree);
  const Matrix<Polynomial> z = rotation_about_z(kDegree);
  const RationalMatrix plus = rotation_x90(kDegree);
  const RationalMatrix minus = rotation_x90(kDegree, false);
  ASSERT_TRUE(prove_z_x90_z(kDegree, y, z, plus, minus).proved);
  Matrix<Polynomial> off = y;
  nudge_entry(off(5, 5));
  EXPECT_FALSE(prove_z_x90_z(kDegree, off, z, plus, minus).proved);
  EXPECT_FALSE(prove_z_x90_z(kDegree, y, z.transposed(), plus, minus).proved);
  EXPECT_FALSE(prove_z_x90_z(kDegree, y, z, minus, plus).proved);
}

TEST(RotationInputProofs, ZyzAnglesCatchASignAndAnIndex) {
  const ZyzFormula formula = zyz_from_azimuth<Polynomial>;
  ASSERT_TRUE(prove_zyz_angles(formula).proved);
  const auto spoiled = [&](auto spoil) {
    return [=](const Matrix<Polynomial>& r, const CosSin<Polynomial>& azimuth, const Polynomial& sin_beta) {
      auto angles = formula(r, azimuth, sin_beta);
      spoil(angles, r, azimuth);
      return angles;
    };
  };
  using Angles = ZyzAngles<Polynomial>;
  using Direction = CosSin<Polynomial>;
  const auto sign = [](Angles& a, const Matrix<Polynomial>&, const Direction&) { negate(a.gamma.sine); };
  EXPECT_FALSE(prove_zyz_angles(spoiled(sign)).proved);
  const auto beta = [](Angles& a, const Matrix<Polynomial>&, const Direction&) { negate(a.beta.sine); };
  EXPECT_FALSE(prove_zyz_angles(spoiled(beta)).proved);
  const auto index = [](Angles& a, const Matrix<Polynomial>& r, const Direction& azimuth) {
    a.gamma.cosine = r(0, 0) * azimuth.cosine - r(0, 1) * azimuth.sine;
  };
  EXPECT_FALSE(prove_zyz_angles(spoiled(index)).proved);
}

TEST(RotationInputProofs, ZyzAnglesCatchAFormulaWithAHoleAtThePoles) {
  // gamma from the last row, as printed in many places: right wherever sin(beta) is not 0, wrong at both poles.
  const ZyzFormula last_row = [](const Matrix<Polynomial>& r, const CosSin<Polynomial>& azimuth,
                                 const Polynomial& sin_beta) {
    auto angles = zyz_from_azimuth(r, azimuth, sin_beta);
    Polynomial norm;  // |q|^2, which scales gamma here
    for (int i = 0; i < 4; ++i) norm += Polynomial::variable(i).power(2);
    angles.gamma = {cln::cl_RA(-1) * (norm * r(2, 0)), norm * r(2, 1)};
    return angles;
  };
  const ProofResult result = prove_zyz_angles(last_row);
  EXPECT_FALSE(result.proved);
  EXPECT_NE(result.detail.find("pole"), std::string::npos) << result.detail;
}

TEST(RotationInputProofs, EulerOrdersCatchAnExchangedProductAndAWrongFrame) {
  const EulerFormula exchanged = [](std::string_view order, EulerFrame frame, const auto& halves) {
    auto q = quaternion_from_euler<Polynomial>(order, frame, halves);
    std::swap(q[1], q[2]);
    return q;
  };
  EXPECT_FALSE(prove_euler_orders(exchanged).proved);
  const EulerFormula frames = [](std::string_view order, EulerFrame frame, const auto& halves) {
    const EulerFrame other = frame == EulerFrame::kIntrinsic ? EulerFrame::kExtrinsic : EulerFrame::kIntrinsic;
    return quaternion_from_euler<Polynomial>(order, other, halves);
  };
  EXPECT_FALSE(prove_euler_orders(frames).proved);
}

TEST(RotationInputProofs, AxisAngleCatchesTheOtherTurningSenseAndACoefficient) {
  const AxisAngleFormula reversed = [](const auto& axis, const auto& angle, const auto& one) {
    return matrix_from_axis_angle<Polynomial>(axis, angle, one).transposed();
  };
  EXPECT_FALSE(prove_axis_angle(reversed).proved);
  const AxisAngleFormula off = [](const auto& axis, const auto& angle, const auto& one) {
    auto m = matrix_from_axis_angle<Polynomial>(axis, angle, one);
    nudge_entry(m(2, 2));
    return m;
  };
  EXPECT_FALSE(prove_axis_angle(off).proved);
}

}  // namespace
}  // namespace sh::symbolic
