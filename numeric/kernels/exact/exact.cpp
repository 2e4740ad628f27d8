// See exact.hpp.
#include "numeric/kernels/exact/exact.hpp"

#include <utility>

namespace sh::numeric {

const std::vector<ExactFamily>& exact_families() {
  static const std::vector<ExactFamily> kAll = [] {
    std::vector<ExactFamily> all;
    for (auto* const group : {exact_basis, exact_evaluate, exact_project, exact_zonal, exact_irradiance, exact_product,
                              exact_rotation, exact_window}) {
      for (ExactFamily& family : group()) all.push_back(std::move(family));
    }
    return all;
  }();
  return kAll;
}

}  // namespace sh::numeric
