// Measures the error of a kernel on its family's test inputs, in float, double and half, without contraction.
//
// Rounding error: the difference from the kernel's own formula in exact arithmetic at the same rounded input. Total
// error: the difference from the exact functions at the point of the domain that the input represents (for a direction:
// the direction scaled to length 1). A caller sees the total error. Both errors are the largest over all test inputs
// and all outputs. The unit of "eps" is machine epsilon x the size that the domain gives for the output.
#pragma once

#include <cln/float.h>

#include <optional>
#include <string>
#include <vector>

#include "codegen/bound/bound.hpp"
#include "codegen/families/family.hpp"
#include "codegen/ir/cost.hpp"
#include "numeric/kernels/signature.hpp"

namespace sh::codegen {

/// An error in absolute and relative units.
struct Error {
  double absolute = 0;
  double eps = 0;  ///< in units of machine epsilon x size
};

/// The largest errors seen of one kernel in one type.
struct MeasuredError {
  int inputs = 0;  ///< the number of test inputs
  Error rounding;
  Error total;
  std::vector<double> worst;                ///< the flattened input with the largest rounding error in eps
  int searched = 0;                         ///< evaluations of a search for more inputs; 0: there was none
  std::optional<bound::Bound> proved = {};  ///< the bound of the rounding error; empty: not asked for
};

/// The errors at the test inputs. T: float, double or Half.
template <class T>
MeasuredError measure(const Kernel& kernel, const Domain& domain);

/// Takes more inputs into the errors, such as those that a search found (search.hpp). They do not count as test inputs.
template <class T>
void measure_more(MeasuredError& error, const Kernel& kernel, const Domain& domain,
                  const std::vector<std::vector<double>>& inputs);

/// A kernel at the end of the pipeline, with all facts that its file states.
struct FinishedKernel {
  Kernel kernel;
  Domain domain;
  Cost cost;
  MeasuredError in_float;
  MeasuredError in_double;
};

/// Counts the operations of a kernel and measures its errors.
FinishedKernel finish(Kernel kernel, Domain domain);

/// The point of the kernel's domain that rounded inputs represent; the roles of the parameters determine it. Directions
/// and quaternions are scaled to length 1, a cosine and its sine to the unit circle, and a matrix becomes the nearest
/// rotation. All other inputs already lie in the domain. inputs: flattened parameters.
std::vector<cln::cl_F> nearest_in_domain(const std::vector<Parameter>& parameters, std::vector<cln::cl_F> inputs);

/// A description: "the direction scaled to length 1"; empty if all inputs already lie in the domain.
std::string nearest_point(const std::vector<Parameter>& parameters);

/// The parameters and results of the printed function, in any language. Its flat inputs and outputs equal the kernel's.
numeric::Signature printed_signature(const Kernel& kernel);

/// The size that an error is compared with, at flattened inputs for an element of the flattened results. Throws
/// std::invalid_argument for a wrong formula.
Size size_of(const Kernel& kernel, const Domain& domain);

}  // namespace sh::codegen
