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

/// Throws std::invalid_argument for sizes out of range.
void require_size(const CubeSize& size);

struct SampledLight {
  LightCoefficients light;     // of radiance, as project() gives it for lights
  double surface_share = 0.0;  // of the sphere, where rays end on surfaces
  double back_share = 0.0;     // of those surfaces, seen from behind
  /// Whether the point sees more backs than fronts.
  [[nodiscard]] bool is_inside() const { return back_share > 0.5; }
};

class LightSampler {
 public:
  /// Surfaces that send `surface`, and `lights` where no surface is in the way. An object that will be lit must not be
  /// part of the mesh. Mesh and tracer must outlive this object. Throws std::invalid_argument for sizes out of range.
  LightSampler(const Mesh& mesh, const Tracer& tracer, Surface surface, const std::vector<Light>& lights,
               const CubeSize& size);

  /// The light at a point of the world. The same bits for any number of threads. Throws std::runtime_error for a point
  /// inside a sphere light, or too far away for rays.
  [[nodiscard]] SampledLight at(const Eigen::Vector3d& point, int degree) const;

 private:
  friend class CubeView;  // what one point sees
  const Mesh& mesh_;
  const Tracer& tracer_;
  Surface surface_;
  CubeSize size_;
  std::vector<Light> far_;                // in the pictures, the same at every point
  std::vector<Light> small_;              // the same
  std::vector<Light> near_;               // seen_from() a point
  std::vector<Eigen::Vector3d> distant_;  // (size, 6 size): the mean of `far_` over the pixels
};

}  // namespace sh::prt
