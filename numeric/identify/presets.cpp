// Conventions in use and their names; see convention.hpp. Each is written as its source documents its functions.
#include "numeric/identify/convention.hpp"

namespace sh::numeric::identify {
namespace {

Convention make(Normalisation normalisation, bool condon_shortley, IndexOrder order = IndexOrder::kAcn,
                bool complex = false) {
  Convention convention;
  convention.normalisation = normalisation;
  convention.condon_shortley = condon_shortley;
  convention.order = order;
  convention.complex = complex;
  return convention;
}

}  // namespace

const std::vector<Preset>& presets() {
  using enum Normalisation;
  // In our world's axes: y up right-handed is x, z, -y; y up left-handed (z forward) is x, z, y; x forward and y left
  // is y, -x, z; x forward and y right (left-handed) is y, x, z.
  static const std::vector<Preset> all = {
      {"shforge", make(kOrthonormal, false), parse_axes("x,y,z"), Folded::kNothing, "numeric/README.md"},
      {"directxmath", make(kOrthonormal, true), parse_axes("x,y,z"), Folded::kNothing,
       "DirectXMath SHMath, XMSHEvalDirection"},
      {"threejs", make(kOrthonormal, false), parse_axes("x,z,-y"), Folded::kNothing,
       "three.js SphericalHarmonics3.getBasisAt"},
      {"unity", make(kPrimitive, false), parse_axes("x,z,y"), Folded::kCosineOverPi,
       "Unity SphericalHarmonicsL2, ShadeSH9"},
      {"unreal", make(kOrthonormal, true), parse_axes("y,x,z"), Folded::kNothing,
       "Unreal Engine SHMath.h, SHBasisFunction"},
      {"filament", make(kPrimitive, false), parse_axes("x,z,-y"), Folded::kCosineOverPi,
       "Filament IndirectLight irradiance, pre-scaled"},
      {"gaussian-splatting", make(kOrthonormal, true), parse_axes("x,y,z"), Folded::kNothing,
       "gaussian-splatting sh_utils.py, eval_sh"},
      {"ambix", make(kSn3d, false), parse_axes("y,-x,z"), Folded::kNothing, "[Nachbar11] eqs. 2-4"},
      {"scipy", make(kOrthonormal, true, IndexOrder::kAcn, true), parse_axes("x,y,z"), Folded::kNothing,
       "scipy.special.sph_harm_y"},
      {"shtools", make(kFourPi, false, IndexOrder::kCosineSineArray), parse_axes("x,y,z"), Folded::kNothing,
       "SHTOOLS real harmonics, norm = 1, csphase = 1"},
  };
  return all;
}

std::string name_of(Normalisation normalisation) {
  switch (normalisation) {
    case Normalisation::kOrthonormal:
      return "orthonormal";
    case Normalisation::kFourPi:
      return "4-pi (N3D)";
    case Normalisation::kSchmidt:
      return "Schmidt (SN3D with Y_00 = 1)";
    case Normalisation::kSn3d:
      return "SN3D with 1/(4 pi)";
    case Normalisation::kUnnormalised:
      return "unnormalised P_l^m";
    case Normalisation::kPrimitive:
      return "plain polynomials 1, y, z, x, xy, ...";
  }
  return "?";
}

std::string name_of(IndexOrder order) {
  switch (order) {
    case IndexOrder::kAcn:
      return "ACN order l(l+1)+m";
    case IndexOrder::kZeroFirst:
      return "order 0, 1, -1, 2, -2, ... in each band";
    case IndexOrder::kCosineSineBands:
      return "order 0, 1, ..., l, -1, ..., -l in each band";
    case IndexOrder::kCosineSineArray:
      return "array [cosine, sine][l][|m|]";
  }
  return "?";
}

std::string name_of(Folded folded) {
  switch (folded) {
    case Folded::kNothing:
      return "nothing folded in";
    case Folded::kCosineOverPi:
      return "band l times A_l / pi";
    case Folded::kCosine:
      return "band l times A_l (irradiance)";
  }
  return "?";
}

std::string describe(const Convention& c) {
  return std::string(c.complex ? "complex" : "real") + ", " + name_of(c.normalisation) + ", " +
         (c.condon_shortley ? "Condon-Shortley phase" : "no Condon-Shortley phase") + ", " + name_of(c.order) +
         (c.folded == Folded::kNothing ? "" : ", " + name_of(c.folded)) + ", axes " + c.axes.to_string();
}

}  // namespace sh::numeric::identify
