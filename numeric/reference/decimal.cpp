// See decimal.hpp.
#include "numeric/reference/decimal.hpp"

#include <mpfr.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

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

// Take the beginning of a text: one character, if it is there; a sign, true for '-'; digits.
bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}
bool take_minus(std::string_view& text) {
  const bool negative = take(text, '-');
  if (!negative) take(text, '+');
  return negative;
}
std::string take_digits(std::string_view& text) {
  std::string digits(text.substr(0, text.find_first_not_of("0123456789")));
  text.remove_prefix(digits.size());
  return digits;
}

// The widest range of exponents there is: sin^m near a pole leaves the usual one.
class WideExponents {
 public:
  WideExponents() {
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
  }
  ~WideExponents() {
    mpfr_set_emin(least_);
    mpfr_set_emax(largest_);
  }
  WideExponents(const WideExponents&) = delete;
  WideExponents& operator=(const WideExponents&) = delete;

 private:
  mpfr_exp_t least_ = mpfr_get_emin();
  mpfr_exp_t largest_ = mpfr_get_emax();
};

MpfrAny value_at(const Computation& computation, int decimals) {
  const PrecisionScope scope(static_cast<unsigned>(decimals));
  return computation.compute(decimals);
}

std::string rounded(const MpfrAny& value, int digits) {
  std::vector<char> text(static_cast<std::size_t>(digits) + 64);
  mpfr_snprintf(text.data(), text.size(), "%.*Re", digits - 1, value.backend().data());
  return text.data();
}

// Whether two computations of one value that is not zero agree to `digits` and 8 more. Where everything cancels they
// have nothing in common and this fails.
bool agree(const MpfrAny& a, const MpfrAny& b, int digits) {
  if (a == 0 || b == 0) return false;
  const MpfrAny relative = abs(MpfrAny((a - b) / b));
  return relative == 0 || relative < pow(MpfrAny(10), -digits - 8);
}

// Whether the value, computed with so many decimals, cannot be other than zero.
bool vanishes(const MpfrAny& value, int decimals, const Computation::Separation& zero) {
  return decimals > zero.separation + zero.absolute_loss + 1 &&
         (value == 0 || abs(value) < pow(MpfrAny(10), -zero.separation));
}

}  // namespace

std::uint64_t Decimal::modulo(std::uint64_t prime, long lowest_exponent) const {
  if (is_zero()) return 0;
  std::uint64_t result = 0;
  for (const char digit : digits) result = (result * 10 + static_cast<std::uint64_t>(digit - '0')) % prime;
  result = result * power_modulo(10, exponent - lowest_exponent, prime) % prime;
  return negative ? (prime - result) % prime : result;
}

std::string shortened(const std::string& text) { return text.size() > 40 ? text.substr(0, 40) + "..." : text; }

Decimal parse_decimal(const std::string& name, const std::string& text) {
  std::string_view rest = text;
  const bool negative = take_minus(rest);
  const std::string whole = take_digits(rest);
  const std::string fraction = take(rest, '.') ? take_digits(rest) : "";
  std::string exponent = "0";
  bool small = false;
  if (take(rest, 'e') || take(rest, 'E')) {
    small = take_minus(rest);
    exponent = take_digits(rest);
  }
  if ((whole + fraction).empty() || exponent.empty() || !rest.empty()) {
    throw std::invalid_argument(name + ": expected a decimal number such as -0.5 or 1e-3, got '" + shortened(text) +
                                "'");
  }
  exponent = without_leading_zeros(exponent);
  if (exponent.size() > 6 || std::stol(exponent) > kMaxExponent) {
    throw std::invalid_argument(name + ": expected an exponent within +-" + std::to_string(kMaxExponent) + ", got '" +
                                shortened(text) + "'");
  }
  const long power = small ? -std::stol(exponent) : std::stol(exponent);
  return {negative, without_leading_zeros(whole + fraction), power - static_cast<long>(fraction.size())};
}

std::string correct_digits(int digits, const Computation& computation) {
  require_range("digits", digits, 1, kMaxReferenceDigits);
  const WideExponents range;
  constexpr int kApart = 16;
  for (int guard = 16;; guard *= 2) {
    const int decimals = digits + guard + kApart;
    const MpfrAny value = value_at(computation, digits + guard);
    const MpfrAny better = value_at(computation, decimals);
    std::string text = rounded(better, digits);
    if (agree(value, better, digits) && rounded(value, digits) == text) return text;
    if (computation.zero && vanishes(better, decimals, *computation.zero)) return "0";
  }
}

}  // namespace sh::numeric
