// The user of a kernel may know in advance that some coefficients are zero or equal, and may not need some results. A
// mask removes these from the kernel before the passes run.
//
// Input: a kernel and this knowledge. Output: the kernel without the operations that it does not need. Its arrays keep
// their shapes. The kernel does not read known entries and does not write dropped results.
//
// A coefficient array is a parameter or result whose role orders its entries by degree and order (codegen/ir/role.hpp):
// entry i belongs to degree l = floor(sqrt(i)) and order m = i - l(l+1). Zonal coefficients have one entry for each
// degree, with m = 0.
#pragma once

#include <string>
#include <vector>

#include "codegen/choose/catalogue.hpp"

namespace sh::codegen {

/// The options of the command line; empty: nothing is known. A function f has the symmetry
///   zonal         if it depends on z only: m = 0
///   mirror-x      if f(-x, y, z) = f(x, y, z); mirror-y and mirror-z follow the same rule
///   hemisphere    if it has mirror-z: its values on the upper hemisphere determine it
///   mirror-xy     if f(y, x, z) = f(x, y, z)
struct MaskOptions {
  std::string left;     ///< the first coefficient array: symmetries, "zonal" or "mirror-x,mirror-y", or a list of the
                        ///< entries that are not zero in any channel, "0,2,6"
  std::string right;    ///< the same of the second coefficient array
  std::string outputs;  ///< the wanted results: symmetries of their functions, or a list of entries such as "0,2,6"
  std::vector<int> keep_bands;   ///< all other degrees are zero in every array and are not wanted
  std::vector<int> keep_orders;  ///< all other orders m are zero in every array and are not wanted

  [[nodiscard]] bool empty() const { return arguments().empty(); }
  /// " --left zonal --keep-bands 0,1": the options of `shgen emit`.
  [[nodiscard]] std::string arguments() const;
  /// "_left_zonal_bands_0_1": the end of the name of a masked kernel.
  [[nodiscard]] std::string suffix() const;
};

/// The knowledge about one flattened input.
struct KnownInput {
  enum class Kind { kFree, kZero, kSame, kOpposite };
  Kind kind = Kind::kFree;
  int of = -1;  ///< kSame, kOpposite: the input that has the same or the opposite value
};

/// The knowledge about all inputs and results of a kernel.
struct Mask {
  std::vector<KnownInput> inputs;  ///< one for every flattened parameter
  std::vector<bool> wanted;        ///< one for every flattened result
};

/// Throws std::invalid_argument, one line, if a symmetry is unknown, if the kernel does not have an array, if an entry
/// or degree is out of range, or if the mask leaves no result.
Mask make_mask(const Kernel& kernel, const MaskOptions& options);

/// The masked kernel after zeros and signs are folded. Its texts for domain and result name the entries that it does
/// not read or does not write.
Kernel apply_mask(const Kernel& kernel, const Mask& mask);

/// The inputs after the mask has filled in zero, equal and opposite values.
template <class T>
std::vector<T> masked_inputs(std::vector<T> inputs, const Mask& mask) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const KnownInput& known = mask.inputs[i];
    if (known.kind == KnownInput::Kind::kZero) inputs[i] = T(0);
    if (known.kind == KnownInput::Kind::kSame) inputs[i] = inputs[known.of];
    if (known.kind == KnownInput::Kind::kOpposite) inputs[i] = -inputs[known.of];
  }
  return inputs;
}

/// The kernel after the mask and after every pass. The pipeline checks the full kernel of the recipe against the exact
/// functions, and after every pass the masked kernel against the full kernel at the same inputs. Throws the exceptions
/// of kernel_stages and make_mask.
std::vector<Stage> masked_stages(const Family& family, const Recipe& recipe, int degree, const MaskOptions& options);

/// The masked kernel with the fewest operations or, with Prefer::kAccuracy, with the least error. The best recipe of
/// the full kernel may not be the best recipe of the masked one.
FinishedKernel masked_kernel(const Family& family, int degree, Prefer prefer, const MaskOptions& options);

}  // namespace sh::codegen
