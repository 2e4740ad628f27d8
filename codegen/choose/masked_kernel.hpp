// Makes a masked kernel of the catalogue, checks it against the full kernel, measures it and chooses among recipes.
//
// The pipeline checks the full kernel of the recipe against the exact functions. After every pass it checks the masked
// kernel against the full kernel at the same inputs.
#pragma once

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/mask.hpp"

namespace sh::codegen {

/// The kernel after the mask and after every pass. Throws the exceptions of kernel_stages and make_mask.
std::vector<Stage> masked_stages(const Family& family, const Recipe& recipe, int degree, const MaskOptions& options);

/// The masked kernel with the fewest operations or, with Prefer::kAccuracy, with the least error. The best recipe of
/// the full kernel may not be the best recipe of the masked one.
FinishedKernel masked_kernel(const Family& family, int degree, Prefer prefer, const MaskOptions& options);

}  // namespace sh::codegen
