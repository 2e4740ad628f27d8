#include "codegen/families/families.hpp"

namespace sh::codegen {

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies{
#define FAMILY(name) name##_family(),
#include "codegen/families/families.def"
#undef FAMILY
  };
  return kFamilies;
}

}  // namespace sh::codegen
