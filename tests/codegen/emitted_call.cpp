#include "tests/codegen/emitted_call.hpp"

#include <limits>
#include <map>
#include <tuple>

#include "tests/codegen/printed_code.hpp"

namespace sh::codegen::test {
namespace {

constexpr double kUnwritten = std::numeric_limits<double>::quiet_NaN();

// Our own kernel without a convention.
const FinishedKernel& own_kernel(const std::string& family, int degree) {
  static std::map<std::pair<std::string, int>, FinishedKernel> kernels;
  const auto key = std::pair(family, degree);
  const auto found = kernels.find(key);
  if (found != kernels.end()) return found->second;
  return kernels.emplace(key, preferred_kernel(find_family(family), degree, Prefer::kSpeed)).first->second;
}

// Options that have no effect in a family are refused, so they are left out.
ConventionOptions options_for(const std::string& family, const World& world) {
  ConventionOptions options{world.definition.preset, world.axes};
  if (is_shared(family, world.definition)) options.convention.clear();
  if (has_no_axes(family) || world.axes == "x,y,z") options.axes.clear();
  return options;
}

}  // namespace

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const Language& language : languages()) {
    all.push_back({language.name, print::Scalar::kFloat});
    if (language.name != "glsl-es") all.push_back({language.name, print::Scalar::kDouble});
  }
  return all;
}

std::string name_of(const Target& target) { return target.language + " " + print::scalar_name(target.scalar); }

const FinishedKernel& emitted_kernel(const std::string& family, int degree, const ConventionOptions& options) {
  static std::map<std::tuple<std::string, int, std::string>, FinishedKernel> kernels;
  const auto key = std::tuple(family, degree, options.arguments());
  const auto found = kernels.find(key);
  if (found != kernels.end()) return found->second;
  FinishedKernel finished = own_kernel(family, degree);
  if (!options.empty()) {
    finished.kernel = converted_kernel(finished, find_family(family).reference(degree, kReferencePoints), options);
    finished.cost = cost(finished.kernel);
  }
  return kernels.emplace(key, std::move(finished)).first->second;
}

Call emitted_call(const World& world, const Target& target, const Mutation& mutation) {
  return [=](const std::string& family, Arrays arrays) {
    ConventionOptions options = options_for(family, world);
    if (mutation.options) options = mutation.options(options);
    FinishedKernel finished = emitted_kernel(family, world.degree, options);
    if (mutation.kernel) finished.kernel = mutation.kernel(finished.kernel);
    std::string text = find_language(target.language).print_kernel(finished, target.scalar);
    if (mutation.text) text = mutation.text(text);

    const Kernel& kernel = finished.kernel;
    const bool renamed = target.language == "c99" && target.scalar == print::Scalar::kDouble;
    Arguments arguments;
    const numeric::Signature signature = printed_signature(kernel);
    for (const numeric::Parameter& parameter : signature.parameters) {
      const auto size = static_cast<std::size_t>(std::max(parameter.count, 1));
      const auto given = arrays.find(parameter.name);
      const bool fits = given != arrays.end() && given->second.size() == size;
      if (!fits && parameter.access != numeric::Access::kOut)
        throw std::invalid_argument(family + ": expected " + std::to_string(size) + " numbers for " + parameter.name);
      arguments.push_back(parameter.access == numeric::Access::kOut ? std::vector<double>(size, kUnwritten)
                                                                    : given->second);
    }
    const std::optional<double> value =
        run_printed(target.language, target.scalar, text, kernel.name + (renamed ? "_double" : ""), arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) arrays[signature.parameters[i].name] = arguments[i];
    if (value) arrays[kernel.results[0].name] = {*value};
    return arrays;
  };
}

double tolerance(print::Scalar scalar) { return scalar == print::Scalar::kFloat ? 1e-5 : 1e-13; }

}  // namespace sh::codegen::test
