// Sparse multivariate polynomials with rational coefficients and a fixed monomial order.
//
// Terms are kept in a map from packed exponents to non-zero rationals, in lexicographic order with variable 0 first,
// so two equal polynomials are equal term by term and print alike in every run. Variables are numbers (0, 1, 2 = x, y,
// z for functions on the sphere; nine of them hold a rotation matrix); names are given only when printing.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace sh::symbolic {

/// A product of powers, e.g. x^2 z: seven bits for each of up to nine exponents in one word.
class Monomial {
 public:
  static constexpr int kMaxVariables = 9;
  static constexpr int kMaxExponent = 127;

  Monomial() = default;
  /// exponents: one per variable, at most kMaxVariables. Throws std::invalid_argument out of range.
  explicit Monomial(std::span<const int> exponents);
  Monomial(std::initializer_list<int> exponents)
      : Monomial(std::span<const int>(exponents.begin(), exponents.size())) {}

  [[nodiscard]] int exponent(int variable) const { return static_cast<int>(packed_ >> shift(variable)) & kMaxExponent; }
  [[nodiscard]] int degree() const;
  /// Throws std::overflow_error when an exponent exceeds kMaxExponent.
  friend Monomial operator*(Monomial a, Monomial b);
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads a defaulted <=>
  friend auto operator<=>(const Monomial&, const Monomial&) = default;

 private:
  static constexpr int kBits = 7;
  static int shift(int variable) { return kBits * (kMaxVariables - 1 - variable); }
  std::uint64_t packed_ = 0;
};

class Polynomial {
 public:
  using Terms = std::map<Monomial, cln::cl_RA>;

  Polynomial() = default;
  explicit Polynomial(const cln::cl_RA& constant) { add_term({}, constant); }
  static Polynomial variable(int index);

  /// Adds coefficient * monomial; a term that cancels to zero is removed.
  void add_term(const Monomial& monomial, const cln::cl_RA& coefficient);
  [[nodiscard]] const Terms& terms() const { return terms_; }
  [[nodiscard]] bool is_zero() const { return terms_.empty(); }
  /// The coefficient of a monomial, zero when it is absent.
  [[nodiscard]] cln::cl_RA coefficient(const Monomial& monomial) const;
  /// The largest degree of a term; -1 for the zero polynomial.
  [[nodiscard]] int degree() const;
  [[nodiscard]] bool is_homogeneous() const;

  [[nodiscard]] Polynomial derivative(int variable) const;  ///< by GiNaC (polynomial_calculus.cpp)
  [[nodiscard]] Polynomial power(int exponent) const;
  /// point: one value per variable that occurs.
  [[nodiscard]] cln::cl_RA evaluate(std::span<const cln::cl_RA> point) const;
  /// names: one per variable that occurs. Highest monomial first: "3/2 z^2 - 1/2".
  [[nodiscard]] std::string to_string(const std::vector<std::string>& names) const;

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const cln::cl_RA& factor, const Polynomial& a);
  friend bool operator==(const Polynomial& a, const Polynomial& b) { return a.terms_ == b.terms_; }

 private:
  Terms terms_;
};

}  // namespace sh::symbolic
