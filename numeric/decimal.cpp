// See decimal.hpp.
#include "numeric/decimal.hpp"

#include <regex>
#include <stdexcept>

namespace sh::numeric {
namespace {

constexpr long kMaxExponent = 100000;

std::uint64_t power_modulo(std::uint64_t base, long exponent, std::uint64_t prime) {
  std::uint64_t result = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) result = result * base % prime;
    base = base * base % prime;
  }
  return result;
}

std::string without_leading_zeros(const std::string& digits) {
  const auto first = digits.find_first_not_of('0');
  return first == std::string::npos ? "0" : digits.substr(first);
}

}  // namespace

std::uint64_t Decimal::modulo(std::uint64_t prime, long lowest_exponent) const {
  if (is_zero()) return 0;
  std::uint64_t result = 0;
  for (const char digit : digits) result = (result * 10 + static_cast<std::uint64_t>(digit - '0')) % prime;
  result = result * power_modulo(10, exponent - lowest_exponent, prime) % prime;
  return negative ? (prime - result) % prime : result;
}

Decimal parse_decimal(const std::string& name, const std::string& text) {
  static const std::regex kPattern("([+-]?)([0-9]*)(?:\\.([0-9]*))?(?:[eE]([+-]?[0-9]{1,7}))?");
  constexpr std::size_t kLongest = 20000;  // the regular expression recurses once a character
  std::smatch part;
  if (text.size() > kLongest || !std::regex_match(text, part, kPattern) || part.length(2) + part.length(3) == 0) {
    const std::string shown = text.size() > 40 ? text.substr(0, 40) + "..." : text;
    throw std::invalid_argument(name + ": '" + shown + "' is not a decimal number such as -0.5 or 1e-3");
  }
  const long exponent = part.length(4) > 0 ? std::stol(part.str(4)) : 0;
  if (exponent > kMaxExponent || exponent < -kMaxExponent) {
    throw std::invalid_argument(name + ": the exponent of '" + text + "' is beyond +-" + std::to_string(kMaxExponent));
  }
  return {part.str(1) == "-", without_leading_zeros(part.str(2) + part.str(3)), exponent - part.length(3)};
}

}  // namespace sh::numeric
