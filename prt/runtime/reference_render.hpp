// The slow, obvious picture of a scene under an SH light, to compare baked ones with: no transfer vectors, no vertices.
// At every pixel's centre the hit point's incident light is summed over its own hemisphere of directions,
//   exit radiance = emission + albedo / pi * sum over unoccluded directions of L(s) max(0, n.s) * solid angle,
// with L(s) the band-limited light at full precision, n the interpolated shading normal, and occlusion by rays.
#pragma once
#include <cstdint>

#include "prt/light/light_coefficients.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {

/// `directions` (over the whole sphere) are the same Fibonacci points for every pixel. Pixels that hit nothing are
/// black and have coverage 0. `size.samples` must be 1 and the mesh without mirrors, which it does not follow, else it
/// throws std::invalid_argument. The same bits for any number of threads.
Picture reference_render(const Mesh& mesh, const Tracer& tracer, const LightCoefficients& light, const Camera& camera,
                         const PictureSize& size, int directions);

/// How two pictures of one size differ over the pixels both cover completely.
struct PictureDifference {
  double relative_rms = 0.0;  // root of mean |a-b|^2 over root of mean |b|^2, all channels
  double largest = 0.0;       // the largest |a-b| of any channel over the root of mean b^2 of a channel
  double far_off = 0.0;       // the part of the pixels in which |a-b| of some channel is over a tenth of the latter
  std::size_t pixels = 0;
};
PictureDifference difference(const Picture& a, const Picture& b);

}  // namespace sh::prt
