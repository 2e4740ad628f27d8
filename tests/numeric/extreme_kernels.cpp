// See extreme_kernels.hpp.
#include "tests/numeric/extreme_kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "numeric/kernels/kernel_check.hpp"
#include "numeric/kernels/kernel_limits.hpp"
#include "tests/numeric/extreme.hpp"

namespace sh::test {
namespace {

using namespace numeric;

std::size_t place_of(const Signature& signature, const std::string& name) {
  std::size_t place = 0;
  for (const Parameter& parameter : signature.parameters) {
    if (parameter.name == name) return place;
    if (parameter.is_read()) place += static_cast<std::size_t>(parameter.values());
  }
  throw std::logic_error("no parameter " + name);
}

// The error nearest to its limit so far.
struct Nearest {
  double part = -1;  // of the limit
  double error = 0, limit = 0;
  std::string where;

  void add(const KernelResult& result, const char* kind, const ErrorStats& errors, double allowed,
           const WorstCase& worst) {
    const double found = errors.scaled().max();
    if (found / allowed <= part) return;
    *this = {found / allowed, found, allowed,
             fmt::format("{} {}, {} at {}", result.kernel, kind, worst.output, worst.input)};
  }
};

template <class T>
void report_family(const std::string& what, const std::string& family, const std::string& first,
                   const std::vector<NamedInput>& extremes) {
  Nearest nearest;
  for (const BoundKernel& kernel : kernels_of({family})) {
    const KernelResult result = kernel_errors<T>(kernel, at_extremes(kernel, first, extremes));
    const auto limits = limits_for(kernel.family, kernel.degree, result.scalar);
    if (!limits) throw std::logic_error(kernel.name() + ": no limit");
    nearest.add(result, "rounding", result.rounding, limits->rounding, result.worst_rounding);
    nearest.add(result, "total", result.total, limits->total, result.worst_total);
  }
  const char* const scalar = sizeof(T) == sizeof(float) ? "float" : "double";
  report_extreme(fmt::format("{}: {} {}, eps", what, family, scalar), nearest.error, nearest.limit, nearest.where);
}

}  // namespace

std::vector<BoundKernel> kernels_of(const std::vector<std::string>& families) {
  constexpr int kMiddle = 4;
  constexpr int kLargest = 10;
  std::vector<BoundKernel> chosen;
  for (const BoundKernel& kernel : bound_kernels()) {
    const bool wanted = std::find(families.begin(), families.end(), without_variant(kernel.family)) != families.end();
    if (wanted && (kernel.degree <= 2 || kernel.degree == kMiddle || kernel.degree == kLargest)) {
      chosen.push_back(kernel);
    }
  }
  return chosen;
}

FamilyCheck at_extremes(const BoundKernel& kernel, const std::string& first, const std::vector<NamedInput>& extremes) {
  FamilyCheck check = check_of(kernel.family);
  const std::size_t place = place_of(check.signature(kernel.degree), first);
  check.inputs = [usual = check.inputs, place, extremes](int degree) {
    const auto others = usual(degree);
    std::vector<NamedInput> inputs;
    for (std::size_t i = 0; i < extremes.size(); ++i) {
      const auto& other = others[i % others.size()];
      const bool has_others = other.values.size() > extremes[i].values.size();
      inputs.push_back(
          {extremes[i].name + " " + printed(extremes[i].values) + (has_others ? ", else " + other.name : ""),
           other.values});
      std::copy(extremes[i].values.begin(), extremes[i].values.end(),
                inputs.back().values.begin() + static_cast<std::ptrdiff_t>(place));
    }
    return inputs;
  };
  return check;
}

void report_kernels(const std::string& what, const std::vector<std::string>& families, const std::string& first,
                    const std::vector<NamedInput>& extremes) {
  for (const std::string& family : families) {
    report_family<float>(what, family, first, extremes);
    report_family<double>(what, family, first, extremes);
  }
}

std::string printed(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.17g}", text.empty() ? "(" : ", ", value);
  return text + ")";
}

}  // namespace sh::test
