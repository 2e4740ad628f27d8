#include "prt/runtime/render.hpp"

#include <oneapi/tbb/parallel_for.h>

#include "numeric/output/progress.hpp"
#include "prt/rays/mirror_paths.hpp"

namespace sh::prt {
namespace {

// The radiance that each ray of a row sees, also over mirrors.
std::vector<Eigen::Vector3f> seen(const Mesh& mesh, const MirrorPaths& mirrors,
                                  const std::vector<Eigen::Vector3f>& vertex_radiance, const RowOfRays& rays,
                                  const Eigen::Vector3f& eye, const Background& background) {
  std::vector<Leg> legs;
  for (std::uint32_t k = 0; k < rays.hits.size(); ++k) legs.push_back({eye, rays.directions[k], rays.hits[k], k});
  mirrors.follow(legs);
  std::vector<Eigen::Vector3f> radiance(rays.hits.size(), Eigen::Vector3f::Zero());
  for (const Leg& leg : legs) {
    const bool hit = leg.hit.face != Hit::kNothing;
    radiance[leg.ray] +=
        leg.throughput.cwiseProduct(hit ? interpolated(leg.hit, mesh, vertex_radiance) : background(leg.direction));
  }
  return radiance;
}

void shade_row(const std::vector<Eigen::Vector3f>& radiance, const RowOfRays& rays, const PictureSize& size, int row,
               Picture& picture) {
  const auto samples = static_cast<std::size_t>(size.samples);
  const auto width = static_cast<std::size_t>(size.width);
  for (std::size_t column = 0; column < width; ++column) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int hits = 0;
    for (std::size_t k = column * samples; k < (column + 1) * samples; ++k) {
      hits += rays.hits[k].face != Hit::kNothing ? 1 : 0;
      sum += radiance[k];
    }
    const std::size_t pixel = static_cast<std::size_t>(row) * width + column;
    picture.radiance[pixel] = sum / static_cast<float>(size.samples);
    picture.coverage[pixel] = static_cast<float>(hits) / static_cast<float>(size.samples);
  }
}

}  // namespace

std::vector<Eigen::Vector3f> Picture::covered() const {
  std::vector<Eigen::Vector3f> out;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (coverage[i] == 1.0F) out.push_back(radiance[i]);
  }
  return out;
}

Picture render(const Mesh& mesh, const Tracer& tracer, const std::vector<Eigen::Vector3f>& vertex_radiance,
               const Camera& camera, const PictureSize& size, const Background& background, const std::string& what) {
  require_picture_size(size);
  Picture picture{size.width, size.height, {}, {}};
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  picture.radiance.resize(pixels);
  picture.coverage.resize(pixels);
  const MirrorPaths mirrors(mesh, tracer);
  output::Progress progress(what, size.height);
  tbb::parallel_for(0, size.height, [&](int row) {
    RowOfRays rays;
    trace_row(tracer, camera, size, row, rays);
    shade_row(seen(mesh, mirrors, vertex_radiance, rays, camera.position, background), rays, size, row, picture);
    progress.advance();
  });
  progress.finish();
  return picture;
}

}  // namespace sh::prt
