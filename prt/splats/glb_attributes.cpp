#include "prt/splats/glb_attributes.hpp"

#include <fmt/format.h>

namespace sh::prt {

std::vector<GlbAttribute> glb_attributes(int degree) {
  const std::string prefix = std::string(kSplatExtension) + ":";
  std::vector<GlbAttribute> all = {{"POSITION", GlbPart::kPosition, 3},
                                   {prefix + "ROTATION", GlbPart::kRotation, 4},
                                   {prefix + "SCALE", GlbPart::kScale, 3},
                                   {prefix + "OPACITY", GlbPart::kOpacity, 1}};
  for (int l = 0; l <= degree; ++l) {
    for (int n = 0; n <= 2 * l; ++n) {  // n = m + l
      all.push_back({fmt::format("{}SH_DEGREE_{}_COEF_{}", prefix, l, n), GlbPart::kHarmonics, 3,
                     static_cast<std::size_t>(l * l + n)});
    }
  }
  return all;
}

std::string glb_type(std::size_t components) { return components == 1 ? "SCALAR" : fmt::format("VEC{}", components); }

}  // namespace sh::prt
