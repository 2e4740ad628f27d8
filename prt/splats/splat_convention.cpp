#include "prt/splats/splat_convention.hpp"

#include <stdexcept>

#include "numeric/identify/coefficient_map.hpp"
#include "prt/splats/splats.hpp"

namespace sh::prt {
namespace {

const numeric::identify::Preset& preset() { return numeric::identify::find_preset("gaussian-splatting"); }

}  // namespace

std::vector<float> splat_signs(int degree) {
  const numeric::identify::CoefficientMap map(preset().convention, degree);
  const std::vector<float> ones(splat_bands_squared(degree), 1.0F);
  std::vector<float> signs(ones.size());
  if (!map.is_diagonal() || static_cast<std::size_t>(map.their_size()) != ones.size()) {
    throw std::logic_error("the convention of Gaussian splats is expected to differ by signs alone");
  }
  map.to(ones.data(), signs.data());
  return signs;
}

std::string splat_convention() { return describe(preset().convention); }

}  // namespace sh::prt
