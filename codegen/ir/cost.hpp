// The cost of a kernel: the operations that reach an output, the longest chain of them, and the register pressure.
#pragma once

#include "codegen/ir/ir.hpp"

namespace sh::codegen {

/// The numbers of operations of each kind, and the two measures that depend on their order.
struct Cost {
  int mul = 0;
  int add = 0;  ///< additions and subtractions
  int fma = 0;
  int neg = 0;
  int div = 0;
  int sqrt = 0;
  int select = 0;
  int depth = 0;     ///< operations on the longest chain from an input to an output
  int max_live = 0;  ///< the largest number of live values in the given order; inputs count, constants do not
  [[nodiscard]] int operations() const { return mul + add + fma + neg + div + sqrt + select; }
};

/// Nodes that reach no output cost nothing. The body of a loop counts once for every row. A sum over the rows counts as
/// one addition for every row.
Cost cost(const Kernel& kernel);

}  // namespace sh::codegen
