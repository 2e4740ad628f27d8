#include <algorithm>
#include <utility>

#include "codegen/choose/mask.hpp"
#include "codegen/ir/evaluate.hpp"

namespace sh::codegen {
namespace {

constexpr int kGuardDigits = 10;

// The values of the full kernel at the reference points, with the known entries of the mask filled in.
Reference masked_reference(const Kernel& full, const Reference& reference, const Mask& mask) {
  const cln::float_format_t format = cln::float_format(kCheckDigits + kGuardDigits);
  Evaluator<cln::cl_F> evaluator(full, kCheckDigits + kGuardDigits);
  Reference masked;
  for (const ReferencePoint& point : reference) {
    ReferencePoint known{masked_inputs(point.inputs, mask), {}};
    std::vector<cln::cl_F> inputs;
    for (const cln::cl_RA& input : known.inputs) inputs.push_back(cln::cl_float(input, format));
    const std::vector<cln::cl_F> outputs = evaluator(inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (mask.wanted[full.element(i)]) known.outputs.push_back(outputs[i]);
    }
    masked.push_back(std::move(known));
  }
  return masked;
}

Domain masked_domain(const Domain& domain, const Mask& mask) {
  Domain masked = domain;
  masked.inputs += ", masked";
  masked.test_inputs = [all = domain.test_inputs, mask](int degree) {
    std::vector<std::vector<double>> inputs = all(degree);
    for (std::vector<double>& input : inputs) input = masked_inputs(std::move(input), mask);
    return inputs;
  };
  return masked;
}

FinishedKernel finished(const Family& family, const Recipe& recipe, int degree, const MaskOptions& options) {
  const Mask mask = make_mask(recipe_kernel(family, recipe, degree), options);
  Kernel kernel = masked_stages(family, recipe, degree, options).back().kernel;
  return finish(std::move(kernel), masked_domain(family.domain, mask));
}

}  // namespace

std::vector<Stage> masked_stages(const Family& family, const Recipe& recipe, int degree, const MaskOptions& options) {
  const Reference reference = family.reference(degree, kReferencePoints);
  const Kernel full = run_pipeline(recipe_kernel(family, recipe, degree), reference, {}).back().kernel;
  const Mask mask = make_mask(full, options);
  Kernel masked = apply_mask(full, mask);
  masked.name = family.name + options.suffix() + "_l" + std::to_string(degree);
  masked.arguments += options.arguments();
  return run_pipeline(std::move(masked), masked_reference(full, reference, mask), default_passes());
}

FinishedKernel masked_kernel(const Family& family, int degree, Prefer prefer, const MaskOptions& options) {
  fastest_recipe(family, degree);  // throws for degrees that the family does not have
  std::vector<FinishedKernel> all;
  for (const Recipe& recipe : recipes_for(family, degree)) all.push_back(finished(family, recipe, degree, options));
  const auto least = std::min_element(all.begin(), all.end(), [&](const FinishedKernel& a, const FinishedKernel& b) {
    return prefer == Prefer::kAccuracy ? a.in_float.rounding.eps < b.in_float.rounding.eps
                                       : a.cost.operations() < b.cost.operations();
  });
  if (prefer == Prefer::kAccuracy) least->kernel.arguments += " --prefer accuracy";
  return *least;
}

}  // namespace sh::codegen
