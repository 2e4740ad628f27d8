// See given_rotation.hpp.
#include "numeric/reference/given_rotation.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/oracle/surd.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/reference/decimal.hpp"

namespace sh::numeric {
namespace {

constexpr double kTolerance = 2e-3;  // of an entry of R R^T

template <std::size_t Count>
std::array<Decimal, Count> parse(const std::string& option, const std::array<std::string, Count>& text) {
  std::array<Decimal, Count> numbers;
  for (std::size_t i = 0; i < Count; ++i) numbers[i] = parse_decimal(option, text[i]);
  return numbers;
}

Rational exact(const Decimal& decimal) {
  const Integer scale = pow(Integer(10), static_cast<unsigned>(std::labs(decimal.exponent)));
  Integer digits(decimal.digits);
  if (decimal.negative) digits = -digits;
  return decimal.exponent < 0 ? Rational(digits, scale) : Rational(digits * scale);
}

MpfrAny rounded(const Decimal& decimal) { return MpfrAny(decimal.text()); }

MpfrAny rounded(const Integer& integer) {
  MpfrAny result;
  mpfr_set_z(result.backend().data(), integer.backend().data(), MPFR_RNDN);
  return result;
}

// Decimals that a number spans, from its first digit or the point to its last.
double span(const Decimal& decimal) {
  return decimal.is_zero()
             ? 0
             : static_cast<double>(decimal.digits.size()) + std::abs(static_cast<double>(decimal.exponent));
}

// A multiple of the quaternion of a rotation matrix, by the largest of the four ways, in which nothing cancels.
template <class Number>
std::array<Number, 4> quaternion_of(const std::array<Number, 9>& r) {
  const Number a = r[7] - r[5];
  const Number b = r[2] - r[6];
  const Number c = r[3] - r[1];
  const Number d = r[3] + r[1];
  const Number e = r[2] + r[6];
  const Number f = r[7] + r[5];
  const std::array<std::array<Number, 4>, 4> ways{{{1 + r[0] + r[4] + r[8], a, b, c},
                                                   {a, 1 + r[0] - r[4] - r[8], d, e},
                                                   {b, d, 1 - r[0] + r[4] - r[8], f},
                                                   {c, e, f, 1 - r[0] - r[4] + r[8]}}};
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (ways[i][i] > ways[best][best]) best = i;
  }
  return ways[best];
}

std::array<MpfrAny, 4> unit(std::array<MpfrAny, 4> q) {
  const MpfrAny length = sqrt(MpfrAny(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
  for (auto& component : q) component /= length;
  return q;
}

GivenRotation rational_rotation(const std::array<Rational, 4>& q) {
  Integer scale = 1;
  for (const auto& component : q) scale = lcm(scale, Integer(denominator(component)));
  std::array<Integer, 4> whole;
  Integer common = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    whole[i] = Integer(numerator(Rational(q[i] * Rational(scale))));
    common = gcd(common, whole[i]);
  }
  Integer square = 0;
  for (auto& component : whole) {
    component /= common;
    square += component * component;
  }
  GivenRotation rotation;
  rotation.quaternion = [whole] {
    return unit({rounded(whole[0]), rounded(whole[1]), rounded(whole[2]), rounded(whole[3])});
  };
  rotation.height = static_cast<double>(square.str().size());
  rotation.rational = true;
  return rotation;
}

// The orthogonal factor of r, which is close to one: X <- (X + X^-T) / 2, whose error is squared by each step.
std::array<MpfrAny, 9> nearest_rotation(std::array<MpfrAny, 9> r) {
  const MpfrAny small = sqrt(machine_epsilon<MpfrAny>()) / 4;
  for (MpfrAny change = 1; change > small;) {
    const MpfrAny scale = 1 / determinant(r);
    std::array<MpfrAny, 9> next;
    change = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto at = [&](std::size_t row, std::size_t column) { return r[3 * ((i + row) % 3) + (j + column) % 3]; };
        const MpfrAny cofactor = at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
        next[3 * i + j] = (at(0, 0) + cofactor * scale) / 2;
        change = std::max(change, MpfrAny(abs(MpfrAny(next[3 * i + j] - at(0, 0)))));
      }
    }
    r = next;
  }
  return r;
}

std::array<MpfrAny, 9> rounded(const std::array<Decimal, 9>& decimals) {
  std::array<MpfrAny, 9> result;
  std::transform(decimals.begin(), decimals.end(), result.begin(), [](const Decimal& d) { return rounded(d); });
  return result;
}

std::string scientific(double value) { return output::formatted("%.2g", value); }

void require_rotation(const std::string& option, const std::array<Decimal, 9>& decimals) {
  const PrecisionScope scope(50);
  const auto r = rounded(decimals);
  const auto distance = static_cast<double>(orthogonality_defect(r));
  if (!(distance <= kTolerance)) {
    throw std::invalid_argument(option + ": not a rotation: R R^T differs from the identity by " +
                                scientific(distance) + ", must be at most " + scientific(kTolerance));
  }
  if (determinant(r) < 0) throw std::invalid_argument(option + ": a reflection, determinant -1; must be a rotation, 1");
}

template <std::size_t Count>
double largest_span(const std::array<Decimal, Count>& decimals) {
  double largest = 0;
  for (const auto& decimal : decimals) largest = std::max(largest, span(decimal));
  return largest;
}

template <std::size_t Count>
void require_not_zero(const std::string& option, const std::array<Decimal, Count>& vector, const char* what) {
  if (std::all_of(vector.begin(), vector.end(), [](const Decimal& d) { return d.is_zero(); })) {
    throw std::invalid_argument(option + ": the zero " + what);
  }
}

}  // namespace

GivenRotation rotation_from_matrix(const std::string& option, const std::array<std::string, 9>& r) {
  const auto decimals = parse(option, r);
  require_rotation(option, decimals);
  std::array<Rational, 9> whole;
  std::transform(decimals.begin(), decimals.end(), whole.begin(), exact);
  if (orthogonality_defect(whole) == 0) return rational_rotation(quaternion_of(whole));
  GivenRotation rotation;
  rotation.quaternion = [decimals] { return unit(quaternion_of(nearest_rotation(rounded(decimals)))); };
  rotation.height = 1 + largest_span(decimals);
  const PrecisionScope scope(static_cast<unsigned>(rotation.height) + 50);
  const auto given = rounded(decimals);
  const auto nearest = nearest_rotation(given);
  MpfrAny square = 0;
  for (std::size_t i = 0; i < 9; ++i) square += (given[i] - nearest[i]) * (given[i] - nearest[i]);
  rotation.distance = static_cast<double>(MpfrAny(sqrt(square)));
  return rotation;
}

GivenRotation rotation_from_quaternion(const std::string& option, const std::array<std::string, 4>& q) {
  const auto decimals = parse(option, q);
  require_not_zero(option, decimals, "quaternion is no rotation");
  std::array<Rational, 4> whole;
  std::transform(decimals.begin(), decimals.end(), whole.begin(), exact);
  return rational_rotation(whole);
}

GivenRotation rotation_from_euler(const std::string& option, const std::array<std::string, 3>& angles) {
  const auto decimals = parse(option, angles);
  GivenRotation rotation;
  rotation.height = 1 + largest_span(decimals);
  rotation.quaternion = [decimals] {
    const MpfrAny sum = (rounded(decimals[0]) + rounded(decimals[2])) / 2;
    const MpfrAny difference = (rounded(decimals[0]) - rounded(decimals[2])) / 2;
    const MpfrAny tilt = rounded(decimals[1]) / 2;
    return std::array<MpfrAny, 4>{cos(tilt) * cos(sum), -sin(tilt) * sin(difference), sin(tilt) * cos(difference),
                                  cos(tilt) * sin(sum)};
  };
  return rotation;
}

GivenRotation rotation_from_axis(const std::string& option, const std::array<std::string, 3>& axis,
                                 const std::string& angle_option, const std::string& angle) {
  const auto decimals = parse(option, axis);
  const auto turn = parse_decimal(angle_option, angle);
  require_not_zero(option, decimals, "vector is no axis");
  GivenRotation rotation;
  rotation.height = 1 + std::max(largest_span(decimals), span(turn));
  rotation.quaternion = [decimals, turn] {
    const MpfrAny half = rounded(turn) / 2;
    auto q = unit({MpfrAny(0), rounded(decimals[0]), rounded(decimals[1]), rounded(decimals[2])});
    for (std::size_t i = 1; i < 4; ++i) q[i] *= sin(half);
    q[0] = cos(half);
    return q;
  };
  return rotation;
}

}  // namespace sh::numeric
