// Compares every generated kernel with the oracle, and the GLSL ones bit by bit with C++.
//
// Input: the folder generated/. Output: one result for every kernel, language and scalar: degrees 0..10 in C++ float,
// C++ double, GLSL 4.50 and GLSL ES 3.00. Whether a result passes is decided by kernel_limits.hpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/counted.hpp"
#include "numeric/error_stats.hpp"

namespace sh::numeric {

// Values of a GLSL kernel against C++ float without contraction. A value that C++ has as a subnormal number and GLSL as
// zero counts as flushed, not as different: GLSL leaves that open (OpenGL Shading Language 4.50, section 4.7.1).
struct BitComparison {
  std::size_t compared = 0;
  std::size_t flushed = 0;
  std::size_t different = 0;
  std::string first_difference;  // empty if none
};

struct KernelResult {
  std::string kernel;    // basis_l4
  std::string language;  // c++, glsl 450, glsl es 300
  std::string scalar;    // float, double
  int degree = 0;
  Operations operations;
  ErrorStats rounding;  // against the kernel's own polynomial at the rounded input
  ErrorStats total;     // against the true function at the rounded input, normalised
  std::optional<double> nanoseconds;
  std::optional<BitComparison> bits;
};

// Results by degree, then language and scalar. `progress` receives one line a step. Throws std::runtime_error, one
// line, when a GLSL file cannot be read or compiled or EGL is missing.
std::vector<KernelResult> check_kernels(const std::filesystem::path& generated,
                                        const std::function<void(const std::string&)>& progress);

// How many directions the kernels are compared on.
std::size_t checked_direction_count();

}  // namespace sh::numeric
