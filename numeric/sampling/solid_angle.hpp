// Exact solid angles of the pixels of cube maps and lat-long pictures, in steradian.
//
// Input: where the pixel is. Output: its area on the unit sphere with a relative error of a few epsilon however small
// it is (measured: 3 epsilon). Textbook forms subtract numbers of order 1 and lose as many digits as the pixel is
// small. Compiled for double and Mpfr50.
#pragma once

namespace sh::numeric {

/// A texel of a cube face with size x size texels, center (u, v) in [-1, 1]^2 on the plane z = 1. Equal to
/// A(u+h,v+h) - A(u-h,v+h) - A(u+h,v-h) + A(u-h,v-h), h = 1/size, A(a,b) = atan(ab / sqrt(1+a^2+b^2)) [Driscoll12].
/// Computed as two triangles by [VanOosteromStrackee83] eq. 8, whose triple product is (2h)^2 without cancellation.
template <class Real>
Real texel_solid_angle(const Real& u, const Real& v, int size);

/// The differential form of a texel's solid angle: the area element (1+u^2+v^2)^(-3/2) at its center times its area
/// 4/size^2 on the face [SloanKautzSnyder02] 6.2, [Sloan08] appendix. Its distance from the solid angle is O(1/size^2)
/// of it.
template <class Real>
Real texel_solid_angle_estimate(const Real& u, const Real& v, int size);

/// Every pixel of row 0 .. height-1 of a lat-long picture: (2 pi / width) (cos theta_top - cos theta_bottom). The
/// difference is a product of sines, taken at the nearer pole, so that it keeps its digits beside either.
template <class Real = double>
Real lat_long_solid_angle(int row, int width, int height);

}  // namespace sh::numeric
