// A kernel of the catalogue under a mask: made, checked against the full one, measured, chosen.
//
// The full kernel of the recipe is checked against the exact functions; the masked one, after every pass, against the
// full one at the same inputs.
#pragma once

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"

namespace sh::codegen {

/// The masked kernel after the mask and after every pass. Errors as kernel_stages and make_mask.
std::vector<Stage> masked_stages(const Family& family, const Recipe& recipe, int degree, const MaskOptions& options);

/// The recipe with the fewest operations under the mask or, with Prefer::kAccuracy, with the least error. The recipe
/// that suits the full kernel may not suit the masked one.
FinishedKernel masked_kernel(const Family& family, int degree, Prefer prefer, const MaskOptions& options);

}  // namespace sh::codegen
