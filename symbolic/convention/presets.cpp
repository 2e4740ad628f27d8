#include "symbolic/convention/convention.hpp"
#include "symbolic/number/find_named.hpp"

namespace sh::symbolic {
namespace {

std::vector<Preset> make_presets() {
  const Convention with_phase{.condon_shortley = true};
  // The polynomials 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2; the coefficients hold all factors.
  const Convention polynomials{.normalization = Normalization::kPrimitive, .folded = Folded::kCosineOverPi};
  const SignedPermutation same;
  const SignedPermutation polar_y("z,x,y");
  const char* const e3nn =
      "e3nn e3nn/o3/_spherical_harmonics.py, spherical_harmonics(l, x, normalize=True, normalization)";
  const SignedPermutation y_up("x,z,-y");             // x right, y up, z towards the viewer
  const SignedPermutation y_up_left_handed("x,z,y");  // x right, y up, z forward
  return {
      {"shforge", {}, same, "symbolic/basis/basis.hpp", "this project: real, orthonormal, no phase, z polar"},
      {"directxmath", with_phase, same,
       "microsoft/DirectXMath SHMath/DirectXSH.cpp, XMSHEvalDirection (sh_eval_basis_1 .. 5)",
       "radiance coefficients, orders 2 to 6 (bands); the library fixes no axes, z is polar"},
      {"threejs",
       {},
       y_up,
       "mrdoob/three.js src/math/SphericalHarmonics3.js, getBasisAt and getAt",
       "radiance coefficients of LightProbe, 3 bands; getIrradianceAt multiplies by A_l itself"},
      {"unity", polynomials, y_up_left_handed,
       "Unity ScriptReference SphericalHarmonicsL2; Unity-Technologies/Graphics SphericalHarmonics.cs "
       "(kNormalizationConstants) and UnityCG.cginc, ShadeSH9",
       "SphericalHarmonicsL2 [channel, 0..8]: basis constants, phase and A_l/pi are folded into the numbers, so that "
       "their sum with 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2 is irradiance / pi"},
      {"unreal", with_phase, SignedPermutation("y,x,z"),
       "Unreal Engine Engine/Source/Runtime/Core/Public/Math/SHMath.h, TSHVector::SHBasisFunction; "
       "Engine/Shaders/Private/SHCommon.ush, SHBasisFunction3",
       "radiance coefficients, 2 or 3 bands; CalcDiffuseTransfer applies A_l at evaluation; left-handed, x forward, z "
       "up"},
      {"filament", polynomials, y_up,
       "google/filament libs/ibl/src/CubemapSH.cpp, computeIrradianceSH3Bands and renderPreScaledSH3Bands; "
       "IndirectLight::Builder::irradiance",
       "the nine pre-scaled numbers that the shader sums with 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2 to irradiance / "
       "pi; computeSH of the same file, before scaling, is orthonormal with the Condon-Shortley phase: preset "
       "directxmath"},
      {"gaussian-splatting", with_phase, same,
       "graphdeco-inria/gaussian-splatting utils/sh_utils.py, eval_sh; diff-gaussian-rasterization forward.cu, "
       "computeColorFromSH",
       "color coefficients f_dc, f_rest, 4 bands, of the direction from camera to splat; the color is the sum plus "
       "1/2; axes are those of the scene"},
      {"ambix",
       {.normalization = Normalization::kSn3d},
       SignedPermutation("y,-x,z"),
       "Nachbar, Zotter, Deleflie, Sontacchi, AmbiX: a suggested ambisonics format (2011), eqs. 2-4; RFC 8486",
       "ACN order, SN3D with 1/(4 pi) under the root as printed; streams whose W channel equals the signal leave that "
       "constant out: preset ambix-w1; x front, y left, z up"},
      {"ambix-w1",
       {.normalization = Normalization::kSchmidt},
       SignedPermutation("y,-x,z"),
       "RFC 8486 (Ogg Opus, channel mapping families 2 and 3); YouTube and IEM Plug-in Suite, SN3D",
       "ACN order, SN3D with W = 1: a plane wave from a direction has the channels Y'(direction); x front, y left, z "
       "up"},
      {"fuma",
       {.normalization = Normalization::kFuMa, .order = IndexOrder::kFuMa},
       SignedPermutation("y,-x,z"),
       "Malham, Higher order ambisonic systems (2003), table 1; classic B-format (.amb)",
       "channels W XYZ RSTUV KLMNOPQ to degree 3, weighted to a largest value of 1, W = 1/sqrt 2; x front, y left, z "
       "up"},
      {"e3nn-component",
       {.normalization = Normalization::kFourPi, .axes = polar_y},
       polar_y,
       e3nn,
       "normalization='component': the squares of a band sum to 2l+1; y is polar, so that band 1 is sqrt 3 (x, y, z)"},
      {"e3nn-integral",
       {.axes = polar_y},
       polar_y,
       e3nn,
       "normalization='integral': orthonormal; y is polar, so that band 1 is proportional to (x, y, z)"},
      {"e3nn-norm",
       {.normalization = Normalization::kSchmidt, .axes = polar_y},
       polar_y,
       e3nn,
       "normalization='norm': the squares of a band sum to 1; y is polar, so that band 1 is (x, y, z)"},
      {"scipy",
       {.condon_shortley = true, .complex = true},
       same,
       "SciPy reference, scipy.special.sph_harm_y (formerly sph_harm)",
       "complex, orthonormal, phase included in P_l^m; theta is polar in sph_harm_y, azimuthal in the old sph_harm"},
      {"shtools",
       {.normalization = Normalization::kFourPi, .order = IndexOrder::kCosineSineArray},
       same,
       "SHTOOLS documentation, real spherical harmonics; defaults of SHExpandDH (norm = 1, csphase = 1)",
       "array cilm (2, L+1, L+1): [0] cosine, [1] sine, 4-pi normalized, no Condon-Shortley phase; y axis at longitude "
       "90"},
  };
}

}  // namespace

Convention Preset::in_world() const {
  Convention result = convention;
  result.axes = world;
  return result;
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = make_presets();
  return all;
}

const Preset& find_preset(std::string_view name) { return find_named(presets(), name, "convention"); }

}  // namespace sh::symbolic
