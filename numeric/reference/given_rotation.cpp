// Rotations as the user writes them; see rotation_reference.hpp.
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <stdexcept>

#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/oracle/surd.hpp"
#include "numeric/output/formatted.hpp"
#include "numeric/reference/decimal.hpp"
#include "numeric/reference/rotation_reference.hpp"

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
  if (decimal.is_zero()) return 0;
  return static_cast<double>(decimal.digits.size()) + std::abs(static_cast<double>(decimal.exponent));
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
  for (int i = 0; i < 4; ++i) {
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

// To all digits of the present precision: each step squares an error of at most kTolerance.
std::array<MpfrAny, 9> nearest(const std::array<MpfrAny, 9>& r) {
  std::array<MpfrAny, 9> result;
  nearest_rotation(r.data(), result.data(), std::bit_width(MpfrAny::default_precision()));
  return result;
}

std::array<MpfrAny, 9> rounded(const std::array<Decimal, 9>& decimals) {
  std::array<MpfrAny, 9> result;
  std::transform(decimals.begin(), decimals.end(), result.begin(), [](const Decimal& d) { return rounded(d); });
  return result;
}

void require_rotation(const std::string& option, const std::array<Decimal, 9>& decimals) {
  const PrecisionScope scope(50);
  const auto r = rounded(decimals);
  const auto distance = static_cast<double>(orthogonality_defect(r));
  if (!(distance <= kTolerance)) {
    throw std::invalid_argument(
        option + output::formatted(": expected a rotation, |R R^T - 1| at most %.2g, got %.2g", kTolerance, distance));
  }
  if (determinant(r) < 0) {
    throw std::invalid_argument(option + ": expected a rotation, determinant 1, got a reflection, -1");
  }
}

template <std::size_t Count>
double largest_span(const std::array<Decimal, Count>& decimals) {
  double largest = 0;
  for (const auto& decimal : decimals) largest = std::max(largest, span(decimal));
  return largest;
}

template <std::size_t Count>
void require_not_zero(const std::string& option, const std::array<Decimal, Count>& vector) {
  if (std::all_of(vector.begin(), vector.end(), [](const Decimal& d) { return d.is_zero(); })) {
    throw std::invalid_argument(option + ": expected a number that is not zero, got zeros only");
  }
}

}  // namespace

GivenRotation rotation_from_matrix(const std::string& option, const std::array<std::string, 9>& r) {
  const auto decimals = parse(option, r);
  require_rotation(option, decimals);
  std::array<Rational, 9> whole;
  std::transform(decimals.begin(), decimals.end(), whole.begin(), exact);
  if (orthogonality_defect(whole) == 0) return rational_rotation(quaternion_multiple(whole.data()));
  GivenRotation rotation;
  rotation.quaternion = [decimals] {
    std::array<MpfrAny, 4> q;
    quaternion_of_matrix(nearest(rounded(decimals)).data(), q.data());
    return unit(q);
  };
  rotation.height = 1 + largest_span(decimals);
  const PrecisionScope scope(static_cast<unsigned>(rotation.height) + 50);
  const auto given = rounded(decimals);
  const auto taken = nearest(given);
  MpfrAny square = 0;
  for (int i = 0; i < 9; ++i) square += (given[i] - taken[i]) * (given[i] - taken[i]);
  rotation.distance = static_cast<double>(MpfrAny(sqrt(square)));
  return rotation;
}

GivenRotation rotation_from_quaternion(const std::string& option, const std::array<std::string, 4>& q) {
  const auto decimals = parse(option, q);
  require_not_zero(option, decimals);
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
  require_not_zero(option, decimals);
  GivenRotation rotation;
  rotation.height = 1 + std::max(largest_span(decimals), span(turn));
  rotation.quaternion = [decimals, turn] {
    const MpfrAny half = rounded(turn) / 2;
    auto q = unit({MpfrAny(0), rounded(decimals[0]), rounded(decimals[1]), rounded(decimals[2])});
    for (int i = 1; i < 4; ++i) q[i] *= sin(half);
    q[0] = cos(half);
    return q;
  };
  return rotation;
}

}  // namespace sh::numeric
