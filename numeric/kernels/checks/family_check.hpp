// What is checked of a family of kernels: its signature, the inputs tried, the exact values, the unit of its error.
//
// One file a family in this folder makes one, from numeric's algorithms alone; checks.hpp lists them. Inputs and
// outputs are flat, in the order of signature.hpp. A family's variants (basis_accurate of basis) share its check.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "numeric/kernels/signature.hpp"
#include "numeric/oracle/real.hpp"

namespace sh::numeric {

// A point at which kernels are tried; its values are rounded to the kernel's type before use.
struct NamedInput {
  std::string name;  // "near pole 17"
  std::vector<double> values;
};

// A function (degree, in, out) for the two reals of the oracle: long double beside float kernels, Mpfr50 beside double.
// Made from a lambda that takes either.
class RealFunction {
 public:
  RealFunction() = default;
  template <class F>
  RealFunction(
      F function)  // NOLINT(google-explicit-constructor,bugprone-forwarding-reference-overload): a lambda is one
      : in_long_double_(function), in_mpfr_(function) {}

  explicit operator bool() const { return static_cast<bool>(in_mpfr_); }
  void operator()(int degree, const long double* in, long double* out) const { in_long_double_(degree, in, out); }
  void operator()(int degree, const Mpfr50* in, Mpfr50* out) const { in_mpfr_(degree, in, out); }

 private:
  std::function<void(int, const long double*, long double*)> in_long_double_;
  std::function<void(int, const Mpfr50*, Mpfr50*)> in_mpfr_;
};

struct FamilyCheck {
  std::string family;
  std::function<Signature(int degree)> signature;
  std::function<std::vector<NamedInput>(int degree)> inputs;
  // out = the exact outputs at `in`.
  RealFunction oracle;
  // out = the point of the domain that the rounded input `in` stands for, such as a direction scaled to length 1.
  // Empty: every input is in the domain.
  RealFunction nearest;
  // What the error of an output is compared with, at an input; in words for reports.
  std::function<double(int degree, const double* in, std::size_t output)> size;
  std::string unit;
};

}  // namespace sh::numeric
