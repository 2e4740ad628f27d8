// See reference.hpp.
#include "numeric/reference.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "numeric/basis.hpp"
#include "numeric/correct_digits.hpp"
#include "numeric/decimal.hpp"
#include "numeric/legendre_reference.hpp"
#include "numeric/real.hpp"

namespace sh::numeric {
namespace {

using Vector = std::array<Decimal, 3>;

Vector parse_direction(const std::array<std::string, 3>& text) {
  Vector direction = {parse_decimal("direction x", text[0]), parse_decimal("direction y", text[1]),
                      parse_decimal("direction z", text[2])};
  if (std::all_of(direction.begin(), direction.end(), [](const Decimal& d) { return d.is_zero(); })) {
    throw std::invalid_argument("direction: the zero vector has no direction");
  }
  return direction;
}

// Whether the homogeneous polynomial of Y_lm vanishes at the direction, modulo a prime. Scaling the direction by a
// power of ten makes it an integer vector, and Y_lm is a positive multiple of R_|m| Re/Im (x+iy)^|m| with the R_m of
// reduced_legendre_modulo.
bool vanishes_modulo(std::uint64_t prime, int degree, int order, const Vector& direction) {
  long lowest = direction[0].exponent;
  for (const auto& d : direction) lowest = std::min(lowest, d.exponent);
  const auto x = direction[0].modulo(prime, lowest);
  const auto y = direction[1].modulo(prime, lowest);
  const auto z = direction[2].modulo(prime, lowest);
  const auto u2 = (x * x + y * y) % prime;
  const int size = std::abs(order);
  std::uint64_t real = 1;
  std::uint64_t imaginary = 0;
  for (int m = 0; m < size; ++m) {
    const auto next = (real * x + (prime - imaginary) * y) % prime;
    imaginary = (real * y + imaginary * x) % prime;
    real = next;
  }
  return reduced_legendre_modulo(prime, degree, size, z, u2) * (order < 0 ? imaginary : real) % prime == 0;
}

bool is_zero(int degree, int order, const Vector& direction) {
  return vanishes_modulo_primes([&](std::uint64_t prime) { return vanishes_modulo(prime, degree, order, direction); });
}

MpfrAny value_at(int degree, int order, const Vector& direction) {
  const auto [x, y, z] =
      normalised(MpfrAny(direction[0].text()), MpfrAny(direction[1].text()), MpfrAny(direction[2].text()));
  return basis_value(degree, order, x, y, z);
}

}  // namespace

std::string reference_value(int degree, int order, const std::array<std::string, 3>& direction, int digits) {
  require_range("degree", degree, 0, kMaxReferenceDegree);
  require_range("order", order, -degree, degree);
  require_range("digits", digits, 1, kMaxReferenceDigits);
  const Vector exact = parse_direction(direction);
  if (is_zero(degree, order, exact)) return "0";
  return correct_digits(digits, {[&](int /*decimals*/) { return value_at(degree, order, exact); }});
}

}  // namespace sh::numeric
