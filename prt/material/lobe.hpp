// The glossy lobe of a material, a zonal function about the mirrored direction of view: the cosine's power
//   (e+1) / (2 pi) max(0, cos)^e,
// whose integral over the sphere is 1, so that no exponent gains or loses energy [Phong75]; e = 1 about the normal is the
// diffuse surface. A function convolved with it has its band l times phong_factor(l, e).
#pragma once

namespace sh::prt {

/// The largest exponent, of a lobe that degree 10 cannot tell from a mirror.
inline constexpr float kMaxExponent = 1e6F;

/// (e+1) * integral over t in 0..1 of t^e P_l(t), by I_l = I_(l-2) (e-l+2) / (e+l+1) [Hobson31]: a product of ratios, right
/// to a few l epsilon. 1 for l = 0; towards 1 for large e. Precondition: l >= 0, 0 <= e.
double phong_factor(int l, double exponent);

/// The part of the lobe that the bands 0 .. degree hold, in squares, 0..1: a degree that holds little shows a duller
/// surface. It is sum (2l+1)/(4 pi) factor_l^2 over (e+1)^2 / (2 pi (2e+1)).
double phong_share(int degree, double exponent);

}  // namespace sh::prt
