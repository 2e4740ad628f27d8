// See decimal.hpp.
#include "numeric/reference/decimal.hpp"

#include <algorithm>
#include <cstddef>
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

std::string shown(const std::string& text) { return text.size() > 40 ? text.substr(0, 40) + "..." : text; }

// Reads a text from left to right, a piece at a time.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  bool accept(char c) {
    if (at_end() || text_[place_] != c) return false;
    ++place_;
    return true;
  }
  // Takes one sign, if there is one; true for '-'.
  bool sign() {
    const bool negative = accept('-');
    if (!negative) accept('+');
    return negative;
  }
  std::string digits() {
    const auto end = std::min(text_.find_first_not_of("0123456789", place_), text_.size());
    const auto begin = place_;
    place_ = end;
    return text_.substr(begin, end - begin);
  }
  [[nodiscard]] bool at_end() const { return place_ == text_.size(); }

 private:
  const std::string& text_;
  std::size_t place_ = 0;
};

}  // namespace

std::uint64_t Decimal::modulo(std::uint64_t prime, long lowest_exponent) const {
  if (is_zero()) return 0;
  std::uint64_t result = 0;
  for (const char digit : digits) result = (result * 10 + static_cast<std::uint64_t>(digit - '0')) % prime;
  result = result * power_modulo(10, exponent - lowest_exponent, prime) % prime;
  return negative ? (prime - result) % prime : result;
}

Decimal parse_decimal(const std::string& name, const std::string& text) {
  Scanner scanner(text);
  const bool negative = scanner.sign();
  const std::string whole = scanner.digits();
  const std::string fraction = scanner.accept('.') ? scanner.digits() : "";
  bool well_formed = !whole.empty() || !fraction.empty();
  std::string exponent = "0";
  bool small = false;
  if (scanner.accept('e') || scanner.accept('E')) {
    small = scanner.sign();
    exponent = scanner.digits();
    well_formed = well_formed && !exponent.empty();
  }
  if (!well_formed || !scanner.at_end()) {
    throw std::invalid_argument(name + ": '" + shown(text) + "' is not a decimal number such as -0.5 or 1e-3");
  }
  exponent = without_leading_zeros(exponent);
  if (exponent.size() > 6 || std::stol(exponent) > kMaxExponent) {
    throw std::invalid_argument(name + ": the exponent of '" + shown(text) + "' is beyond +-" +
                                std::to_string(kMaxExponent));
  }
  const long power = small ? -std::stol(exponent) : std::stol(exponent);
  return {negative, without_leading_zeros(whole + fraction), power - static_cast<long>(fraction.size())};
}

}  // namespace sh::numeric
