// See kernel_limits.hpp.
#include "numeric/kernel_limits.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

namespace sh::numeric {
namespace {

struct Row {
  const char* family;
  int first_degree, last_degree;
  KernelLimits in_float;
  KernelLimits in_double;
};

// Rounding of basis: at most twice what Sloan's own code errs by at that degree (1.05, 1.3, 2.5, 4.2, 6.1, 7.7, 9.6,
// 11.7 eps at degree 2 to 9); its totals, and whatever has no such reason here: at most four times what was measured on
// the inputs of the family's check, so that other compilers and rounding of the same formula fit.
// clang-format off
constexpr std::array kRows = {
    //   family              degrees     float: rounding, total         double: rounding, total
    Row{"basis",              0,  0,   {  0.9,   0.9 },               {  0.9,   0.9 }},
    Row{"basis",              1,  1,   {  0.9,   2.0 },               {  0.9,   2.0 }},
    Row{"basis",              2,  2,   {  2.1,   5.0 },               {  2.1,   5.0 }},
    Row{"basis",              3,  3,   {  2.6,   7.0 },               {  2.6,   7.0 }},
    Row{"basis",              4,  4,   {  5.0,  12.0, 7e-7 },         {  5.0,  12.0, 3e-15 }},
    Row{"basis",              5,  5,   {  8.4,  20.0 },               {  8.4,  20.0 }},
    Row{"basis",              6,  6,   { 12.2,  28.0 },               { 12.2,  28.0 }},
    Row{"basis",              7,  7,   { 15.4,  35.0 },               { 15.4,  35.0 }},
    Row{"basis",              8,  8,   { 19.2,  40.0 },               { 19.2,  40.0 }},
    Row{"basis",              9,  9,   { 23.4,  45.0 },               { 23.4,  45.0 }},
    Row{"basis",             10, 10,   { 26.0,  50.0 },               { 26.0,  50.0 }},
};
// clang-format on

std::string exceeded(const std::string& what, double value, double limit, const WorstCase& worst) {
  std::array<char, 64> numbers{};
  std::snprintf(numbers.data(), numbers.size(), " %.3g exceeds %.3g", value, limit);
  std::string text = what + numbers.data() + " (" + worst.output + " at " + worst.input;
  constexpr std::size_t kMostPrinted = 4;
  for (std::size_t i = 0; i < worst.values.size() && worst.values.size() <= kMostPrinted; ++i) {
    std::snprintf(numbers.data(), numbers.size(), "%s%.17g", i == 0 ? ": " : ", ", worst.values[i]);
    text += numbers.data();
  }
  return text + ")";
}

void check_errors(const KernelResult& result, const std::string& name, std::vector<std::string>& failures) {
  const auto limits = limits_for(result.family, result.degree, result.scalar);
  const double rounding = result.rounding.scaled().max();
  if (!(rounding <= limits.rounding)) {
    failures.push_back(name + exceeded("rounding error in eps", rounding, limits.rounding, result.worst_rounding));
  }
  const double total = result.total.scaled().max();
  if (!(total <= limits.total)) {
    failures.push_back(name + exceeded("total error in eps", total, limits.total, result.worst_total));
  }
  const double absolute = result.total.absolute().max();
  if (!(absolute <= limits.total_absolute)) {
    failures.push_back(name + exceeded("total error", absolute, limits.total_absolute, result.worst_total));
  }
}

}  // namespace

KernelLimits limits_for(const std::string& family, int degree, const std::string& scalar) {
  const auto* const row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) {
    return family == r.family && degree >= r.first_degree && degree <= r.last_degree;
  });
  if (row == kRows.end()) {
    throw std::out_of_range(family + ": no limit is set for degree " + std::to_string(degree));
  }
  return scalar == "float" ? row->in_float : row->in_double;
}

std::vector<std::string> failures_of(const KernelResult& result) {
  const std::string name = result.kernel + " " + result.language + " " + result.scalar + ": ";
  std::vector<std::string> failures;
  try {
    check_errors(result, name, failures);
  } catch (const std::out_of_range& error) {
    failures.push_back(name + error.what());
  }
  if (result.different_in_place > 0) {
    failures.push_back(name + std::to_string(result.different_in_place) +
                       " values change when an input array is overwritten by the output");
  }
  if (result.bits && result.bits->different > 0 && result.bits_must_agree()) {
    failures.push_back(name + std::to_string(result.bits->different) + " of " + std::to_string(result.bits->compared) +
                       " values differ from c++ float in their bits; first: " + result.bits->first_difference);
  }
  return failures;
}

}  // namespace sh::numeric
