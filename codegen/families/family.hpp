// A family of kernels: the functions computed for every degree, the ways to compute them, and their checks. A file of
// this folder describes families that share their mathematics.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// An exact point of a kernel's domain and the exact outputs at this point.
struct ReferencePoint {
  std::vector<cln::cl_RA> inputs;  ///< flattened parameters
  std::vector<cln::cl_F> outputs;  ///< flattened results with kCheckDigits digits
};
using Reference = std::vector<ReferencePoint>;

/// The decimal digits of exact checks.
inline constexpr int kCheckDigits = 100;

/// The size that the error of an element of the flattened results is compared with, at the flattened inputs.
using Size = std::function<double(std::span<const double> inputs, std::size_t element)>;

/// The inputs at which the kernels of a family are measured, and the unit of their errors.
struct Domain {
  std::string inputs;  ///< description: "directions (random, axes, poles, near poles)"
  std::string unit;    ///< description: "sqrt((2l+1)/(4 pi))", the size that multiplies machine epsilon
  /// Flattened inputs. The measurement rounds each of them to the kernel's type.
  std::function<std::vector<std::vector<double>>(int degree)> test_inputs;
  /// The unit as formulas (numeric/kernels/size_formula.hpp), one for each result; the last one serves all further
  /// results.
  std::vector<std::string> sizes;
  /// The largest output that inputs of length 1 can produce; only for formulas that use it.
  std::function<double(int degree, std::size_t element)> gain = {};
  std::array<double, 2> lengths = {1, 1};  ///< the least and the largest length of tested vectors
  Size size = {};                          ///< replaces the formulas in another convention; empty: the formulas
};

/// A fixed error bound of some kernels, in addition to the limit that follows from their measured errors.
struct Promise {
  std::string kernels;      ///< the beginning of the names of these kernels: "basis_accurate_l"
  std::string scalar;       ///< "float" or "double"
  double rounding_eps = 0;  ///< the largest rounding error in epsilon x size; 0: no bound
  double total = 0;         ///< the largest absolute total error; 0: no bound
  std::string reason;
};

/// One way to compute a family.
struct Recipe {
  std::string name;  ///< "recurrence"
  std::function<Kernel(int degree)> make;
  int smallest = 0;       ///< the smallest degree that the recipe serves
  int largest = 20;       ///< the largest degree that the recipe serves
  bool for_speed = true;  ///< false: the error is too large for the speed choice, even if the recipe is the fastest
};

/// Describes the driver that runs a family over many records on SIMD lanes. The roles of the kernel's parameters
/// determine the rest.
struct BatchDriver {
  std::string what;           ///< one line: the values that the driver computes
  std::string prepare = {};   ///< the family that runs once if all records share input 0; empty: there is none
  std::string prepared = {};  ///< the family that takes the result of `prepare`, of the same size, in place of input 0
  std::string parts = {};     ///< for a sum: the family that adds up intermediate values faster; empty: there is none
  std::string finish = {};    ///< the family that makes the sum from these values
  bool half = false;          ///< true: input 0 may be half precision
  bool rings = false;         ///< true: visibility times a light, in stages (runtime/transfer_rings.hpp)
  bool scalar_products = false;  ///< true: of rows with input 1, in loops (multiply_blocks, multiply_records)
  bool groups =
      false;  ///< true: plain records go through registers in groups (runtime/groups.hpp); for kernels of + - *
  /// By degree, the last one for all further: the most records that 16 lanes compute slower than the kernel one by one, as
  /// measured. Empty: there is no such loop.
  std::vector<int> single = {};
  /// Without `groups`: the last degree at which plain records (of a sum: few) go through registers in groups, in a call that
  /// needs no driver.
  int grouped = -1;
  int largest = 10;  ///< the largest degree; beyond it a driver does not justify its compile time
};

/// A family of kernels, one for each degree.
struct Family {
  std::string name;
  int largest_written = 10;  ///< `shgen write` writes degrees 0 to this
  int largest_emitted = 20;  ///< `shgen emit` prints degrees 0 to this
  /// The reason for largest_emitted, one line.
  std::string limit = "straight-line code of a higher degree is too long to be useful";
  std::vector<Recipe> recipes;
  /// The exact outputs of the family at `count` points of its domain. They come from symbolic/, not from a recipe.
  std::function<Reference(int degree, int count)> reference;
  Domain domain;
  std::string arguments = {};  ///< the arguments of `shgen emit` in place of the name; empty: the name
  /// The same family with separate degrees of both factors and the result; empty: there is none.
  std::function<Family(int left_degree, int right_degree, int degree)> of_degrees = {};
  std::optional<BatchDriver> batch = {};  ///< empty: there is no driver, and callers call the kernels one by one
  std::vector<Promise> promises = {};
};

/// All families, in the order of MANIFEST.
const std::vector<Family>& families();

/// The product of factors of these degrees, projected on bands 0 .. degree. Its recipes serve this shape only. Throws
/// std::invalid_argument, one line, unless 0 <= left_degree, right_degree <= symbolic::kMaxProductDegree and
/// 0 <= degree <= left_degree + right_degree.
Family rectangular_product_family(int left_degree, int right_degree, int degree);

/// The families of each file in this folder.
std::vector<Family> basis_families();
std::vector<Family> evaluate_families();
std::vector<Family> project_families();
std::vector<Family> zonal_families();
std::vector<Family> irradiance_families();
std::vector<Family> window_families();
std::vector<Family> rotation_families();
std::vector<Family> product_families();
std::vector<Family> transfer_families();
std::vector<Family> relight_families();

}  // namespace sh::codegen
