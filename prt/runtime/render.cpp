#include "prt/runtime/render.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/chunks.hpp"
#include "prt/image/image.hpp"
#include "prt/rays/mirror_paths.hpp"
#include "prt/rays/receivers_at.hpp"

namespace sh::prt {

namespace {

/// The k-th point of the R2 sequence in the unit square; the 0th is the middle.
/// [Martin Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018]
Eigen::Vector2f pattern(int k) {
  constexpr double kG = 1.32471795724474602596;  // the real root of x^3 = x + 1
  double whole = 0.0;
  return {static_cast<float>(std::modf(0.5 + k / kG, &whole)),
          static_cast<float>(std::modf(0.5 + k / (kG * kG), &whole))};
}

// The radiance that each ray of a row sees, also over mirrors.
std::vector<Eigen::Vector3f> seen(const MirrorPaths& mirrors, const Surface& surface, const RowOfRays& rays,
                                  const Eigen::Vector3f& eye, const Background& background) {
  std::vector<Leg> legs;
  for (std::uint32_t k = 0; k < rays.hits.size(); ++k) legs.push_back({eye, rays.directions[k], rays.hits[k], k});
  mirrors.follow(legs);
  std::vector<Eigen::Vector3f> radiance(rays.hits.size(), Eigen::Vector3f::Zero());
  for (const Leg& leg : legs) {
    const bool hit = leg.hit.face != Hit::kNothing;
    radiance[leg.ray] += leg.throughput.cwiseProduct(hit ? surface(leg.hit, leg.direction) : background(leg.direction));
  }
  return radiance;
}

// The part of what each ray sees that is not the background.
std::vector<float> covered(const RowOfRays& rays) {
  std::vector<float> out;
  for (const Hit& hit : rays.hits) out.push_back(hit.face != Hit::kNothing ? 1.0F : 0.0F);
  return out;
}

// Puts media before what the rays see. unit: of the distances of the hits, in the world's.
void put_before(const Veil& veil, const RowOfRays& rays, double unit, std::vector<Eigen::Vector3f>& radiance,
                std::vector<float>& coverage) {
  for (std::size_t k = 0; k < radiance.size(); ++k) {
    const bool hit = rays.hits[k].face != Hit::kNothing;
    const Marched marched = veil(rays.directions[k], hit ? unit * static_cast<double>(rays.hits[k].distance)
                                                         : std::numeric_limits<double>::infinity());
    radiance[k] = marched.radiance + marched.transmittance * radiance[k];
    coverage[k] = 1.0F - marched.transmittance * (1.0F - coverage[k]);
  }
}

void shade_row(const std::vector<Eigen::Vector3f>& radiance, const std::vector<float>& coverage,
               const PictureSize& size, int row, Picture& picture) {
  const auto samples = static_cast<std::size_t>(size.samples);
  for (int column = 0; column < size.width; ++column) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float covers = 0.0F;
    for (std::size_t k = column * samples; k < (column + 1) * samples; ++k) {
      covers += coverage[k];
      sum += radiance[k];
    }
    const int pixel = row * size.width + column;
    picture.radiance[pixel] = sum / static_cast<float>(size.samples);
    picture.coverage[pixel] = covers / static_cast<float>(size.samples);
  }
}

// Zeros where no surface emits light.
std::vector<Eigen::Vector3f> own_light(std::size_t vertices, const std::vector<Eigen::Vector3f>& emitted) {
  return emitted.empty() ? std::vector<Eigen::Vector3f>(vertices, Eigen::Vector3f::Zero()) : emitted;
}

}  // namespace

void require_picture_size(const PictureSize& size) {
  const auto limit = static_cast<long long>(kMaxPixels);
  if (size.width < 1 || size.height < 1 || static_cast<long long>(size.width) * size.height > limit) {
    throw std::invalid_argument(
        fmt::format("a picture of {} x {} pixels: expected 1 to {} pixels", size.width, size.height, kMaxPixels));
  }
  constexpr int kMaxSamples = 1024;
  if (size.samples < 1 || size.samples > kMaxSamples) {
    throw std::invalid_argument(fmt::format("{} samples a pixel: expected 1 to {}", size.samples, kMaxSamples));
  }
}

CameraFrame::CameraFrame(const Camera& camera, const PictureSize& size)
    : width_(static_cast<float>(size.width)), height_(static_cast<float>(size.height)) {
  const Eigen::Vector3d towards = camera.target - camera.position;
  const Eigen::Vector3d side = towards.cross(camera.up);
  const float angle = camera.vertical_field_of_view;
  if (!(side.norm() > 1e-6 * towards.norm() * camera.up.norm()) || !(angle > 0.0F && angle < 180.0F)) {
    throw std::invalid_argument(
        "the camera must look at a point other than its own, not along its up, with a vertical "
        "field of view above 0 and below 180 degrees");
  }
  const float half_height = std::tan(0.5F * angle * std::numbers::pi_v<float> / 180.0F);
  forward_ = towards.normalized().cast<float>();
  const Eigen::Vector3f right = side.normalized().cast<float>();
  right_ = right * half_height * width_ / height_;
  down_ = forward_.cross(right) * half_height;
}

Eigen::Vector3f CameraFrame::direction(float column, float row) const {
  return (forward_ + (2.0F * column / width_ - 1.0F) * right_ + (2.0F * row / height_ - 1.0F) * down_).normalized();
}

std::vector<Eigen::Vector3f> CameraFrame::directions(int row, const PictureSize& size) const {
  std::vector<Eigen::Vector3f> directions;
  for (int column = 0; column < size.width; ++column) {
    for (int k = 0; k < size.samples; ++k) {
      const Eigen::Vector2f offset = pattern(k);
      directions.push_back(direction(static_cast<float>(column) + offset.x(), static_cast<float>(row) + offset.y()));
    }
  }
  return directions;
}

void trace_row(const Tracer& tracer, const Camera& camera, const PictureSize& size, int row, RowOfRays& rays) {
  rays.directions = CameraFrame(camera, size).directions(row, size);
  const std::vector<Eigen::Vector3f> origins(rays.directions.size(), tracer.start(camera.position));
  rays.hits.resize(rays.directions.size());
  tracer.intersect(origins, rays.directions, rays.hits);
}

std::vector<Eigen::Vector3f> Picture::covered(float least) const {
  std::vector<Eigen::Vector3f> out;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (coverage[i] >= least) out.push_back(radiance[i]);
  }
  return out;
}

Surface diffuse_surface(const Mesh& mesh, std::vector<Eigen::Vector3f> radiance) {
  return [&mesh, receivers = SurfaceReceivers(mesh), radiance = std::move(radiance)](
             const Hit& hit, const Eigen::Vector3f& /*direction*/) { return receivers.at(hit).mean(radiance); };
}

Surface diffuse_surface(const Mesh& mesh, std::vector<Eigen::Vector3f> radiance,
                        const std::vector<Eigen::Vector3f>& emitted, SurfaceColors colors) {
  if (mesh.albedo_map.empty()) return diffuse_surface(mesh, std::move(radiance));
  const std::vector<Eigen::Vector3f> own = own_light(mesh.positions.size(), emitted);
  const std::vector<Eigen::Vector3f> reaching = without_albedo(radiance, emitted, colors.of_vertices());
  return [&mesh, receivers = SurfaceReceivers(mesh), colors = std::move(colors), own, reaching,
          radiance = std::move(radiance)](const Hit& hit, const Eigen::Vector3f& /*direction*/) {
    const ReceiversAt at = receivers.at(hit);
    if (!colors.has_picture(mesh.faces[hit.face][0])) return at.mean(radiance);
    return Eigen::Vector3f(at.mean(reaching).cwiseProduct(colors.at(hit)) + at.mean(own));
  };
}

Picture render(const Mesh& mesh, const Tracer& tracer, const Surface& surface, const Camera& camera,
               const PictureSize& size, const Background& background, const std::string& what, const Veil& veil) {
  require_picture_size(size);
  const int pixels = size.width * size.height;
  Picture picture{size.width, size.height, std::vector<Eigen::Vector3f>(pixels), std::vector<float>(pixels)};
  const MirrorPaths mirrors(mesh, tracer);
  output::Progress progress(what, size.height);
  in_parallel(0, size.height, [&](int row) {
    RowOfRays rays;
    trace_row(tracer, camera, size, row, rays);
    std::vector<Eigen::Vector3f> radiance = seen(mirrors, surface, rays, tracer.start(camera.position), background);
    std::vector<float> coverage = covered(rays);
    if (veil) put_before(veil, rays, mesh.frame.unit, radiance, coverage);
    shade_row(radiance, coverage, size, row, picture);
    progress.advance();
  });
  progress.finish();
  return picture;
}

}  // namespace sh::prt
