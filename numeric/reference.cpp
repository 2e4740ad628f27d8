// See reference.hpp.
#include "numeric/reference.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "numeric/basis.hpp"
#include "numeric/decimal.hpp"
#include "numeric/real.hpp"

namespace sh::numeric {
namespace {

using Vector = std::array<Decimal, 3>;

void require_range(const std::string& name, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(name + " is " + std::to_string(value) + ", must be " + std::to_string(low) + " to " +
                              std::to_string(high));
}

Vector parse_direction(const std::array<std::string, 3>& text) {
  Vector direction = {parse_decimal("direction x", text[0]), parse_decimal("direction y", text[1]),
                      parse_decimal("direction z", text[2])};
  if (std::all_of(direction.begin(), direction.end(), [](const Decimal& d) { return d.is_zero(); })) {
    throw std::invalid_argument("direction: the zero vector has no direction");
  }
  return direction;
}

// Whether the homogeneous polynomial of Y_lm vanishes at the direction, modulo a prime. Scaling the direction by a
// power of ten makes it an integer vector, and with R_l = 1 and
//   R_(m-1) = 2 m z R_m - (l+m+1)(l-m) (x^2+y^2) R_(m+1),
// the recurrence of legendre.hpp freed of its roots and quotients, Y_lm is a positive multiple of R_|m| Re/Im
// (x+iy)^|m|.
bool vanishes_modulo(std::uint64_t prime, int degree, int order, const Vector& direction) {
  long lowest = direction[0].exponent;
  for (const auto& d : direction) lowest = std::min(lowest, d.exponent);
  const auto x = direction[0].modulo(prime, lowest);
  const auto y = direction[1].modulo(prime, lowest);
  const auto z = direction[2].modulo(prime, lowest);
  const auto u2 = (x * x + y * y) % prime;
  const auto l = static_cast<std::uint64_t>(degree);
  const auto lowest_order = static_cast<std::uint64_t>(std::abs(order));
  std::uint64_t current = 1;
  std::uint64_t above = 0;
  for (std::uint64_t m = l; m > lowest_order; --m) {
    const auto kept = 2 * m * z % prime * current % prime;
    const auto taken = (l + m + 1) * (l - m) % prime * u2 % prime * above % prime;
    above = current;
    current = (kept + prime - taken) % prime;
  }
  std::uint64_t real = 1;
  std::uint64_t imaginary = 0;
  for (std::uint64_t m = 0; m < lowest_order; ++m) {
    const auto next = (real * x + (prime - imaginary) * y) % prime;
    imaginary = (real * y + imaginary * x) % prime;
    real = next;
  }
  return current * (order < 0 ? imaginary : real) % prime == 0;
}

bool is_zero(int degree, int order, const Vector& direction) {
  constexpr std::array<std::uint64_t, 4> kPrimes = {2147483647, 2147483629, 2147483587, 2147483579};
  return std::all_of(kPrimes.begin(), kPrimes.end(),
                     [&](std::uint64_t prime) { return vanishes_modulo(prime, degree, order, direction); });
}

MpfrAny value_at(int degree, int order, const Vector& direction, int decimals) {
  const PrecisionScope scope(static_cast<unsigned>(decimals));
  const auto [x, y, z] =
      normalised(MpfrAny(direction[0].text()), MpfrAny(direction[1].text()), MpfrAny(direction[2].text()));
  return basis_value(degree, order, x, y, z);
}

std::string rounded(const MpfrAny& value, int digits) {
  std::vector<char> text(static_cast<std::size_t>(digits) + 64);
  mpfr_snprintf(text.data(), text.size(), "%.*Re", digits - 1, value.backend().data());
  return text.data();
}

// Whether two computations of one value, known not to be zero, agree to `digits` and 8 more. Where everything cancels
// they have nothing in common and this fails.
bool agree(const MpfrAny& a, const MpfrAny& b, int digits) {
  if (a == 0 || b == 0) return false;
  const MpfrAny relative = abs(MpfrAny((a - b) / b));
  return relative == 0 || relative < pow(MpfrAny(10), -digits - 8);
}

}  // namespace

std::string reference_value(int degree, int order, const std::array<std::string, 3>& direction, int digits) {
  require_range("degree", degree, 0, kMaxReferenceDegree);
  require_range("order", order, -degree, degree);
  require_range("digits", digits, 1, kMaxReferenceDigits);
  const Vector exact = parse_direction(direction);
  if (is_zero(degree, order, exact)) return "0";
  constexpr int kApart = 16;
  for (int guard = 16;; guard *= 2) {
    const MpfrAny value = value_at(degree, order, exact, digits + guard);
    const MpfrAny better = value_at(degree, order, exact, digits + guard + kApart);
    std::string text = rounded(better, digits);
    if (agree(value, better, digits) && rounded(value, digits) == text) return text;
  }
}

}  // namespace sh::numeric
