// Decimal numbers in and out: exactly as the user wrote them, and with as many correct digits as asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "numeric/oracle/real.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {

/// sign * digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;  // one or more of 0-9
  long exponent = 0;

  [[nodiscard]] bool is_zero() const { return digits.find_first_not_of('0') == std::string::npos; }
  /// For mpfr_set_str: "-123e-2".
  [[nodiscard]] std::string text() const { return (negative ? "-" : "") + digits + "e" + std::to_string(exponent); }
  /// The integer sign * digits * 10^(exponent - lowest_exponent) modulo a prime below 2^31.
  [[nodiscard]] std::uint64_t modulo(std::uint64_t prime, long lowest_exponent) const;
};

/// [+-]digits[.digits][e[+-]digits], with digits on at least one side of the point and the exponent within +-100000.
/// Throws std::invalid_argument: "NAME: expected a decimal number such as -0.5 or 1e-3, got 'TEXT'".
Decimal parse_decimal(const std::string& name, const std::string& text);

/// A text of the user in a message: its first 40 characters.
std::string shortened(const std::string& text);

constexpr int kMaxReferenceDigits = 10000;

/// A computation of one value. compute(decimals) is called at a precision of so many decimals (a PrecisionScope holds
/// meanwhile) and has a relative error of 10^(lost - decimals), `lost` being any number of digits.
struct Computation {
  std::function<MpfrAny(int decimals)> compute;
  /// For a value that may be exactly zero: if not zero it is above 10^-separation, and its absolute error at any
  /// precision is below 10^(absolute_loss - decimals).
  struct Separation {
    long separation = 0;
    long absolute_loss = 0;
  };
  std::optional<Separation> zero{};
};

/// The value rounded to `digits` significant decimals, such as "-3.14e-01"; "0" where it is found to be exactly zero,
/// for which `zero` has to be given (without it the search would not end). It is computed at two precisions, both
/// beyond `digits`, and at higher ones until their roundings agree [Ziv91]. Throws std::invalid_argument unless 1 <=
/// digits <= kMaxReferenceDigits.
std::string correct_digits(int digits, const Computation& computation);

}  // namespace sh::numeric
