// The exact real constants a kernel may hold.
//
// A constant is a surd, or a computed real: one that is defined exactly (a root of an integer polynomial, a cosine of a
// rational angle, a quadrature weight) and evaluated to any number of digits. Surds add and multiply exactly where the
// result is a surd; a sum or product that leaves the representable kinds is std::nullopt, never an approximation.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "symbolic/surd.hpp"

namespace sh::codegen {

/// An exactly defined real that is no surd. Two are equal when their definitions are the same text.
class Computed {
 public:
  /// definition: says exactly which number it is, e.g. "cos(2 pi/7)"; value: it, with a relative error below
  /// 10^-digits.
  Computed(std::string definition, std::function<cln::cl_F(int digits)> value)
      : definition_(std::move(definition)), value_(std::move(value)) {}

  [[nodiscard]] const std::string& definition() const { return definition_; }
  [[nodiscard]] cln::cl_F evaluate(int digits) const { return value_(digits); }
  [[nodiscard]] bool is_negative() const;

  friend bool operator==(const Computed& a, const Computed& b) { return a.definition_ == b.definition_; }
  friend bool operator<(const Computed& a, const Computed& b) { return a.definition_ < b.definition_; }

 private:
  std::string definition_;
  std::function<cln::cl_F(int digits)> value_;
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
std::optional<ExactReal> multiply(const ExactReal& a, const ExactReal& b);
/// For people: "1/2 sqrt(3/pi)".
std::string to_string(const ExactReal& value);

}  // namespace sh::codegen
