// Finite sums of surds with complex rational coefficients: the number ring in which every map between conventions is
// exact, e.g. 1/2 + i/2 sqrt(3) + 2 pi^(1/2).
//
// A number is a map from (square-free radicand, power of sqrt(pi)) to a non-zero complex rational. Square roots of
// distinct square-free integers are linearly independent over the rationals, and pi is transcendental, so the
// representation is unique and equality is equality of the maps.
#pragma once

#include <cln/complex.h>
#include <cln/integer.h>
#include <cln/rational.h>

#include <map>
#include <string>
#include <utility>

#include "symbolic/number/surd.hpp"

namespace sh::symbolic {

class RadicalSum {
 public:
  /// (radicand, exponent of sqrt(pi)) of one term.
  using Radical = std::pair<cln::cl_I, int>;
  using Terms = std::map<Radical, cln::cl_N>;

  RadicalSum() = default;
  explicit RadicalSum(const cln::cl_RA& rational) { add_term({1, 0}, rational); }
  explicit RadicalSum(const Surd& surd) { add_term({surd.radicand(), surd.pi_half_power()}, surd.rational()); }
  static RadicalSum imaginary_unit();

  /// Adds coefficient * sqrt(radicand) * pi^(power/2); `radical.first` must be square-free, coefficient exact.
  void add_term(const Radical& radical, const cln::cl_N& coefficient);
  [[nodiscard]] const Terms& terms() const { return terms_; }
  [[nodiscard]] bool is_zero() const { return terms_.empty(); }
  [[nodiscard]] bool is_real() const;
  [[nodiscard]] RadicalSum conjugate() const;
  /// The reciprocal of a single term; throws std::invalid_argument for zero and for sums of several radicals.
  [[nodiscard]] RadicalSum inverse() const;
  /// The number as a surd; throws std::invalid_argument when it is not real or has several radicals.
  [[nodiscard]] Surd surd() const;
  /// For people: "1/2 + i/2 sqrt(3)".
  [[nodiscard]] std::string to_string() const;

  RadicalSum operator-() const;
  RadicalSum& operator+=(const RadicalSum& other);
  friend RadicalSum operator+(RadicalSum a, const RadicalSum& b) { return a += b; }
  friend RadicalSum operator-(RadicalSum a, const RadicalSum& b) { return a += -b; }
  friend RadicalSum operator*(const RadicalSum& a, const RadicalSum& b);
  friend bool operator==(const RadicalSum& a, const RadicalSum& b);

 private:
  Terms terms_;
};

}  // namespace sh::symbolic
