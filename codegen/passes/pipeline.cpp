#include <stdexcept>

#include "codegen/ir/cost.hpp"
#include "codegen/ir/evaluate.hpp"
#include "codegen/passes/passes.hpp"

namespace sh::codegen {
namespace {

constexpr int kAgreeDigits = 90;

void require_values(const Stage& stage, const Reference& reference) {
  const cln::float_format_t format = cln::float_format(kCheckDigits);
  const cln::cl_RA tolerance = cln::expt(cln::cl_RA(10), -kAgreeDigits);
  Evaluator<cln::cl_F> evaluator(stage.kernel, kCheckDigits);
  for (const ReferencePoint& point : reference) {
    std::vector<cln::cl_F> inputs;
    for (const cln::cl_RA& input : point.inputs) inputs.push_back(cln::cl_float(input, format));
    const std::vector<cln::cl_F> outputs = evaluator(inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (cln::abs(cln::rational(outputs[i] - point.outputs.at(i))) > tolerance) {
        throw std::runtime_error("pass " + stage.name + ": " + stage.kernel.name + " output " + std::to_string(i) +
                                 " (" + stage.kernel.outputs[i].label +
                                 ") differs from the exact function: expected agreement to " +
                                 std::to_string(kAgreeDigits) + " digits");
      }
    }
  }
}

void require_cost(const Stage& before, const Stage& after) {
  const int was = cost(before.kernel).operations();
  const int is = cost(after.kernel).operations();
  if (is > was) {
    throw std::runtime_error("pass " + after.name + ": " + after.kernel.name + ": expected at most " +
                             std::to_string(was) + " operations, as before the pass, got " + std::to_string(is));
  }
}

}  // namespace

const std::vector<Pass>& default_passes() {
  static const std::vector<Pass> kPasses{{"share", passes::share},         {"factor", passes::factor},
                                         {"fold", passes::fold},           {"prune", passes::prune},
                                         {"associate", passes::associate}, {"schedule", passes::schedule}};
  return kPasses;
}

std::vector<Stage> run_pipeline(Kernel recipe, const Reference& reference, std::span<const Pass> passes) {
  std::vector<Stage> stages{{"recipe", std::move(recipe)}};
  require_well_formed(stages.back().kernel);
  require_values(stages.back(), reference);
  for (const Pass& pass : passes) {
    Stage next{pass.name, pass.run(stages.back().kernel)};
    require_well_formed(next.kernel);
    require_values(next, reference);
    if (!pass.may_raise_cost) require_cost(stages.back(), next);
    stages.push_back(std::move(next));
  }
  return stages;
}

}  // namespace sh::codegen
