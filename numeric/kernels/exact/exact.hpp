// The exact values of every family of kernels, from numeric's algorithms alone. One file a group of families.
//
// A new family: a row in one of these files, or a new file and a line in exact_families().
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

/// A point at which kernels are tried; its values are rounded to the kernel's type before use.
struct NamedInput {
  std::string name;  // "near pole 17"
  std::vector<double> values;
};

/// A function (degree, in, out) for the two reals of the oracle: long double beside float kernels, Mpfr50 beside
/// double. Made from a lambda that takes either.
class RealFunction {
 public:
  RealFunction() = default;
  template <class F>
  RealFunction(F function)
      : in_long_double_(function), in_mpfr_(function) {}  // NOLINT(*-forwarding-reference-overload)

  explicit operator bool() const { return static_cast<bool>(in_mpfr_); }
  void operator()(int degree, const long double* in, long double* out) const { in_long_double_(degree, in, out); }
  void operator()(int degree, const Mpfr50* in, Mpfr50* out) const { in_mpfr_(degree, in, out); }

 private:
  std::function<void(int, const long double*, long double*)> in_long_double_;
  std::function<void(int, const Mpfr50*, Mpfr50*)> in_mpfr_;
};

struct ExactFamily {
  std::string family;
  RealFunction values;  // at flat inputs and outputs
  /// The values to try for the parameter that another kernel makes, such as band matrices. Its numbers belong
  /// together.
  std::function<std::vector<NamedInput>(int degree)> made = {};
};

/// One list a file of this folder.
std::vector<ExactFamily> exact_project();
std::vector<ExactFamily> exact_zonal();
std::vector<ExactFamily> exact_window();
std::vector<ExactFamily> exact_irradiance();
std::vector<ExactFamily> exact_product();
std::vector<ExactFamily> exact_rotation();
std::vector<ExactFamily> exact_transfer();

/// These and the families of exact.cpp.
const std::vector<ExactFamily>& exact_families();

}  // namespace sh::numeric
