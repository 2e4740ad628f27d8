#include "codegen/ir/literal.hpp"

#include <cln/integer.h>
#include <cln/real.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace sh::codegen {
namespace {

// The largest e with 2^e <= value, for value > 0.
int binary_exponent(const cln::cl_RA& value) {
  const auto bits = [](const cln::cl_I& n) { return static_cast<int>(cln::integer_length(n)); };
  const int guess = bits(cln::numerator(value)) - bits(cln::denominator(value));
  return value < cln::expt(cln::cl_RA(2), guess) ? guess - 1 : guess;
}

std::string with_point(const std::string& digits) {
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

template <class T, class... Precision>
std::string to_digits(T value, Precision... precision) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, precision...);
  return with_point(std::string(buffer.data(), result.ptr));
}

}  // namespace

template <class T>
T nearest(const cln::cl_RA& value) {
  if (cln::zerop(value)) return T(0);
  const cln::cl_RA size = cln::abs(value);
  constexpr int kSmallest = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
  const int exponent = binary_exponent(size);
  // Count in units of the last place, with at most as many bits as T holds; round1 rounds ties to even. ldexp returns
  // infinity for what is too large.
  const int unit = std::max(exponent - (std::numeric_limits<T>::digits - 1), kSmallest);
  const cln::cl_I count = cln::round1(size * cln::expt(cln::cl_RA(2), -unit));
  const T result = std::ldexp(static_cast<T>(cln::cl_I_to_long(count)), unit);
  return cln::minusp(value) ? -result : result;
}

template <class T>
T nearest(const ExactReal& value) {
  if (const auto rational = as_rational(value)) return nearest<T>(*rational);
  // Narrow the interval around the irrational value until both its ends round alike [Ziv91].
  constexpr int kMostDigits = 2000;
  for (int digits = 50; digits <= kMostDigits; digits *= 2) {
    const cln::cl_RA center = cln::rational(evaluate(value, digits));
    const cln::cl_RA radius = cln::abs(center) / cln::expt(cln::cl_RA(10), digits);
    const T low = nearest<T>(center - radius);
    if (low == nearest<T>(center + radius)) return low;
  }
  throw std::runtime_error("literal: " + to_string(value) +
                           ": expected that 2000 digits decide the rounding, got a value too close to a boundary");
}

template float nearest<float>(const cln::cl_RA&);
template double nearest<double>(const cln::cl_RA&);
template float nearest<float>(const ExactReal&);
template double nearest<double>(const ExactReal&);

std::string decimal(double value) { return to_digits(value); }

std::string decimal(float value) {
  std::string digits = to_digits(value);
  // Few digits may lie so near the middle of two floats that their double is the middle. With max_digits10 digits they
  // are ten times as near to the float.
  if (static_cast<float>(std::strtod(digits.c_str(), nullptr)) == value) return digits;
  return to_digits(value, std::chars_format::general, std::numeric_limits<float>::max_digits10);
}

}  // namespace sh::codegen
