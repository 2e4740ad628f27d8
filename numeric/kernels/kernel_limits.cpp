// See kernel_limits.hpp.
#include "numeric/kernels/kernel_limits.hpp"

#include <algorithm>
#include <array>

#include "numeric/output/formatted.hpp"

namespace sh::numeric {
namespace {

// Kernels, by the start of their names, in which Mesa 22 multiplies neighboring constants together, or adds in another
// order, although the result is declared invariant. Their errors in GLSL are held to the limits all the same.
constexpr std::array kRegroupedAnyway = {"product_l5",
                                         "product_l8",
                                         "product_l10",
                                         "square_l5",
                                         "square_l8",
                                         "square_l10",
                                         "triple_l8",
                                         "triple_l10",
                                         "basis_gradient_accurate_l",
                                         "evaluate_prepare_l",
                                         "project_l",
                                         "transfer_apply_l6",
                                         "transfer_apply_rgb_l6"};

// The errors are measured with 106 bits: their own error in eps is far below this, but not 0 as some bounds are.
constexpr double kCheckError = 1e-6;

std::string exceeded(const std::string& what, double value, double limit, const WorstCase& worst) {
  std::string text =
      what + output::formatted(" %.3g exceeds %.3g (", value, limit) + worst.output + " at " + worst.input;
  constexpr std::size_t kMostPrinted = 4;
  for (std::size_t i = 0; i < worst.values.size() && worst.values.size() <= kMostPrinted; ++i) {
    text += output::formatted("%s%.17g", i == 0 ? ": " : ", ", worst.values[i]);
  }
  return text + ")";
}

void check_errors(const KernelResult& result, const std::string& name, const FamiliesRecord& record,
                  std::vector<std::string>& failures) {
  const auto limits = limits_for(result.family, result.degree, result.scalar, record);
  if (!limits) {
    failures.push_back(name + "no error is recorded");
    return;
  }
  struct Bound {
    const char* error;
    double value, limit;
    const WorstCase& worst;
  };
  for (const auto& [error, value, limit, worst] :
       {Bound{"rounding error in eps", result.rounding.scaled().max(), limits->rounding, result.worst_rounding},
        Bound{"total error in eps", result.total.scaled().max(), limits->total, result.worst_total},
        Bound{"total error", result.total.absolute().max(), limits->total_absolute, result.worst_total}}) {
    if (!(value <= limit)) failures.push_back(name + exceeded(error, value, limit, worst));
  }
}

}  // namespace

std::optional<KernelLimits> limits_for(const std::string& family, int degree, const std::string& scalar,
                                       const FamiliesRecord& record) {
  const std::string name = family + "_l" + std::to_string(degree);
  const KernelRecord* const kernel = record.find_kernel(name);
  if (kernel == nullptr) return {};
  const RoundingAndTotal& recorded = scalar == "float" ? kernel->in_float : kernel->in_double;
  KernelLimits limits{std::max(record.limit_factor.rounding * recorded.rounding, record.least_limit),
                      std::max(record.limit_factor.total * recorded.total, record.least_limit)};
  if (recorded.bound) limits.rounding = std::min(limits.rounding, *recorded.bound + kCheckError);
  limits.searched = recorded.bound ? *recorded.bound + kCheckError : kSearchedLimit * limits.rounding;
  for (const Promise& promise : record.promises) {
    if (promise.scalar != scalar || !name.starts_with(promise.kernels)) continue;
    if (promise.rounding) limits.rounding = std::min(limits.rounding, *promise.rounding);
    if (promise.total_absolute) limits.total_absolute = *promise.total_absolute;
  }
  return limits;
}

bool bits_must_agree(const KernelResult& result) {
  const auto is_excused = [&](const char* start) { return result.kernel.starts_with(start); };
  return result.operations.other == 0 && std::none_of(kRegroupedAnyway.begin(), kRegroupedAnyway.end(), is_excused);
}

std::vector<std::string> failures_of(const KernelResult& result, const FamiliesRecord& record) {
  const std::string name = result.kernel + " " + result.language + " " + result.scalar + ": ";
  std::vector<std::string> failures;
  check_errors(result, name, record, failures);
  if (result.different_in_place > 0) {
    failures.push_back(name + std::to_string(result.different_in_place) +
                       " values change when an input array is overwritten by the output");
  }
  if (result.bits && result.bits->different > 0 && bits_must_agree(result)) {
    failures.push_back(name + std::to_string(result.bits->different) + " of " + std::to_string(result.bits->compared) +
                       " values differ from c++ float in their bits; first: " + result.bits->first_difference);
  }
  return failures;
}

}  // namespace sh::numeric
