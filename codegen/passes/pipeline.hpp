// The whole way of a kernel: recipe -> share -> factor -> fold -> prune -> associate -> schedule, checked after every
// step.
//
// After the recipe and after every pass the kernel is evaluated with 100 digits at random points of its domain and has
// to agree with the exact functions to 90 digits; a pass that promises not to raise the cost is held to it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "codegen/families/family.hpp"

namespace sh::codegen {

struct Pass {
  std::string name;
  Kernel (*run)(const Kernel&);
  bool may_raise_cost = false;
};

struct Stage {
  std::string name;  ///< "recipe" or the pass that produced the kernel
  Kernel kernel;
};

/// share, factor, fold, prune, associate, schedule.
const std::vector<Pass>& default_passes();

/// All stages, the recipe first; the last one is the result. Throws std::runtime_error naming the pass, the kernel and
/// the output when a value is wrong, and naming both costs when the cost rises.
std::vector<Stage> run_pipeline(Kernel recipe, const Reference& reference, std::span<const Pass> passes);

}  // namespace sh::codegen
