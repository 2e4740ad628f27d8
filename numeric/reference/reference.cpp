// Spherical harmonics and their gradients; see reference.hpp.
#include "numeric/reference/reference.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "numeric/oracle/basis.hpp"
#include "numeric/reference/decimal.hpp"

namespace sh::numeric {
namespace {

using Vector = std::array<Decimal, 3>;

Vector parse_direction(const std::array<std::string, 3>& text) {
  Vector direction = {parse_decimal("direction x", text[0]), parse_decimal("direction y", text[1]),
                      parse_decimal("direction z", text[2])};
  if (std::all_of(direction.begin(), direction.end(), [](const Decimal& d) { return d.is_zero(); })) {
    throw std::invalid_argument("direction: expected a vector that is not zero, got zeros");
  }
  return direction;
}

// A complex integer modulo a prime below 2^31.
struct Residue {
  std::uint64_t real, imaginary;
};

// The solid harmonics at a direction, modulo a prime, up to positive factors. Scaling the direction by a power of ten
// makes it an integer vector.
class Residues {
 public:
  Residues(std::uint64_t prime, const Vector& direction) : prime_(prime) {
    const auto lowest = std::min({direction[0].exponent, direction[1].exponent, direction[2].exponent});
    x_ = direction[0].modulo(prime, lowest);
    y_ = direction[1].modulo(prime, lowest);
    z_ = direction[2].modulo(prime, lowest);
  }

  // R_m (x+iy)^m with the R_m of reduced_legendre_modulo, which is Y_l^m / N_lm of legendre.hpp; 0 unless 0 <= m <= l.
  [[nodiscard]] Residue value(int degree, int m) const {
    if (m < 0 || m > degree) return {0, 0};
    Residue power{1, 0};
    for (int i = 0; i < m; ++i) {
      power = {(power.real * x_ + (prime_ - power.imaginary) * y_) % prime_,
               (power.real * y_ + power.imaginary * x_) % prime_};
    }
    return times(reduced_legendre_modulo(prime_, degree, m, z_, (x_ * x_ + y_ * y_) % prime_), power);
  }

  // d/dx, d/dy or d/dz (axis 0, 1, 2) of Y_l^m, m >= 0. From gradient_impl.hpp, with the N_lm written out: up to
  // common factors d/dx = A - B, d/dy = i (A + B), A of order m - 1, B = (l-m)(l-m-1) times that of order m + 1.
  [[nodiscard]] Residue derivative(int axis, int degree, int m) const {
    const auto rest = static_cast<std::uint64_t>(degree - m);
    if (rest == 0 && axis == 2) return {0, 0};
    if (axis == 2) return value(degree - 1, m);
    const Residue a = value(degree - 1, m - 1);
    const Residue b = rest == 0 ? Residue{0, 0} : times(rest * (rest - 1), value(degree - 1, m + 1));
    if (axis == 0) return {minus(a.real, b.real), minus(a.imaginary, b.imaginary)};
    return {minus(prime_ - a.imaginary, b.imaginary), (a.real + b.real) % prime_};
  }

 private:
  [[nodiscard]] std::uint64_t minus(std::uint64_t a, std::uint64_t b) const { return (a + prime_ - b) % prime_; }
  [[nodiscard]] Residue times(std::uint64_t factor, const Residue& a) const {
    return {factor * a.real % prime_, factor * a.imaginary % prime_};
  }

  std::uint64_t prime_;
  std::uint64_t x_ = 0, y_ = 0, z_ = 0;
};

// Whether the cosine (order >= 0) or sine part of a complex value vanishes; compute(Residues).
template <class Compute>
bool is_zero(int order, const Vector& direction, const Compute& compute) {
  return vanishes_modulo_primes([&](std::uint64_t prime) {
    const Residue value = compute(Residues(prime, direction));
    return (order < 0 ? value.imaginary : value.real) == 0;
  });
}

std::array<MpfrAny, 3> unit(const Vector& direction) {
  return normalized(MpfrAny(direction[0].text()), MpfrAny(direction[1].text()), MpfrAny(direction[2].text()));
}

Vector checked(int degree, int order, const std::array<std::string, 3>& direction, int digits) {
  require_range("degree", degree, 0, kMaxReferenceDegree);
  require_range("order", order, -degree, degree);
  require_range("digits", digits, 1, kMaxReferenceDigits);
  return parse_direction(direction);
}

}  // namespace

std::string reference_value(int degree, int order, const std::array<std::string, 3>& direction, int digits) {
  const Vector exact = checked(degree, order, direction, digits);
  const int m = std::abs(order);
  if (is_zero(order, exact, [&](const Residues& residues) { return residues.value(degree, m); })) return "0";
  return correct_digits(digits, {[&](int /*decimals*/) {
                          const auto [x, y, z] = unit(exact);
                          return basis_value(degree, order, x, y, z);
                        }});
}

std::array<std::string, 3> reference_gradient(int degree, int order, const std::array<std::string, 3>& direction,
                                              int digits) {
  const Vector exact = checked(degree, order, direction, digits);
  const int m = std::abs(order);
  const auto component = [&](int axis) -> std::string {
    if (is_zero(order, exact, [&](const Residues& residues) { return residues.derivative(axis, degree, m); })) {
      return "0";
    }
    return correct_digits(digits, {[&](int /*decimals*/) {
                            const auto [x, y, z] = unit(exact);
                            return basis_value_gradient(degree, order, x, y, z)[axis];
                          }});
  };
  return {component(0), component(1), component(2)};
}

}  // namespace sh::numeric
