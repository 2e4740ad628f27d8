// The slow, obvious picture of a scene under an SH light, as a reference for baked pictures: it uses no transfer
// vectors and no vertices. At the center of every pixel it sums the light over the hemisphere of the hit point,
//   exit radiance = emission + albedo / pi * sum over unoccluded directions of L(s) max(0, n.s) * solid angle,
// with L(s) the band-limited light at full precision, n the interpolated shading normal, and occlusion by rays.
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "prt/light/light_coefficients.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/render.hpp"

namespace sh::prt {

/// Directions of equal weight, and the light towards them.
struct SampledDirections {
  std::vector<Eigen::Vector3f> directions;
  std::vector<Eigen::Vector3f> radiance;
};

inline SampledDirections sample_light(const LightCoefficients& light, int count) {
  SampledDirections samples{make_directions(Sampler::kFibonacci, count), {}};
  for (const Eigen::Vector3f& s : samples.directions) {
    samples.radiance.emplace_back(radiance(light, s.cast<double>().normalized()).cast<float>());
  }
  return samples;
}

/// Exit radiance at a hit, from the directions above both horizons that reach the sky, weighted by the cosine.
inline Eigen::Vector3f exit_radiance(const Mesh& mesh, const Hit& hit, const Tracer& tracer,
                                     const SampledDirections& light, float offset) {
  const Eigen::Vector3f normal = interpolated(hit, mesh, mesh.normals).normalized();
  const Eigen::Vector3f geometric_normal = face_normal(mesh.positions, mesh.faces[hit.face]);
  const Eigen::Vector3f origin = interpolated(hit, mesh, mesh.positions) + offset * geometric_normal;
  std::vector<ShadowRay> rays;
  std::vector<Eigen::Vector3f> weighted;
  for (std::size_t k = 0; k < light.directions.size(); ++k) {
    const float cosine = normal.dot(light.directions[k]);
    if (cosine > 0.0F && geometric_normal.dot(light.directions[k]) > 0.0F) {
      rays.emplace_back().aim(origin, light.directions[k]);
      weighted.emplace_back(cosine * light.radiance[k]);
    }
  }
  tracer.occluded(rays);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (!rays[k].blocked()) sum += weighted[k].cast<double>();
  }
  const double factor = 4.0 / static_cast<double>(light.directions.size());  // 4 pi / count, over pi
  const Eigen::Vector3f reflected = interpolated(hit, mesh, mesh.albedo).cwiseProduct((factor * sum).cast<float>());
  return mesh.emission.empty() ? reflected : Eigen::Vector3f(reflected + interpolated(hit, mesh, mesh.emission));
}

/// Every pixel uses the same `directions` Fibonacci points over the whole sphere. Pixels that hit nothing are black and
/// have coverage 0. Throws std::invalid_argument unless `size.samples` is 1 and the mesh has no mirrors, since this
/// function does not follow mirror paths. The same bits for any number of threads.
inline Picture reference_render(const Mesh& mesh, const Tracer& tracer, const LightCoefficients& light,
                                const Camera& camera, const PictureSize& size, int directions) {
  require_picture_size(size);
  if (size.samples != 1) throw std::invalid_argument("reference_render takes one sample a pixel");
  if (!mesh.mirror.empty()) {
    throw std::invalid_argument("reference_render does not follow mirrors; a mesh without is needed");
  }
  const SampledDirections samples = sample_light(light, directions);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : mesh.positions) box.extend(p);
  const float offset = 1e-4F * box.diagonal().norm();  // keeps a shadow ray off the face it starts from
  const auto width = static_cast<std::size_t>(size.width);
  const std::size_t pixels = width * static_cast<std::size_t>(size.height);
  Picture picture{size.width, size.height, std::vector<Eigen::Vector3f>(pixels, Eigen::Vector3f::Zero()),
                  std::vector<float>(pixels, 0.0F)};
  tbb::parallel_for(0, size.height, [&](int row) {
    RowOfRays rays;
    trace_row(tracer, camera, size, row, rays);
    for (std::size_t column = 0; column < width; ++column) {
      if (rays.hits[column].face != Hit::kNothing) {
        const std::size_t pixel = static_cast<std::size_t>(row) * width + column;
        picture.radiance[pixel] = exit_radiance(mesh, rays.hits[column], tracer, samples, offset);
        picture.coverage[pixel] = 1.0F;
      }
    }
  });
  return picture;
}

/// The difference of two pictures of one size over the pixels that the mesh covers completely in both.
struct PictureDifference {
  double relative_rms = 0.0;  // root of mean |a-b|^2 over root of mean |b|^2, all channels
  double largest = 0.0;       // the largest |a-b| of any channel over the root of mean b^2 of a channel
  double far_off = 0.0;       // share of pixels in which |a-b| of a channel exceeds a tenth of that root
  std::size_t pixels = 0;
};
inline PictureDifference difference(const Picture& a, const Picture& b) {
  PictureDifference out;
  std::vector<double> largest;  // (pixels both cover), over the channels
  double squares = 0.0;
  double reference = 0.0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    if (a.coverage[i] == 1.0F && b.coverage[i] == 1.0F) {
      const Eigen::Vector3d delta = (a.radiance[i] - b.radiance[i]).cast<double>();
      squares += delta.squaredNorm();
      reference += b.radiance[i].cast<double>().squaredNorm();
      largest.push_back(delta.cwiseAbs().maxCoeff());
    }
  }
  out.pixels = largest.size();
  if (largest.empty() || !(reference > 0.0)) return out;
  const double typical = std::sqrt(reference / (3.0 * static_cast<double>(out.pixels)));
  out.relative_rms = std::sqrt(squares / reference);
  out.largest = *std::max_element(largest.begin(), largest.end()) / typical;
  const auto far_off = std::count_if(largest.begin(), largest.end(), [&](double d) { return d > 0.1 * typical; });
  out.far_off = static_cast<double>(far_off) / static_cast<double>(out.pixels);
  return out;
}

}  // namespace sh::prt
