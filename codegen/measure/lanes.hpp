// Runs a kernel at many inputs at once and follows the rounding error of every value.
//
// A value in lane i comes with its difference from the exact value at the same inputs. Each operation knows the rounding
// it makes, from an operation in double for float and half, from error-free transforms for double. So a search needs no
// arithmetic with more digits. The differences themselves are rounded to double.
// Reference: T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18
// (1971) 224.
#pragma once

#include <array>
#include <vector>

#include "codegen/bound/format.hpp"
#include "codegen/ir/ir.hpp"

namespace sh::codegen {

inline constexpr int kLanes = 16;
using Lanes = std::array<double, kLanes>;

/// T: float, double or Half.
template <class T>
class ErrorLanes {
 public:
  /// kernel: without a loop (passes::unroll); it has to outlive this object.
  ErrorLanes(const Kernel& kernel, const bound::Format& format);

  /// inputs: by flattened parameter; numbers of T.
  void operator()(const std::vector<Lanes>& inputs);
  /// |computed - exact| of an output.
  [[nodiscard]] double error(std::size_t output, int lane) const;

 private:
  const Kernel& kernel_;
  std::vector<Lanes> values_;
  std::vector<Lanes> errors_;
};

}  // namespace sh::codegen
