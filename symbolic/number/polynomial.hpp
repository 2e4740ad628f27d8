// Sparse multivariate polynomials with rational coefficients and a fixed monomial order.
//
// Terms are kept in a map from packed exponents to non-zero rationals, in lexicographic order with variable 0 first,
// so two equal polynomials are equal term by term. Variables are numbers: 0, 1, 2 are x, y, z for functions on the
// sphere, and nine of them hold a rotation matrix.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>

#include <compare>
#include <cstdint>
#include <map>
#include <span>
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

// Calculus. GiNaC differentiates, integrates and divides; many substitutions at once and means over the sphere have
// faster functions of their own (polynomial_calculus.cpp).

/// p with values[i] in place of variable i. Throws std::invalid_argument when a variable of p has no value.
Polynomial substitute(const Polynomial& p, std::span<const Polynomial> values);

/// The integral of p over `variable` from `lower` to `upper`; neither bound may hold `variable`.
Polynomial definite_integral(const Polynomial& p, int variable, const Polynomial& lower, const Polynomial& upper);

/// P_l of `variable` by Rodrigues' formula, d^l/dt^l (t^2 - 1)^l / (2^l l!) [AbramowitzStegun64] 22.11.5.
/// Throws std::invalid_argument when degree < 0.
Polynomial legendre_polynomial(int degree, int variable);

/// The one polynomial of degree at most 1 in x that equals p wherever x^2+y^2+z^2 = 1 (variables 0, 1, 2 are x, y, z).
/// Two polynomials agree on the sphere exactly when their normal forms are equal.
Polynomial reduce_on_sphere(const Polynomial& p);

/// The mean of p over the unit sphere, that is its integral divided by 4 pi; variables 0, 1, 2 are x, y, z:
/// x^a y^b z^c has the mean (a-1)!! (b-1)!! (c-1)!! / (a+b+c+1)!! for even a, b, c, otherwise zero [Folland01].
cln::cl_RA sphere_mean(const Polynomial& p);
const cln::cl_RA& sphere_mean(const Monomial& monomial);

/// The positive number by which every coefficient is an integer without a common factor; 0 for zero.
cln::cl_RA content(const Polynomial& p);

}  // namespace sh::symbolic
