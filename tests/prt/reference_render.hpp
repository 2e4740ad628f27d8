// The slow, obvious picture of a scene under an SH light, as a reference for baked pictures: it uses no transfer
// vectors and no vertices. At the center of every pixel it sums the light over the hemisphere of the hit point,
//   exit radiance = emission + albedo / pi * sum over unoccluded directions of L(s) max(0, n.s) * solid angle,
// with L(s) the band-limited light at full precision, n the interpolated shading normal, and occlusion by rays.
#pragma once
#include <cstdint>

#include "prt/light/light_coefficients.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {

/// Every pixel uses the same `directions` Fibonacci points over the whole sphere. Pixels that hit nothing are black and
/// have coverage 0. Throws std::invalid_argument unless `size.samples` is 1 and the mesh has no mirrors, since this
/// function does not follow mirror paths. The same bits for any number of threads.
Picture reference_render(const Mesh& mesh, const Tracer& tracer, const LightCoefficients& light, const Camera& camera,
                         const PictureSize& size, int directions);

/// The difference of two pictures of one size over the pixels that the mesh covers completely in both.
struct PictureDifference {
  double relative_rms = 0.0;  // root of mean |a-b|^2 over root of mean |b|^2, all channels
  double largest = 0.0;       // the largest |a-b| of any channel over the root of mean b^2 of a channel
  double far_off = 0.0;       // share of pixels in which |a-b| of a channel exceeds a tenth of that root
  std::size_t pixels = 0;
};
PictureDifference difference(const Picture& a, const Picture& b);

}  // namespace sh::prt
