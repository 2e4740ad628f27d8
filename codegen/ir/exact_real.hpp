// The exact real constants of a kernel.
//
// A constant is a surd or a computed real. A computed real is a surd times powers of exactly defined numbers: a root of
// an integer polynomial, a cosine of a rational angle, a quadrature weight. Each of these numbers can be evaluated to
// any number of digits. Both kinds of constants multiply and divide exactly. They add exactly if the sum is a surd or a
// computed real again; otherwise the sum is std::nullopt, never an approximation.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "symbolic/number/surd.hpp"

namespace sh::codegen {

/// A surd times powers of exactly defined numbers. Two computed reals are equal if their surds, definitions and powers
/// are equal. (Two numbers with different definition texts count as different, even if their values are equal.)
class Computed {
 public:
  using Value = std::function<cln::cl_F(int digits)>;

  /// definition: the exact definition of the number, e.g. "cos(2 pi/7)". value: computes the number with a relative
  /// error below 10^-digits. The number must not be zero.
  Computed(const std::string& definition, Value value);

  /// A readable form: "-1/2 sqrt(3) cos(2 pi/7)^2 / w(z1)".
  [[nodiscard]] std::string definition() const;
  [[nodiscard]] cln::cl_F evaluate(int digits) const;
  [[nodiscard]] bool is_negative() const;
  [[nodiscard]] const symbolic::Surd& factor() const { return factor_; }
  /// True if the two numbers differ at most by a surd as factor.
  [[nodiscard]] bool has_powers_of(const Computed& other) const;
  /// The same powers times another surd.
  [[nodiscard]] Computed with_factor(const symbolic::Surd& factor) const;
  [[nodiscard]] Computed inverse() const;
  /// True if all powers cancelled, so that only the surd is left.
  [[nodiscard]] bool is_surd() const { return powers_.empty(); }
  friend Computed operator*(const Computed& a, const Computed& b);

  friend bool operator==(const Computed& a, const Computed& b) { return a.has_powers_of(b) && a.factor_ == b.factor_; }
  friend bool operator<(const Computed& a, const Computed& b);

 private:
  struct Power {
    int exponent = 1;
    std::shared_ptr<const Value> value;
  };

  symbolic::Surd factor_{1};
  std::map<std::string, Power> powers_;  // by definition; exponents are not zero
};

/// A constant of a kernel.
using ExactReal = std::variant<symbolic::Surd, Computed>;

/// The value with a relative error below 10^-digits.
cln::cl_F evaluate(const ExactReal& value, int digits);
/// The value if it is rational, otherwise std::nullopt.
std::optional<cln::cl_RA> as_rational(const ExactReal& value);
bool is_zero(const ExactReal& value);
bool is_negative(const ExactReal& value);
ExactReal negate(const ExactReal& value);
/// std::nullopt if the sum is neither a surd nor a computed real.
std::optional<ExactReal> add(const ExactReal& a, const ExactReal& b);
ExactReal multiply(const ExactReal& a, const ExactReal& b);
/// Throws std::invalid_argument for zero.
ExactReal reciprocal(const ExactReal& value);
/// A readable form: "1/2 sqrt(3/pi)".
std::string to_string(const ExactReal& value);

}  // namespace sh::codegen
