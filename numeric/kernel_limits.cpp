// See kernel_limits.hpp.
#include "numeric/kernel_limits.hpp"

#include <array>
#include <cstdio>

namespace sh::numeric {
namespace {

struct Row {
  KernelLimits in_float;
  KernelLimits in_double;
};

// The family basis, by degree. Rounding: twice what was measured on the directions of kernel_check.hpp, so that other
// compilers and rounding of the same formula fit. Total: twice what was measured, except degree 4, where 7e-7 and 3e-15
// are what users are promised.
// clang-format off
//                              float               double
//                        rounding  total     rounding  total
constexpr std::array<Row, 11> kRows = {{
    /* degree  0 */ {{  0.9, 3.0e-8 },   {  0.2, 8.0e-18 }},
    /* degree  1 */ {{  0.9, 7.0e-8 },   {  0.6, 2.2e-16 }},
    /* degree  2 */ {{  2.7, 2.5e-7 },   {  2.3, 5.5e-16 }},
    /* degree  3 */ {{  2.7, 4.5e-7 },   {  3.0, 8.0e-16 }},
    /* degree  4 */ {{  5.7, 7.0e-7 },   {  7.0, 3.0e-15 }},
    /* degree  5 */ {{  9.0, 1.6e-6 },   { 11.0, 3.0e-15 }},
    /* degree  6 */ {{ 13.0, 2.4e-6 },   { 14.0, 3.5e-15 }},
    /* degree  7 */ {{ 17.0, 3.2e-6 },   { 17.0, 4.5e-15 }},
    /* degree  8 */ {{ 20.0, 4.5e-6 },   { 20.0, 6.0e-15 }},
    /* degree  9 */ {{ 23.0, 5.7e-6 },   { 22.0, 7.5e-15 }},
    /* degree 10 */ {{ 26.0, 7.0e-6 },   { 26.0, 9.0e-15 }},
}};
// clang-format on

std::string exceeded(const char* what, const ErrorMeasure& measure, double limit) {
  std::array<char, 256> text{};
  const auto& worst = measure.worst();
  std::snprintf(text.data(), text.size(), "%s %.3g exceeds %.3g (l=%d m=%d at %.17g, %.17g, %.17g)", what,
                measure.max(), limit, worst.degree, worst.order, worst.input.x, worst.input.y, worst.input.z);
  return text.data();
}

}  // namespace

KernelLimits limits_for(int degree, const std::string& scalar) {
  const auto& row = kRows.at(static_cast<std::size_t>(degree));
  return scalar == "float" ? row.in_float : row.in_double;
}

std::vector<std::string> failures_of(const KernelResult& result) {
  const auto limits = limits_for(result.degree, result.scalar);
  const std::string name = result.kernel + " " + result.language + " " + result.scalar + ": ";
  std::vector<std::string> failures;
  if (!(result.rounding.scaled().max() <= limits.rounding)) {
    failures.push_back(name +
                       exceeded("rounding error in eps x band maximum", result.rounding.scaled(), limits.rounding));
  }
  if (!(result.total.absolute().max() <= limits.total)) {
    failures.push_back(name + exceeded("total error", result.total.absolute(), limits.total));
  }
  if (result.bits && result.bits->different > 0) {
    failures.push_back(name + std::to_string(result.bits->different) + " of " + std::to_string(result.bits->compared) +
                       " values differ from c++ float in their bits; first: " + result.bits->first_difference);
  }
  return failures;
}

}  // namespace sh::numeric
