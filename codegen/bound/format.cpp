#include "codegen/bound/format.hpp"

#include <cln/dfloat.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <bit>
#include <cstdint>

#include "symbolic/number/find_named.hpp"

namespace sh::codegen::bound {
namespace {

constexpr int kDigits = 60;  // decimal digits of exact constants

const Format kFormats[] = {
    {"half", 11, -24, 65504, 16},
    {"float", 24, -149, static_cast<double>(std::numeric_limits<float>::max()), 0x1p20},
    {"double", 53, -1074, std::numeric_limits<double>::max(), 0x1p20},
};

// The largest e with 2^e <= value, for value > 0.
int binary_exponent(const cln::cl_RA& value) {
  const auto bits = [](const cln::cl_I& n) { return static_cast<int>(cln::integer_length(n)); };
  const int guess = bits(cln::numerator(value)) - bits(cln::denominator(value));
  return value < cln::expt(cln::cl_RA(2), guess) ? guess - 1 : guess;
}

Interval enclosure(const cln::cl_RA& value) {
  if (cln::zerop(value)) return {0, 0};
  const double nearest = cln::double_approx(value);
  if (cln::rational(cln::cl_DF(nearest)) == value) return {nearest, nearest};
  return {below(below(nearest)), above(above(nearest))};
}

}  // namespace

double Format::half_ulp(double magnitude) const {
  if (!std::isfinite(magnitude)) return std::numeric_limits<double>::infinity();
  constexpr std::uint64_t kExponentBits = 0x7ff0000000000000ULL;
  const auto power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) & kExponentBits);
  // Numbers below a power of two have the smaller unit, and the power itself needs no rounding.
  const double binade = power == magnitude ? power / 2 : power;
  return std::max(binade * (epsilon() / 2), tiny());
}

const Format& find_format(const std::string& name) { return symbolic::find_named(kFormats, name, "scalar"); }

RoundedConstant rounded(const ExactReal& constant, const Format& format) {
  RoundedConstant result;
  if (is_zero(constant)) return result;
  const auto rational = as_rational(constant);
  const cln::cl_RA exact = rational ? *rational : cln::rational(evaluate(constant, kDigits));
  const int exponent = binary_exponent(cln::abs(exact));
  result.grid = std::max(exponent - (format.digits - 1), format.least_exponent);
  const cln::cl_RA unit = cln::expt(cln::cl_RA(2), result.grid);
  cln::cl_I count = cln::round1(exact / unit);
  const cln::cl_RA nearest = count * unit;
  result.value = hull(enclosure(exact), enclosure(nearest));
  result.nearest = cln::double_approx(nearest);
  result.error = enclosure(nearest - exact);
  // An irrational constant is known to kDigits only.
  if (!rational) result.error = widened(result.error, result.value.magnitude() * 1e-50);
  if (cln::zerop(count)) return result;
  for (; cln::evenp(count); count = cln::exquo(count, 2)) ++result.grid;
  result.power_of_two = cln::abs(count) == 1;
  return result;
}

}  // namespace sh::codegen::bound
