#include "tests/codegen/emitted.hpp"

#include <algorithm>

namespace sh::codegen::test {
namespace {

bool has(const std::vector<Parameter>& arrays, const std::string& name) {
  return std::any_of(arrays.begin(), arrays.end(), [&](const Parameter& array) { return array.name == name; });
}

}  // namespace

std::vector<int> some_degrees(const Family& family) {
  std::vector<int> written;
  for (int degree = 0; degree <= family.largest_written; ++degree) {
    if (!recipes_for(family, degree).empty()) written.push_back(degree);
  }
  std::vector<int> chosen{written.front(), written[written.size() / 2], written.back()};
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

const std::vector<FinishedKernel>& emitted_kernels() {
  static const std::vector<FinishedKernel> kKernels = [] {
    std::vector<FinishedKernel> kernels;
    for (const Family& family : families()) {
      for (const int degree : some_degrees(family)) kernels.push_back(preferred_kernel(family, degree, Prefer::kSpeed));
    }
    return kernels;
  }();
  return kKernels;
}

numeric::Signature signature_of(const Kernel& kernel) {
  numeric::Signature signature;
  signature.returns_value = kernel.returns_scalar();
  for (const Parameter& parameter : kernel.parameters) {
    const bool updated = has(kernel.results, parameter.name);
    signature.parameters.push_back({parameter.name, parameter.shape.empty() ? 0 : parameter.size(),
                                    updated ? numeric::Access::kInOut : numeric::Access::kIn});
  }
  if (signature.returns_value) return signature;
  for (const Parameter& result : kernel.results) {
    if (!has(kernel.parameters, result.name))
      signature.parameters.push_back({result.name, result.size(), numeric::Access::kOut});
  }
  return signature;
}

}  // namespace sh::codegen::test
