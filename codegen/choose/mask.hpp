// A scene knows some coefficients beforehand to be zero or equal, and does not want some results. A mask takes them out
// of a kernel before its passes run.
//
// Input: a kernel and the knowledge. Output: the kernel without the operations that it does not need. Its arrays keep
// their shapes; known entries are not read, dropped results are not written.
//
// A coefficient array is a parameter or result whose role orders its entries by degree and order (codegen/ir/role.hpp):
// entry i belongs to degree l = floor(sqrt(i)) and order m = i - l(l+1). Zonal coefficients are one entry a degree,
// m = 0.
#pragma once

#include <string>
#include <vector>

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// As given on the command line; empty: nothing is known.
struct MaskOptions {
  std::string left;     ///< symmetries of the first coefficient array: "zonal" or "mirror-x,mirror-y"
  std::string right;    ///< of the second
  std::string outputs;  ///< symmetries that a wanted coefficient of the result has, or a list of entries: "0,2,6"
  std::vector<int> keep_bands;   ///< other degrees are zero in every array, and not wanted
  std::vector<int> keep_orders;  ///< other orders m likewise

  [[nodiscard]] bool empty() const;
  /// " --left zonal --keep-bands 0,1": the options of `shgen emit`.
  [[nodiscard]] std::string arguments() const;
  /// "_left_zonal_bands_0_1": the end of the name of a masked kernel.
  [[nodiscard]] std::string suffix() const;
};

/// Symmetries, each with the functions f that have it:
///   zonal                  depends on z alone: m = 0
///   mirror-x               f(-x, y, z) = f(x, y, z), and mirror-y, mirror-z likewise
///   hemisphere             another name for mirror-z: known on the upper hemisphere alone
///   mirror-xy              f(y, x, z) = f(x, y, z)
const std::vector<std::string>& mask_symmetries();

/// The knowledge about one flattened input.
struct KnownInput {
  enum class Kind { kFree, kZero, kSame, kOpposite };
  Kind kind = Kind::kFree;
  int of = -1;  ///< kSame, kOpposite: the input that stands for it
};

struct Mask {
  std::vector<KnownInput> inputs;  ///< of every flattened parameter
  std::vector<bool> wanted;        ///< of every flattened result
};

/// Throws std::invalid_argument, one line, for unknown symmetries, an array that the kernel does not have, entries or
/// degrees out of range, and masks that leave no result.
Mask make_mask(const Kernel& kernel, const MaskOptions& options);

/// The masked kernel, zeros and signs folded. Its domain and result name the entries that are not read and not written.
Kernel apply_mask(const Kernel& kernel, const Mask& mask);

/// Inputs as the mask says: zeros, equals and opposites filled in.
template <class T>
std::vector<T> masked_inputs(std::vector<T> inputs, const Mask& mask) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const KnownInput& known = mask.inputs[i];
    if (known.kind == KnownInput::Kind::kZero) inputs[i] = T(0);
    if (known.kind == KnownInput::Kind::kSame) inputs[i] = inputs[static_cast<std::size_t>(known.of)];
    if (known.kind == KnownInput::Kind::kOpposite) inputs[i] = -inputs[static_cast<std::size_t>(known.of)];
  }
  return inputs;
}

}  // namespace sh::codegen
