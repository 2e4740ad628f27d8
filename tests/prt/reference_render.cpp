#include "tests/prt/reference_render.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "prt/rays/directions.hpp"

namespace sh::prt {
namespace {

/// Directions of equal weight, and the light towards them.
struct LightSamples {
  std::vector<Eigen::Vector3f> directions;
  std::vector<Eigen::Vector3f> radiance;
};

LightSamples sample_light(const LightCoefficients& light, int count) {
  LightSamples samples{fibonacci_directions(count), {}};
  for (const Eigen::Vector3f& s : samples.directions) {
    samples.radiance.emplace_back(radiance(light, s.cast<double>().normalized()).cast<float>());
  }
  return samples;
}

struct SurfacePoint {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;            // shading, unit
  Eigen::Vector3f geometric_normal;  // of the face, unit
  Eigen::Vector3f albedo;
  Eigen::Vector3f emission;
};

SurfacePoint surface_point(const Mesh& mesh, const Hit& hit) {
  const Face& face = mesh.faces[hit.face];
  const Eigen::Vector3f& a = mesh.positions[face[0]];
  const Eigen::Vector3f across = (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a);
  return {interpolated(hit, mesh, mesh.positions), interpolated(hit, mesh, mesh.normals).normalized(),
          across.normalized(), interpolated(hit, mesh, mesh.albedo),
          mesh.emission.empty() ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : interpolated(hit, mesh, mesh.emission)};
}

/// The directions above both horizons that reach the sky, weighted by the cosine.
Eigen::Vector3f exit_radiance(const SurfacePoint& point, const Tracer& tracer, const LightSamples& samples,
                              float offset) {
  std::vector<ShadowRay> rays;
  std::vector<Eigen::Vector3f> weighted;
  const Eigen::Vector3f origin = point.position + offset * point.geometric_normal;
  for (std::size_t k = 0; k < samples.directions.size(); ++k) {
    const float cosine = point.normal.dot(samples.directions[k]);
    if (cosine > 0.0F && point.geometric_normal.dot(samples.directions[k]) > 0.0F) {
      rays.emplace_back().aim(origin, samples.directions[k]);
      weighted.emplace_back(cosine * samples.radiance[k]);
    }
  }
  tracer.occluded(rays);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (!rays[k].blocked()) sum += weighted[k].cast<double>();
  }
  const double factor = 4.0 / static_cast<double>(samples.directions.size());  // 4 pi / count, over pi
  return point.emission + point.albedo.cwiseProduct((factor * sum).cast<float>());
}

/// 1e-4 of the mesh's extent keeps a shadow ray off the face it starts from.
float ray_offset(const Mesh& mesh) {
  Eigen::Vector3f low = mesh.positions.front();
  Eigen::Vector3f high = low;
  for (const Eigen::Vector3f& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 1e-4F * (high - low).norm();
}

}  // namespace

Picture reference_render(const Mesh& mesh, const Tracer& tracer, const LightCoefficients& light, const Camera& camera,
                         const PictureSize& size, int directions) {
  require_picture_size(size);
  if (size.samples != 1) throw std::invalid_argument("reference_render takes one sample a pixel");
  if (!mesh.mirror.empty()) {
    throw std::invalid_argument("reference_render does not follow mirrors; a mesh without is needed");
  }
  const LightSamples samples = sample_light(light, directions);
  const float offset = ray_offset(mesh);
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
        picture.radiance[pixel] = exit_radiance(surface_point(mesh, rays.hits[column]), tracer, samples, offset);
        picture.coverage[pixel] = 1.0F;
      }
    }
  });
  return picture;
}

PictureDifference difference(const Picture& a, const Picture& b) {
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
