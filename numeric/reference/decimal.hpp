// A decimal number as the user wrote it, kept exactly: what a reference value starts from.
#pragma once

#include <cstdint>
#include <string>

namespace sh::numeric {

// sign * digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;  // one or more of 0-9
  long exponent = 0;

  [[nodiscard]] bool is_zero() const { return digits.find_first_not_of('0') == std::string::npos; }
  // For mpfr_set_str: "-123e-2".
  [[nodiscard]] std::string text() const { return (negative ? "-" : "") + digits + "e" + std::to_string(exponent); }
  // The integer sign * digits * 10^(exponent - lowest_exponent) modulo a prime below 2^31.
  [[nodiscard]] std::uint64_t modulo(std::uint64_t prime, long lowest_exponent) const;
};

// [+-]digits[.digits][e[+-]digits], with digits on at least one side of the point and the exponent within +-100000.
// Throws std::invalid_argument: "NAME: 'TEXT' is not a decimal number such as -0.5 or 1e-3".
Decimal parse_decimal(const std::string& name, const std::string& text);

}  // namespace sh::numeric
