// The pipeline of a kernel: recipe -> share -> factor -> fold -> prune -> associate -> schedule, with a check after
// every step.
//
// After the recipe and after every pass the pipeline evaluates the kernel with 100 digits at random points of its
// domain. The values have to agree with the exact functions to 90 digits. It also checks that the cost does not rise,
// except after passes that may raise it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "codegen/families/family.hpp"

namespace sh::codegen {

/// A pass and its name.
struct Pass {
  std::string name;
  Kernel (*run)(const Kernel&);
  bool may_raise_cost = false;
};

/// A kernel after one step of the pipeline.
struct Stage {
  std::string name;  ///< "recipe" or the pass that produced the kernel
  Kernel kernel;
};

/// share, factor, fold, prune, associate, schedule.
const std::vector<Pass>& default_passes();

/// All stages: the recipe is the first, the result is the last. Throws std::runtime_error if a value is wrong (it names
/// the pass, the kernel and the output) or if the cost rises (it names both costs).
std::vector<Stage> run_pipeline(Kernel recipe, const Reference& reference, std::span<const Pass> passes);

}  // namespace sh::codegen
