// Rotations where classic code loses digits: beside the identity and half turns, at tilts of exactly 0 and pi, at 2e-4,
// and at the worst tilt that a search finds. Largest error of an entry for |c| = 1, against Wigner's d in long double
// at the rotation nearest to the rounded matrix.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "numeric/methods/methods.hpp"
#include "numeric/methods/zxz_rows.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/numeric/extreme.hpp"
#include "tests/numeric/keep_worst.hpp"
#include "tests/numeric/unit_vectors.hpp"

namespace sh::numeric {
namespace {

using Wide = long double;
using Matrix = std::array<Wide, 9>;
constexpr Wide kPi = 3.14159265358979323846264338327950288L;

template <class Real>
struct Subject {
  const char* name;
  int degree;
  double limit;
  void (*rotate)(int degree, const Real* r, const Real* c, Real* out);
};

const Subject<double> kHigh = {"rotate_zxz_rows degree 100 double", 100, 1e-15, methods::rotate_zxz_rows<double>};
const Subject<float> kHighFloat = {"rotate_zxz_rows degree 100 float", 100, 7e-9, methods::rotate_zxz_rows<float>};
const Subject<double> kOracle = {"rotate degree 10 double", 10, 1e-15, rotate<double>};
const Subject<float> kOracleFloat = {"rotate degree 10 float", 10, 5e-7, rotate<float>};

template <class Real>
double error_of(const Subject<Real>& subject, const Matrix& exact) {
  std::array<Real, 9> r;
  for (std::size_t i = 0; i < 9; ++i) r[i] = static_cast<Real>(exact[i]);
  const auto c = unit_vector<Real>(subject.degree, 4);
  std::vector<Real> out(c.size());
  subject.rotate(subject.degree, r.data(), c.data(), out.data());
  const std::vector<Wide> wide(c.begin(), c.end());
  std::vector<Wide> expected(c.size());
  methods::rotate_wigner_d(subject.degree, nearest_rotation<Wide>(r.data()).data(), wide.data(), expected.data());
  double worst = 0;
  for (std::size_t i = 0; i < c.size(); ++i) keep_worst(worst, static_cast<double>(Wide{out[i]} - expected[i]));
  return worst;
}

struct Named {
  Matrix matrix;
  std::string name;
};

Named tilt(Wide alpha, Wide beta, Wide gamma) {
  return {tilted_turn(alpha, beta, gamma),
          fmt::format("Rz({:.17g}) Ry({:.17g}) Rz({:.17g})", static_cast<double>(alpha), static_cast<double>(beta),
                      static_cast<double>(gamma))};
}

Named turn(Wide x, Wide y, Wide z, Wide angle) {
  const Wide length = std::sqrt(x * x + y * y + z * z);
  return {axis_turn<Wide>(x / length, y / length, z / length, angle),
          fmt::format("{:.17g} about ({}, {}, {})", static_cast<double>(angle), static_cast<double>(x),
                      static_cast<double>(y), static_cast<double>(z))};
}

template <class Real>
void report(const Subject<Real>& subject, const std::string& where, const std::vector<Named>& rotations) {
  test::Worst worst;
  for (const auto& [matrix, name] : rotations) worst.keep(error_of(subject, matrix), "{}", name);
  worst.report(fmt::format("{}, {}", subject.name, where), subject.limit);
}

void report_all(const std::string& where, const std::vector<Named>& rotations) {
  report(kHigh, where, rotations);
  report(kHighFloat, where, rotations);
  report(kOracle, where, rotations);
  report(kOracleFloat, where, rotations);
}

TEST(ExtremeRotation, BesideTheIdentity) {
  report_all("1e-12 from the identity",
             {turn(1, 2, 3, 1e-12L), turn(0, 0, 1, -1e-12L), turn(1, 0, 0, 1e-12L), turn(3, -1, 0, 1e-300L)});
}

TEST(ExtremeRotation, BesideAHalfTurn) {
  report_all("1e-12 from a half turn", {turn(1, 2, 3, kPi - 1e-12L), turn(0, 0, 1, kPi + 1e-12L),
                                        turn(1, 0, 0, kPi - 1e-12L), turn(3, -1, 0, kPi)});
}

// The turns about z are chosen so that the matrix holds 0, 1 and -1 at the tilt exactly.
TEST(ExtremeRotation, AtTiltsOfExactlyZeroAndPi) {
  Named none = tilt(1.1L, 0, 0.3L);
  Named half = tilt(1.1L, kPi, 0.3L);
  for (Named* named : {&none, &half}) {
    for (const std::size_t i : {2U, 5U, 6U, 7U}) named->matrix[i] = 0;
    named->matrix[8] = named == &none ? 1 : -1;
  }
  report_all("tilt 0 or pi", {none, half});
}

TEST(ExtremeRotation, AtATiltOfTwoTenThousandths) {
  report_all("tilt 2e-4", {tilt(1.1L, 2e-4L, 0.3L), tilt(-2.5L, 2e-4L, 2.5L), tilt(0.4L, kPi - 2e-4L, -3.0L)});
}

// Steps towards larger errors, halved in size when they fail, from tilts of every size.
template <class Real>
void climb(const Subject<Real>& subject, int steps) {
  Random random(9);
  std::vector<Named> tops;
  for (const Wide start : {1e-9L, 1e-6L, 1e-4L, 1e-2L, 0.5L, 1.5L, 2.6L, kPi - 1e-3L}) {
    std::array<Wide, 3> best = {random.next(), start, random.next()};
    double highest = error_of(subject, tilted_turn(best[0], best[1], best[2]));
    Wide size = 0.5L;
    for (int step = 0; step < steps; ++step) {
      std::array<Wide, 3> next = best;
      for (Wide& angle : next) angle *= 1 + size * static_cast<Wide>(random.next());
      const double error = error_of(subject, tilted_turn(next[0], next[1], next[2]));
      if (error > highest) {
        highest = error;
        best = next;
      } else {
        size *= 0.8L;
      }
    }
    tops.push_back(tilt(best[0], best[1], best[2]));
  }
  report(subject, "worst tilt found", tops);
}

TEST(ExtremeRotation, AtTheWorstTiltFoundByClimbing) {
  climb(kHigh, 10);
  climb(kOracle, 150);
  climb(kOracleFloat, 150);
}

}  // namespace
}  // namespace sh::numeric
