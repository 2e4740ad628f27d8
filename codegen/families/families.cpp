#include "codegen/families/family.hpp"

namespace sh::codegen {

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies = [] {
    std::vector<Family> all;
    for (const auto& group :
         {basis_families(), evaluate_families(), project_families(), zonal_families(), irradiance_families(),
          window_families(), rotation_families(), product_families(), transfer_families(), relight_families()}) {
      all.insert(all.end(), group.begin(), group.end());
    }
    return all;
  }();
  return kFamilies;
}

}  // namespace sh::codegen
