// The exact values that kernels of one family and degree are measured against, at every input of the family's check.
//
// Two errors are told apart (README.md): total, against the true function at the point x' of the domain that the
// rounded input x stands for; and rounding, against the kernel's own formula in exact arithmetic at x itself. The own
// formula comes from running the kernel on Wide: it is f(x') + K(x) - K(x'), f the oracle, K the kernel on Wide. The
// difference cancels the rounded constants of K and leaves the effect of an input slightly outside its domain. A kernel
// with a wrong formula fails both: K(x') is no part of the result but as a difference. Where every input is in the
// domain, x = x', the two errors are one.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "numeric/kernels/bind.hpp"
#include "numeric/kernels/family_check.hpp"
#include "numeric/kernels/wide.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {

/// T: float or double.
template <class T>
struct Samples {
  Signature signature;
  std::vector<std::string> names;  // (n)
  std::vector<T> inputs;           // (n, input_count), rounded
  std::vector<Wide> in_domain;     // (n, input_count), x'; empty where x' = x
  std::vector<Wide> exact;         // (n, output_count), f(x')
  std::vector<double> sizes;       // (n, output_count), the unit of errors but for epsilon

  [[nodiscard]] std::size_t count() const { return names.size(); }
  [[nodiscard]] const T* input(std::size_t i) const { return inputs.data() + i * signature.input_count(); }
};

template <class T>
Samples<T> make_samples(const FamilyCheck& check, int degree);

/// (n, output_count): the own formula of a kernel at every input.
template <class T>
std::vector<Wide> own_formula(const BoundKernel& kernel, const Samples<T>& samples);

/// Errors of values (n, output_count) against `truth`: Samples::exact, or own_formula. Absolute errors, and in epsilon
/// x size; a size that is not 0 counts as at least `smallest_size`, since the spacing of numbers stops falling
/// somewhere.
template <class T>
ErrorStats errors_of(const Samples<T>& samples, const std::vector<T>& values, const std::vector<Wide>& truth,
                     double smallest_size = static_cast<double>(std::numeric_limits<T>::min()));

/// "out l=4 m=-3" where the array holds all coefficients up to the degree, "m[13]" elsewhere, "value" if returned.
std::string output_label(const Signature& signature, int degree, std::size_t output);

/// Where the largest error occurred.
struct WorstCase {
  std::string input;  // by name, "near pole 17"
  std::vector<double> values;
  std::string output;  // "out l=4 m=-3"
};

/// The place in words and numbers.
template <class T>
WorstCase worst_case(const Place& worst, int degree, const Samples<T>& samples);

}  // namespace sh::numeric
