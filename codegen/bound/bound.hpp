// Proved bounds of rounding errors over a kernel's whole domain.
//
// Input: a kernel as it is printed, its family's domain, a format. Output: a bound of the rounding error as measure.hpp
// defines it: the difference from the kernel's own formula in exact arithmetic at the same rounded input. It holds with
// and without contraction to fused multiply-add, for operations that round to nearest and keep subnormal numbers.
//
// Boxes cover the domain. RoundingAnalysis bounds the error on a box; the box with the largest bound is split until the
// effort is spent or the bound is near that of a point. The largest bound of all boxes that are left holds everywhere.
// Kernels that multiply coefficients have one box (bilinear.hpp). Where the domain has few numbers, each is a box of its
// own (every_number.hpp).
#pragma once

#include <string>
#include <vector>

#include "codegen/bound/format.hpp"
#include "codegen/families/family.hpp"

namespace sh::codegen::bound {

/// A proved bound, or the reason why there is none.
struct Bound {
  double eps = 0;       ///< in epsilon x the family's size
  double absolute = 0;  ///< for arrays of length 1, or scalars and numbers up to 1, as the size asks; 0: not stated
  int boxes = 0;        ///< evaluated
  bool every_number = false;             ///< the boxes are all numbers of the format in the domain
  std::string domain = {};               ///< the inputs for which it holds
  std::vector<double> worst = {};        ///< flattened inputs where the bound is largest, not rounded
  std::vector<Interval> worst_box = {};  ///< the box of coordinates where the bound is largest
  std::string missing = {};              ///< why no bound is proved; empty: one is proved
  [[nodiscard]] bool is_proved() const { return missing.empty(); }
};

/// The work for a bound.
struct Effort {
  double operations = 8e6;  ///< nodes visited for each coordinate, after the first boxes
  double most_work = 1e9;   ///< nodes x inputs x outputs of a kernel of products; one with more gets no bound
};

Bound bound(const Kernel& kernel, const Domain& domain, const Format& format, const Effort& effort = {});

}  // namespace sh::codegen::bound
