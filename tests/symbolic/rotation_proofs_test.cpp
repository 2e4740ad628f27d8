// A small change refutes every proof about rotations.
#include <gtest/gtest.h>

#include "symbolic/rotation/rotation_recursion.hpp"
#include "tests/symbolic/spoiled.hpp"

namespace sh::symbolic {
namespace {

using test::expect_refuted;
using test::millionth;
using test::negate;
using test::nudge;
using RationalMatrix = Matrix<cln::cl_RA>;
using PolynomialMatrix = Matrix<Polynomial>;
using Bands = std::vector<QuaternionRotation>;

constexpr int kDegree = 3;

void coefficient(Bands& bands) { nudge(bands.back().entries(0, 2)); }
void sign(Bands& bands) { negate(bands.back().entries(0, 2)); }
void transposition(Bands& bands) { bands.back().entries = bands.back().entries.transposed(); }

TEST(RotationProofs, CatchASmallChangeOfABand) {
  const Basis basis = derive_basis(kDegree);
  const auto recursion = rotation_bands<Polynomial>(kDegree, quaternion_matrix(), Polynomial(1));
  const Bands bands = derive_quaternion_rotations(kDegree);
  expect_refuted(bands, [&](const Bands& b) { prove_equivariance(b, basis); }, {coefficient, sign, transposition});
  expect_refuted(bands, prove_orthogonality, {coefficient, sign});
  expect_refuted(derive_quaternion_rotations(2), prove_composition, {coefficient, transposition});
  expect_refuted(bands, [&](const Bands& b) { prove_recursion_agrees(b, recursion); }, {coefficient});
}

TEST(RotationProofs, CatchASmallChangeOfTheOtherSide) {
  const Bands bands = derive_quaternion_rotations(kDegree);
  expect_refuted(derive_basis(kDegree), [&](const Basis& basis) { prove_equivariance(bands, basis); },
                 {[](Basis& basis) { nudge(basis.back().homogeneous); }});
  expect_refuted(rotation_bands<Polynomial>(kDegree, quaternion_matrix(), Polynomial(1)),
                 [&](const std::vector<PolynomialMatrix>& recursion) { prove_recursion_agrees(bands, recursion); },
                 {[](std::vector<PolynomialMatrix>& recursion) { nudge(recursion[2](0, 0)); }});
}

BandsAt spoiled_recursion(void (*spoil)(RationalMatrix& band)) {
  return [spoil](const RationalMatrix& r) {
    auto bands = rotation_bands<cln::cl_RA>(kDegree, r, 1);
    spoil(bands.back());
    return bands;
  };
}

TEST(RotationPointProofs, CatchAnEntryOffByOnePartInAMillionAndASign) {
  for (const auto spoil :
       {+[](RationalMatrix& band) { nudge(band(2, 5)); }, +[](RationalMatrix& band) { band(2, 5) = -band(2, 5); }}) {
    EXPECT_THROW(prove_orthogonality_at_points(spoiled_recursion(spoil), 1), Refuted);
    EXPECT_THROW(prove_composition_at_points(spoiled_recursion(spoil), 1), Refuted);
  }
}

TEST(RotationPointProofs, CompositionCatchesTheInverseRotation) {
  const BandsAt inverse = [](const RationalMatrix& r) {
    return rotation_bands<cln::cl_RA>(kDegree, r.transposed(), 1);
  };
  EXPECT_NO_THROW(prove_orthogonality_at_points(inverse, 1));
  EXPECT_THROW(prove_composition_at_points(inverse, 1), Refuted);
}

void transposed(PolynomialMatrix& m) { m = m.transposed(); }
void one_entry(PolynomialMatrix& m) { nudge(m(5, 5)); }

// The other turning sense.
void reversed(PolynomialMatrix& m) {
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < m.columns(); ++j) {
      if ((i + j) % 2 != 0) negate(m(i, j));
    }
  }
}

TEST(RotationProofs, CatchASmallChangeOfATurnAboutAnAxis) {
  const QuaternionRotation band = quaternion_rotation(kDegree);
  const PolynomialMatrix by_wigner = rotation_about_y_by_wigner(kDegree);
  using Turns = std::vector<PolynomialMatrix>;
  expect_refuted(Turns{rotation_about_z(0), rotation_about_z(1), rotation_about_z(2), rotation_about_z(3)},
                 prove_about_z,
                 {[](Turns& z) { one_entry(z[3]); }, [](Turns& z) { transposed(z[1]); },
                  [](Turns& z) { z[2](0, 1) = Polynomial::variable(0); }});
  expect_refuted(rotation_about_y(kDegree), [&](const PolynomialMatrix& y) { prove_about_y(band, y); },
                 {one_entry, reversed});
  expect_refuted(rotation_about_y(kDegree),
                 [&](const PolynomialMatrix& y) { prove_wigner_form(kDegree, y, by_wigner); }, {one_entry, reversed});
}

TEST(RotationProofs, TablesOfTheRecursionCatchAWeightAnIndexAndAScale) {
  const Basis basis = derive_basis(kDegree);
  const auto spoiled = [](void (*spoil)(std::vector<std::vector<Coupling>> & couplings)) {
    return [spoil](RecursionTables& tables) {
      tables.couplings = [spoil](int degree) {
        auto couplings = band_couplings(degree);
        spoil(couplings);
        return couplings;
      };
    };
  };
  expect_refuted(RecursionTables(), [&](const RecursionTables& tables) { prove_recursion_tables(basis, tables); },
                 {spoiled([](auto& couplings) { nudge(couplings[1][0].weight); }),
                  spoiled([](auto& couplings) { couplings[0][0].below = -couplings[0][0].below; }),
                  spoiled([](auto& couplings) { couplings[2].pop_back(); }), [](RecursionTables& tables) {
                    tables.scale = [](int degree, int column) -> cln::cl_RA {
                      return column_scale(degree, column) * (column == degree ? -1 : 1);
                    };
                  }});
}

TEST(RotationProofs, QuaternionsCatchAnExchangedProductAndATransposedMatrix) {
  expect_refuted(quaternion_matrix(),
                 [](const PolynomialMatrix& m) { prove_quaternion_matrix(m, quaternion_product<Polynomial>); },
                 {transposed, [](PolynomialMatrix& m) { nudge(m(1, 2)); }});
  expect_refuted(QuaternionProduct(quaternion_product<Polynomial>),
                 [](const QuaternionProduct& product) { prove_quaternion_matrix(quaternion_matrix(), product); },
                 {[](QuaternionProduct& product) {
                   product = [](const auto& a, const auto& b) { return quaternion_product<Polynomial>(b, a); };
                 }});
}

struct AxisTurns {
  PolynomialMatrix y = rotation_about_y(kDegree);
  PolynomialMatrix z = rotation_about_z(kDegree);
  RationalMatrix plus = rotation_x90(kDegree);
  RationalMatrix minus = rotation_x90(kDegree, false);
};

void exchanged(AxisTurns& turns) { std::swap(turns.plus, turns.minus); }

TEST(RotationProofs, CatchASmallChangeOfAQuarterTurn) {
  const QuaternionRotation band = quaternion_rotation(kDegree);
  expect_refuted(AxisTurns(), [&](const AxisTurns& turns) { prove_x90(band, turns.plus, turns.minus); },
                 {[](AxisTurns& turns) { turns.plus(3, 1) = turns.plus(3, 1) + millionth(); },
                  [](AxisTurns& turns) { turns.minus(2, 2) = turns.minus(2, 2) + millionth(); }, exchanged});
  expect_refuted(
      AxisTurns(), [](const AxisTurns& turns) { prove_z_x90_z(kDegree, turns.y, turns.z, turns.plus, turns.minus); },
      {[](AxisTurns& turns) { one_entry(turns.y); }, [](AxisTurns& turns) { transposed(turns.z); }, exchanged});
}

TEST(RotationInputProofs, ZyzAnglesCatchASignAndAnIndex) {
  const ZyzFormula formula = zyz_from_azimuth<Polynomial>;
  EXPECT_NO_THROW(prove_zyz_angles(formula));
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
  EXPECT_THROW(prove_zyz_angles(spoiled(sign)), Refuted);
  const auto beta = [](Angles& a, const Matrix<Polynomial>&, const Direction&) { negate(a.beta.sine); };
  EXPECT_THROW(prove_zyz_angles(spoiled(beta)), Refuted);
  const auto index = [](Angles& a, const Matrix<Polynomial>& r, const Direction& azimuth) {
    a.gamma.cosine = r(0, 0) * azimuth.cosine - r(0, 1) * azimuth.sine;
  };
  EXPECT_THROW(prove_zyz_angles(spoiled(index)), Refuted);
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
  try {
    prove_zyz_angles(last_row);
    FAIL();
  } catch (const Refuted& refuted) {
    EXPECT_NE(std::string(refuted.what()).find("pole"), std::string::npos) << refuted.what();
  }
}

TEST(RotationInputProofs, EulerOrdersCatchAnExchangedProductAndAWrongFrame) {
  const EulerFormula exchanged = [](std::string_view order, EulerFrame frame, const auto& halves) {
    auto q = quaternion_from_euler<Polynomial>(order, frame, halves);
    std::swap(q[1], q[2]);
    return q;
  };
  EXPECT_THROW(prove_euler_orders(exchanged), Refuted);
  const EulerFormula frames = [](std::string_view order, EulerFrame frame, const auto& halves) {
    const EulerFrame other = frame == EulerFrame::kIntrinsic ? EulerFrame::kExtrinsic : EulerFrame::kIntrinsic;
    return quaternion_from_euler<Polynomial>(order, other, halves);
  };
  EXPECT_THROW(prove_euler_orders(frames), Refuted);
}

TEST(RotationInputProofs, AxisAngleCatchesTheOtherTurningSenseAndACoefficient) {
  const AxisAngleFormula reversed = [](const auto& axis, const auto& angle, const auto& one) {
    return matrix_from_axis_angle<Polynomial>(axis, angle, one).transposed();
  };
  EXPECT_THROW(prove_axis_angle(reversed), Refuted);
  const AxisAngleFormula off = [](const auto& axis, const auto& angle, const auto& one) {
    auto m = matrix_from_axis_angle<Polynomial>(axis, angle, one);
    nudge(m(2, 2));
    return m;
  };
  EXPECT_THROW(prove_axis_angle(off), Refuted);
}

}  // namespace
}  // namespace sh::symbolic
