// What the oracle says at every direction of the comparison: the values that kernels are measured against.
//
// Input: directions, a kernel's scalar type. Output: the rounded inputs and, for each, two sets of exact values of
// every degree up to the highest: those of the kernel's own polynomial at the rounded input (basis_z_form; against it
// there is only rounding error), and those of the true function at the rounded input scaled to length 1 (total error).
// Evaluated at 100 digits and kept as the unevaluated sum of two doubles, 106 bits.
#pragma once

#include <array>
#include <vector>

#include "numeric/directions.hpp"

namespace sh::numeric {

class ExactValue {
 public:
  ExactValue(double high, double low) : high_(high), low_(low) {}
  // computed - exact, with a relative error near 2^-52: computed - high cancels without rounding where it is small.
  [[nodiscard]] double error_of(double computed) const { return (computed - high_) - low_; }

 private:
  double high_;
  double low_;
};

template <class T>
struct OracleTable {
  int degree = 0;
  std::vector<std::array<T, 3>> inputs;    // (n, 3)
  std::vector<ExactValue> own_polynomial;  // (n, bands^2)
  std::vector<ExactValue> true_function;   // (n, bands^2)
};

// T is float or double.
template <class T>
OracleTable<T> make_oracle_table(int degree, const std::vector<Direction>& directions);

}  // namespace sh::numeric
