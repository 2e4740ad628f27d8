#include "tests/codegen/emitted.hpp"

#include <algorithm>

namespace sh::codegen::test {

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

}  // namespace sh::codegen::test
