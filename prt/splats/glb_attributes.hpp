// The names and places of the attributes of KHR_gaussian_splatting.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sh::prt {

inline constexpr const char* kSplatExtension = "KHR_gaussian_splatting";

/// What an attribute holds.
enum class GlbPart { kPosition, kRotation, kScale, kOpacity, kHarmonics };

struct GlbAttribute {
  std::string name;
  GlbPart part = GlbPart::kPosition;
  std::size_t components = 0;
  std::size_t coefficient = 0;  // index l(l+1)+m
};

/// All attributes of splats of that degree, in a fixed order.
std::vector<GlbAttribute> glb_attributes(int degree);

/// "SCALAR", "VEC3", "VEC4".
std::string glb_type(std::size_t components);

}  // namespace sh::prt
