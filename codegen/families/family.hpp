// A family of kernels: the functions computed for every degree, the ways to compute them, and their checks.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// Exact points of a kernel's domain with the exact outputs there.
struct ReferencePoint {
  std::vector<cln::cl_RA> inputs;  // flattened parameters
  std::vector<cln::cl_F> outputs;  // flattened results, kCheckDigits digits
};
using Reference = std::vector<ReferencePoint>;

inline constexpr int kCheckDigits = 100;

/// The size of the values that an element of the flattened results is compared with, at flattened inputs.
using Size = std::function<double(std::span<const double> inputs, std::size_t element)>;

/// Where a family's kernels are measured, and in which unit their error is counted.
struct Domain {
  std::string inputs;  ///< for people: "directions (random, axes, poles, near poles)"
  std::string unit;    ///< for people: "sqrt((2l+1)/(4 pi))", the size that machine epsilon is multiplied by
  /// Flattened inputs, each rounded to the kernel's type before use.
  std::function<std::vector<std::vector<double>>(int degree)> test_inputs;
  /// The unit as formulas, one a result, the last for all further ones (numeric/kernels/size_formula.hpp).
  std::vector<std::string> sizes;
  /// For a formula that asks for it: the most that inputs of length 1 make of an output.
  std::function<double(int degree, std::size_t element)> gain = {};
  std::array<double, 2> lengths = {1, 1};  ///< of vectors: the least and the largest to try
  Size size = {};                          ///< instead of the formulas, in another convention
};

/// A bound that kernels keep besides the limit that their measured error gives.
struct Promise {
  std::string kernels;      ///< the beginning of their names: "basis_accurate_l"
  std::string scalar;       ///< "float" or "double"
  double rounding_eps = 0;  ///< largest rounding error in epsilon x size; 0: none
  double total = 0;         ///< largest total error, absolute; 0: none
  std::string reason;
};

/// One way to compute a family.
struct Recipe {
  std::string name;  ///< "recurrence"
  std::function<Kernel(int degree)> make;
  int smallest = 0;  ///< it serves degrees smallest .. largest
  int largest = 20;
  bool for_speed = true;  ///< false: its error keeps it from being the speed choice, however fast it is
};

/// A driver over many records on SIMD lanes, made from the kernels of a family by their roles.
struct BatchDriver {
  std::string what;           ///< one line: the values that it computes
  std::string prepare = {};   ///< family computed once from input 0 where that is shared; empty: there is none
  std::string prepared = {};  ///< the family that takes its result, of the same size, in place of input 0
  std::string parts = {};     ///< for a sum: the family that adds up something faster; empty: there is none
  std::string finish = {};    ///< the family that makes the sum of it
  bool half = false;          ///< input 0 may be half precision
  int largest = 10;           ///< degree; beyond, a driver is not worth the time it takes to compile
};

struct Family {
  std::string name;
  int largest_written = 10;  ///< `shgen write` writes degrees 0 to this
  int largest_emitted = 20;  ///< `shgen emit` prints degrees 0 to this
  /// Why not further, one line.
  std::string limit = "beyond which straight-line code is too long to be useful";
  std::vector<Recipe> recipes;
  /// Exact outputs of the family at `count` points of its domain, derived from symbolic/, not from a recipe.
  std::function<Reference(int degree, int count)> reference;
  Domain domain;
  std::string arguments = {};  ///< for `shgen emit` in place of the name; empty: the name
  /// A family alike whose factors and result have degrees of their own; empty: there is none.
  std::function<Family(int left_degree, int right_degree, int degree)> of_degrees = {};
  std::optional<BatchDriver> batch = {};  ///< empty: kernels are called one by one
  std::vector<Promise> promises = {};
};

}  // namespace sh::codegen
