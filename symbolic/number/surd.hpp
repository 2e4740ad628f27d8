// Surds: the exact real numbers p/q * sqrt(r) * pi^(k/2), r a square-free positive integer.
//
// Every normalization factor of the real spherical harmonics is a surd, and so are products and quotients of surds. The
// representation is unique, so equality is equality of the three parts. The sum of two surds is a surd only if their
// radicals agree or one of them is zero; any other sum is an error, never an approximation.
#pragma once

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>

#include <string>

namespace sh::symbolic {

class Surd {
 public:
  Surd() = default;
  /// The rational number itself.
  explicit Surd(const cln::cl_RA& rational) : rational_(rational) {}

  /// sqrt(square) * pi^(pi_half_power / 2). Throws std::invalid_argument when `square` is negative or holds a prime
  /// factor too large to split off by trial division.
  static Surd square_root(const cln::cl_RA& square, int pi_half_power = 0);

  [[nodiscard]] const cln::cl_RA& rational() const { return rational_; }
  [[nodiscard]] const cln::cl_I& radicand() const { return radicand_; }
  [[nodiscard]] int pi_half_power() const { return pi_half_power_; }

  [[nodiscard]] bool is_zero() const { return cln::zerop(rational_); }
  [[nodiscard]] bool is_rational() const { return radicand_ == 1 && pi_half_power_ == 0; }
  [[nodiscard]] bool is_negative() const { return cln::minusp(rational_); }
  /// True when the sum of both is again a surd.
  [[nodiscard]] bool adds_to(const Surd& other) const;
  /// The value rounded to at least `digits` decimal digits.
  [[nodiscard]] cln::cl_F evaluate(int digits) const;
  /// For people: "1/2 sqrt(3/pi)".
  [[nodiscard]] std::string to_string() const;

  Surd operator-() const;
  [[nodiscard]] Surd inverse() const;  ///< throws std::invalid_argument for zero
  friend Surd operator*(const Surd& a, const Surd& b);
  friend Surd operator/(const Surd& a, const Surd& b) { return a * b.inverse(); }
  friend Surd operator+(const Surd& a, const Surd& b);  ///< throws std::invalid_argument unless a.adds_to(b)
  friend bool operator==(const Surd& a, const Surd& b);
  /// A fixed total order of the representation (not of the value), for ordered containers.
  friend bool operator<(const Surd& a, const Surd& b);

 private:
  cln::cl_RA rational_ = 0;
  cln::cl_I radicand_ = 1;
  int pi_half_power_ = 0;
};

}  // namespace sh::symbolic
