// Compares every generated kernel with the oracle, and the GLSL ones with C++ as well.
//
// Input: the folder generated/. Output: one result for every kernel, language and scalar: C++ float, C++ double, GLSL
// 4.50 and GLSL ES 3.00, families and degrees as generated/cpp has them. Whether a result passes is decided by
// kernel_limits.hpp.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/family_check.hpp"
#include "numeric/kernels/samples.hpp"
#include "numeric/kernels/wide.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {

/// Values of a GLSL kernel against C++ float without contraction. Values that differ by less than the smallest normal
/// number count as flushed, not as different: GLSL may take subnormal numbers for zero (OpenGL Shading Language 4.50,
/// section 4.7.1). Where values differ otherwise, the kernel is run once more with its results declared invariant,
/// which keeps the compiler from regrouping: values that differ then are different, values that differed only before
/// are regrouped. The errors of a kernel are those of the first run.
struct BitComparison {
  std::size_t compared = 0;
  std::size_t flushed = 0;
  std::size_t regrouped = 0;
  std::size_t different = 0;
  std::string first_difference;  // empty if none
};

struct KernelResult {
  std::string kernel;    // basis_accurate_l4
  std::string family;    // basis_accurate
  std::string language;  // c++, glsl 450, glsl es 300
  std::string scalar;    // float, double
  int degree = 0;
  std::string unit;  // of errors, times epsilon
  std::size_t inputs = 0;
  Operations operations;
  ErrorStats rounding;  // against the kernel's own formula at the rounded input
  ErrorStats total;     // against the true function at the point of the domain that the rounded input stands for
  WorstCase worst_rounding = {};
  WorstCase worst_total = {};
  std::optional<double> nanoseconds = {};  // a call; informative, C++ only
  std::optional<BitComparison> bits = {};  // GLSL only
  std::size_t different_in_place = 0;      // outputs that change when an input array is overwritten; C++ only
};

struct CheckOptions {
  std::filesystem::path generated;  // the folder whose GLSL files are run
  std::string family;               // only this one, its variants included; empty: all
};

/// Bound kernels whose family no check describes: none, unless a check is missing.
std::vector<std::string> unchecked_kernels(const std::vector<BoundKernel>& kernels);

/// Results by family, degree, language and scalar. `progress` receives one line a family. Throws std::invalid_argument
/// for an unknown family, std::runtime_error when a GLSL file cannot be read or compiled or EGL is missing; one line.
std::vector<KernelResult> check_kernels(const CheckOptions& options,
                                        const std::function<void(const std::string&)>& progress);

/// The results of one kernel, bound or made up. Without GLSL where `generated` is empty.
std::vector<KernelResult> check_kernel(const BoundKernel& kernel, const std::filesystem::path& generated);

/// Compares values (n, output_count) of a kernel in GLSL and in C++; `regrouped` stays 0. A difference counts as flushed up
/// to 256 times the smallest normal number, times the size of the value if that is more than 1: a flushed intermediate
/// value may have been multiplied since, by constants and by large inputs.
BitComparison compare_bits(int degree, const std::vector<float>& cpp, const std::vector<float>& glsl,
                           const Samples<float>& samples);

/// The errors alone of a kernel in C++ on T, float or double, at the inputs of a check: its family's own with, say,
/// other inputs.
template <class T>
KernelResult kernel_errors(const BoundKernel& kernel, const FamilyCheck& check);

/// One line a kernel below a header: operations, errors in C++, agreement of GLSL, times, worst input. Ends with a line
/// feed. Results of one kernel have to follow each other, C++ float first, as check_kernels gives them.
std::string format_summary(const std::vector<KernelResult>& results);

/// One line a kernel, language and scalar below a header.
std::string format_details(const std::vector<KernelResult>& results);

/// The details with every measure in full, its limits, the convention and the failures.
std::string format_json(const std::vector<KernelResult>& results, const std::vector<std::string>& failures);

}  // namespace sh::numeric
