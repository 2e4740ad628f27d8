// The limits that a kernel's measured error must keep: the error that the generator recorded for it, times a factor
// that the record states, and the promises of the project.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "numeric/kernels/kernel_check.hpp"

namespace sh::numeric {

struct KernelLimits {
  double rounding = 0;  // largest rounding error, in epsilon x the family's unit
  double total = 0;     // largest total error, likewise
  double total_absolute = std::numeric_limits<double>::infinity();  // where users are promised a number
  double searched =
      0;  // largest rounding error that a search may find: the proved bound, or else kSearchedLimit limits
};

/// How many times the limit of an unproved error, which holds on the inputs of the family's check, a search for the worst
/// input may find (kernel_search.hpp).
inline constexpr double kSearchedLimit = 4;

/// Every language of a scalar ("float" or "double") has the same limits. None for a family and degree that the record
/// does not have, which failures_of reports.
std::optional<KernelLimits> limits_for(const std::string& family, int degree, const std::string& scalar,
                                       const FamiliesRecord& record = families_record());

/// Whether a GLSL kernel has to have the bits of C++ float (BitComparison::different = 0): the languages agree on + - *
/// to the last bit; on division, roots and selections they need not.
bool bits_must_agree(const KernelResult& result);

/// One line for every limit exceeded or comparison failed, naming kernel, language and scalar; empty if all is well.
std::vector<std::string> failures_of(const KernelResult& result, const FamiliesRecord& record = families_record());

}  // namespace sh::numeric
