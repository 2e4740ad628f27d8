// The cost of a kernel: operations that reach an output, the longest chain among them, and register pressure.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

struct Cost {
  int mul = 0;
  int add = 0;  ///< additions and subtractions
  int fma = 0;
  int neg = 0;
  int div = 0;
  int sqrt = 0;
  int select = 0;
  int depth = 0;     ///< operations on the longest chain from an input to an output
  int max_live = 0;  ///< most values (inputs included, constants not) held at once in the given order
  [[nodiscard]] int operations() const { return mul + add + fma + neg + div + sqrt + select; }
};

/// Nodes that reach no output cost nothing. The body of a loop counts once for every row; a sum over the rows is one
/// addition a row.
Cost cost(const Kernel& kernel);

}  // namespace sh::codegen
