// A family of kernels: the functions computed for every degree, the ways to compute them, and their checks.
#pragma once

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

/// Where a family's kernels are measured, and in which unit their error is counted.
struct Domain {
  std::string inputs;  ///< for people: "directions (random, axes, poles, near poles)"
  std::string unit;    ///< for people: "sqrt((2l+1)/(4 pi))", the size that machine epsilon is multiplied by
  /// Flattened inputs, each rounded to the kernel's type before use.
  std::function<std::vector<std::vector<double>>(int degree)> test_inputs;
  /// The size of the values that an element of the flattened results is compared with, at an input.
  std::function<double(std::span<const double> inputs, std::size_t element)> size = {};
  /// Instead of `size` where it depends on the kernel's degree.
  std::function<double(int degree, std::span<const double> inputs, std::size_t element)> size_at_degree = {};

  [[nodiscard]] double size_of(int degree, std::span<const double> at, std::size_t element) const {
    return size != nullptr ? size(at, element) : size_at_degree(degree, at, element);
  }
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
};

}  // namespace sh::codegen
