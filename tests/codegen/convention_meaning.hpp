// The meaning of every family of kernels in a convention, as a property of functions of direction.
//
// A coefficient array c' stands for the function sum c'_i Y'_i(d), with Y'_i by formula (convention_definitions.hpp). A
// kernel means something for this function: `project` adds weight times the band-limited delta, `rotate` turns the
// function, `product` projects a product. The checks state this with Legendre sums, rotations of directions and
// quadrature, and never convert a coefficient.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/codegen/convention_definitions.hpp"

namespace sh::codegen::test {

using Arrays = std::map<std::string, std::vector<double>>;

/// Runs the emitted kernel of a family on parameters by name; returns parameters and results.
using Call = std::function<Arrays(const std::string& family, Arrays parameters)>;

/// A convention, the caller's axes and a degree.
struct World {
  const Definition& definition;
  std::string axes = "x,y,z";  ///< the coordinates of the convention's source in terms of the caller's
  int degree = 2;
};

/// The largest difference between what the kernel of the family computes and what it means, over some inputs; each
/// difference is relative to 1 + |expected|. NaN never occurs: an element that is not written counts as infinite.
double deviation(const std::string& family, const World& world, const Call& call);

/// The families that have a meaning here: all.
std::vector<std::string> families_with_meaning();

/// True if the family holds no numbers of a convention's functions.
bool has_no_functions(const std::string& family);
/// True if the family is the same for all axes.
bool has_no_axes(const std::string& family);
/// True if the family is the same in this convention as in ours.
bool is_shared(const std::string& family, const Definition& definition);
/// True if the family multiplies or convolves coefficients.
bool needs_radiance(const std::string& family);

/// The degree at which the family is checked, as near to `wanted` as it has one.
int degree_of(const std::string& family, int wanted);

}  // namespace sh::codegen::test
