// The exact real constants a kernel may hold.
//
// A constant is a surd, or a computed real: one that is defined exactly (a root of an integer polynomial, a cosine of a
// rational angle, a quadrature weight) and evaluated to any number of digits, or a product of powers of such numbers
// and a surd. Both multiply and divide exactly; they add where the result is one of them again, and a sum that is not
// is std::nullopt, never an approximation.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "symbolic/number/surd.hpp"

namespace sh::codegen {

/// An exactly defined real that is no surd: a surd times powers of numbers which are known by their definitions. Two
/// are equal when these are. (Numbers defined by different texts are taken for different ones, even if they are not.)
class Computed {
 public:
  using Value = std::function<cln::cl_F(int digits)>;

  /// definition: says exactly which number it is, e.g. "cos(2 pi/7)"; value: it, with a relative error below
  /// 10^-digits. Not zero.
  Computed(const std::string& definition, Value value);

  /// For people: "-1/2 sqrt(3) cos(2 pi/7)^2 / w(z1)".
  [[nodiscard]] std::string definition() const;
  [[nodiscard]] cln::cl_F evaluate(int digits) const;
  [[nodiscard]] bool is_negative() const;
  [[nodiscard]] const symbolic::Surd& factor() const { return factor_; }
  /// True when both differ by a surd at most.
  [[nodiscard]] bool has_powers_of(const Computed& other) const;
  /// The same powers times another surd.
  [[nodiscard]] Computed with_factor(const symbolic::Surd& factor) const;
  [[nodiscard]] Computed inverse() const;
  /// No powers are left where a surd results.
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

using ExactReal = std::variant<symbolic::Surd, Computed>;

/// The value with a relative error below 10^-digits.
cln::cl_F evaluate(const ExactReal& value, int digits);
/// The value itself when it is rational.
std::optional<cln::cl_RA> as_rational(const ExactReal& value);
bool is_zero(const ExactReal& value);
bool is_negative(const ExactReal& value);
ExactReal negate(const ExactReal& value);
std::optional<ExactReal> add(const ExactReal& a, const ExactReal& b);
ExactReal multiply(const ExactReal& a, const ExactReal& b);
/// Throws std::invalid_argument for zero.
ExactReal reciprocal(const ExactReal& value);
/// For people: "1/2 sqrt(3/pi)".
std::string to_string(const ExactReal& value);

}  // namespace sh::codegen
