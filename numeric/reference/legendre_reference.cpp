// Legendre functions and caps; see reference.hpp.
#include <algorithm>
#include <stdexcept>

#include "numeric/oracle/legendre_values.hpp"
#include "numeric/oracle/zonal.hpp"
#include "numeric/reference/decimal.hpp"
#include "numeric/reference/reference.hpp"

namespace sh::numeric {
namespace {

using Kind = Colatitude::Kind;

// A colatitude at the present precision, and its properties that are exactly known.
class Point {
 public:
  struct Values {
    MpfrAny z, sine, depth;  // depth: 1 - z
  };

  explicit Point(const Colatitude& colatitude)
      : kind_(colatitude.kind), decimal_(parse_decimal(colatitude.name, colatitude.text)) {
    if (in_domain()) return;
    const char* domain = kind_ == Kind::kCosine ? "-1 to 1" : (kind_ == Kind::kAngle ? "0 to pi" : "0 to 2");
    throw std::invalid_argument(colatitude.name + ": expected " + domain + ", got " + shortened(colatitude.text));
  }

  [[nodiscard]] Values values() const {
    const MpfrAny given = exact();
    switch (kind_) {
      case Kind::kCosine:
        return {given, sqrt(MpfrAny((1 - given) * (1 + given))), 1 - given};
      case Kind::kAngle:
        return {cos(given), sin(given), one_minus_cos(given)};
      default:
        return {1 - given, sqrt(MpfrAny(given * (2 - given))), given};
    }
  }

  [[nodiscard]] bool is_north_pole() const { return kind_ == Kind::kCosine ? equals(1) : decimal_.is_zero(); }
  [[nodiscard]] bool is_south_pole() const {
    return kind_ == Kind::kCosine ? equals(-1) : kind_ == Kind::kOneMinusCos && equals(2);
  }
  // Whether Q_lm vanishes. The cosine of an angle other than 0 is transcendental (Lindemann) and no root of it.
  [[nodiscard]] bool is_zero_of(int degree, int order) const {
    if (kind_ == Kind::kAngle) return false;
    return vanishes_modulo_primes([&](std::uint64_t prime) {
      const long lowest = std::min(decimal_.exponent, 0L);
      const auto one = Decimal{false, "1", 0}.modulo(prime, lowest);
      const auto given = decimal_.modulo(prime, lowest);
      const auto z = kind_ == Kind::kCosine ? given : (one + prime - given) % prime;
      const auto u2 = (one * one + (prime - z) * z) % prime;
      return reduced_legendre_modulo(prime, degree, order, z, u2) == 0;
    });
  }

 private:
  // Compared with enough digits to tell them apart.
  [[nodiscard]] MpfrAny exact() const { return MpfrAny(decimal_.text()); }
  [[nodiscard]] unsigned decimals() const { return static_cast<unsigned>(decimal_.digits.size()) + 20; }
  [[nodiscard]] bool equals(int n) const {
    const PrecisionScope scope(decimals());
    return exact() == n;
  }
  [[nodiscard]] bool in_domain() const {
    const PrecisionScope scope(decimals());
    const MpfrAny value = exact();
    if (kind_ == Kind::kCosine) return value >= -1 && value <= 1;
    return value >= 0 && value <= (kind_ == Kind::kAngle ? pi<MpfrAny>() : MpfrAny(2));
  }

  Kind kind_;
  Decimal decimal_;
};

}  // namespace

std::uint64_t reduced_legendre_modulo(std::uint64_t prime, int degree, int order, std::uint64_t z, std::uint64_t u2) {
  const auto l = static_cast<std::uint64_t>(degree);
  const auto lowest = static_cast<std::uint64_t>(order);
  std::uint64_t current = 1;
  std::uint64_t above = 0;
  for (std::uint64_t m = l; m > lowest; --m) {
    const auto kept = 2 * m * z % prime * current % prime;
    const auto taken = (l + m + 1) * (l - m) % prime * u2 % prime * above % prime;
    above = current;
    current = (kept + prime - taken) % prime;
  }
  return current;
}

std::string legendre_reference(int degree, int order, const Colatitude& colatitude, int digits) {
  require_range("degree", degree, 0, kMaxReferenceDegree);
  require_range("order", order, 0, degree);
  require_range("digits", digits, 1, kMaxReferenceDigits);
  const Point point(colatitude);
  const bool at_pole = point.is_north_pole() || point.is_south_pole();
  if ((order > 0 && at_pole) || point.is_zero_of(degree, order)) return "0";
  return correct_digits(digits, {[&](int /*decimals*/) {
                          const auto [z, sine, depth] = point.values();
                          return legendre_value(degree, order, z, sine);
                        }});
}

std::string cap_reference(int degree, const Colatitude& half_angle, int digits) {
  require_range("degree", degree, 0, kMaxReferenceDegree);
  require_range("digits", digits, 1, kMaxReferenceDigits);
  const Point point(half_angle);
  if (point.is_north_pole()) return "0";
  if (degree == 0) {
    return correct_digits(digits,
                          {[&](int /*decimals*/) { return MpfrAny(sqrt(pi<MpfrAny>()) * point.values().depth); }});
  }
  if (point.is_south_pole() || point.is_zero_of(degree, 1)) return "0";
  return correct_digits(digits, {[&](int /*decimals*/) {
                          const auto [z, sine, depth] = point.values();
                          const MpfrAny scale = 2 * pi<MpfrAny>() / sqrt(MpfrAny(degree) * (degree + 1));
                          return MpfrAny(scale * sine * legendre_value(degree, 1, z, sine));
                        }});
}

}  // namespace sh::numeric
