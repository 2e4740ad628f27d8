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

/// The passes: each takes a kernel and returns a kernel that computes the same values.
namespace passes {

/// Computes equal expressions once (value numbering; addition and multiplication commute).
Kernel share(const Kernel& kernel);
/// Does the same, and resolves zeros, ones, signs and operations on constants. Values that a mask sets to zero
/// disappear.
Kernel fold(const Kernel& kernel);
/// Writes polynomials of one or two terms in factored form if that saves operations.
Kernel factor(const Kernel& kernel);
/// Drops nodes that reach no output, and inputs and constants that nothing uses.
Kernel prune(const Kernel& kernel);
/// Writes k (v w) as (k v) w if nothing else uses the product v w.
Kernel associate(const Kernel& kernel);
/// Orders the nodes so that few values are live at once, but first those that divisions and square roots need.
Kernel schedule(const Kernel& kernel);
/// Writes the rows of the loop one after the other, and prunes. A sum over the rows becomes a chain of additions, the first
/// row first. No pass of the pipeline: the analysis of errors and shaders need it.
Kernel unroll(const Kernel& kernel);

}  // namespace passes

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
