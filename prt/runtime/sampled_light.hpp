// The light at a point of a lit scene, sampled from the scene [SloanKautzSnyder02, section 6.2]: six pictures of what the
// point sees, the faces of a cube, projected on SH. A pixel is a patch of constant radiance with its exact solid angle.
// It is the mean of its rays, by solid angle; where rays hit nothing, the distant light's mean over the pixel. Points at
// infinity and small discs (suns) would fall between rays: they count by the share of them that the point sees.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "prt/image/image.hpp"
#include "prt/light/light.hpp"
#include "prt/rays/tracer.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {

/// Pixels along the edge of a face, 1..kMostFacePixels, and rays along the edge of a pixel, 1..kMostPixelRays. The
/// paper takes 16 and 2.
struct CubeSize {
  int face = 16;
  int samples = 2;
};
inline constexpr int kMostFacePixels = 1024;
inline constexpr int kMostPixelRays = 16;

struct SampledLight {
  LightCoefficients light;     // of radiance, as project() gives it for lights
  Image faces;                 // the mapping kCubeStrip; without the lights that count by their share
  double surface_share = 0.0;  // of the sphere, where rays end on surfaces
  double back_share = 0.0;     // of those surfaces, seen from behind
};

/// The light at `point`, in world coordinates, among surfaces that send `surface`, and under `lights` where no surface is
/// in the way. The object that will be lit must not be part of the mesh. The same bits for any number of threads. Throws
/// std::invalid_argument for sizes out of range, and for a point that sees more backs than fronts: it is inside a
/// solid. Throws std::runtime_error for a point inside a sphere light.
SampledLight sampled_light(const Mesh& mesh, const Tracer& tracer, const Surface& surface,
                           const std::vector<Light>& lights, const Eigen::Vector3d& point, const CubeSize& size,
                           int degree);

}  // namespace sh::prt
