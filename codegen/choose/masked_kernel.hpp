// A kernel of the catalogue without what a mask takes out: made, checked against the full one, measured, chosen.
//
// The full kernel of the recipe is checked against the exact functions; the masked one, after every pass, against the
// full one at the same inputs.
#pragma once

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"

namespace sh::codegen {

/// The masked kernel after the mask and after every pass. Errors as kernel_stages and make_mask.
std::vector<Stage> masked_stages(const Family& family, const Recipe& recipe, int degree, const MaskOptions& options);

/// Of all recipes the one that needs the fewest operations once masked, or with Prefer::kAccuracy the one that errs
/// least: what suits the full kernel need not suit what is left of it.
FinishedKernel masked_kernel(const Family& family, int degree, Prefer prefer, const MaskOptions& options);

}  // namespace sh::codegen
