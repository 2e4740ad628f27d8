// Conventions in use and their names; see convention.hpp. Each is written as its source documents its functions.
#include "numeric/identify/convention.hpp"

namespace sh::numeric::identify {

const std::vector<Preset>& presets() {
  using enum Normalization;
  // In our world's axes: y up right-handed is x, z, -y; y up left-handed (z forward) is x, z, y; x forward and y left
  // is y, -x, z; x forward and y right (left-handed) is y, x, z.
  constexpr const char* kE3nn = "e3nn o3.spherical_harmonics with this normalization, y polar";
  static const std::vector<Preset> all = {
      {"shforge", {}, parse_axes("x,y,z"), "numeric/README.md"},
      {"directxmath", {.condon_shortley = true}, parse_axes("x,y,z"), "DirectXMath SHMath, XMSHEvalDirection"},
      {"threejs", {}, parse_axes("x,z,-y"), "three.js SphericalHarmonics3.getBasisAt"},
      {"unity", {kPrimitive}, parse_axes("x,z,y"), "Unity SphericalHarmonicsL2, ShadeSH9", Folded::kCosineOverPi},
      {"unreal", {.condon_shortley = true}, parse_axes("y,x,z"), "Unreal Engine SHMath.h, SHBasisFunction"},
      {"filament",
       {kPrimitive},
       parse_axes("x,z,-y"),
       "Filament IndirectLight irradiance, pre-scaled",
       Folded::kCosineOverPi},
      {"gaussian-splatting", {.condon_shortley = true}, parse_axes("x,y,z"), "gaussian-splatting sh_utils.py, eval_sh"},
      {"ambix", {kSn3d}, parse_axes("y,-x,z"), "[Nachbar11] eqs. 2-4"},
      {"ambix-w1", {kSchmidt}, parse_axes("y,-x,z"), "RFC 8486, SN3D with W = 1"},
      {"fuma",
       {kFuMa, false, false, IndexOrder::kFuMa},
       parse_axes("y,-x,z"),
       "[Malham03] table 1, channels W XYZ RSTUV KLMNOPQ"},
      {"e3nn-component", {.normalization = kFourPi, .axes = parse_axes("z,x,y")}, parse_axes("z,x,y"), kE3nn},
      {"e3nn-integral", {.axes = parse_axes("z,x,y")}, parse_axes("z,x,y"), kE3nn},
      {"e3nn-norm", {.normalization = kSchmidt, .axes = parse_axes("z,x,y")}, parse_axes("z,x,y"), kE3nn},
      {"scipy", {.condon_shortley = true, .complex = true}, parse_axes("x,y,z"), "scipy.special.sph_harm_y"},
      {"shtools",
       {kFourPi, false, false, IndexOrder::kCosineSineArray},
       parse_axes("x,y,z"),
       "SHTOOLS real harmonics, norm = 1, csphase = 1"},
  };
  return all;
}

std::string name_of(Normalization normalization) {
  constexpr std::array kNames = {"orthonormal",         "4-pi (N3D)",         "Schmidt (SN3D with Y_00 = 1)",
                                 "SN3D with 1/(4 pi)",  "unnormalized P_l^m", "plain polynomials 1, y, z, x, xy, ...",
                                 "Furse-Malham weights"};
  return kNames[static_cast<int>(normalization)];
}

std::string name_of(IndexOrder order) {
  constexpr std::array kNames = {"ACN order l(l+1)+m", "order 0, 1, -1, 2, -2, ... in each band",
                                 "order 0, 1, ..., l, -1, ..., -l in each band", "array [cosine, sine][l][|m|]",
                                 "FuMa order W XYZ RSTUV KLMNOPQ"};
  return kNames[static_cast<int>(order)];
}

std::string name_of(Folded folded) {
  constexpr std::array kNames = {"nothing folded in", "band l times A_l / pi", "band l times A_l (irradiance)"};
  return kNames[static_cast<int>(folded)];
}

std::string describe(const Convention& c) {
  return std::string(c.complex ? "complex" : "real") + ", " + name_of(c.normalization) + ", " +
         (c.condon_shortley ? "Condon-Shortley phase" : "no Condon-Shortley phase") + ", " + name_of(c.order) +
         (c.folded == Folded::kNothing ? "" : ", " + name_of(c.folded)) + ", axes " + c.axes.to_string();
}

}  // namespace sh::numeric::identify
