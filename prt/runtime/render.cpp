// Rendering of a relit mesh: prt/runtime/render.hpp.
#include "prt/runtime/render.hpp"

#include <oneapi/tbb/parallel_for.h>

#include "numeric/output/progress.hpp"

namespace sh::prt {
namespace {

void shade_row(const Mesh& mesh, const std::vector<Eigen::Vector3f>& vertex_radiance, const RowOfRays& rays,
               const PictureSize& size, int row, const Background& background, Picture& picture) {
  const auto samples = static_cast<std::size_t>(size.samples);
  const auto width = static_cast<std::size_t>(size.width);
  for (std::size_t column = 0; column < width; ++column) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int hits = 0;
    for (std::size_t k = column * samples; k < (column + 1) * samples; ++k) {
      const bool hit = rays.hits[k].face != Hit::kNothing;
      hits += hit ? 1 : 0;
      sum += hit ? interpolated(rays.hits[k], mesh, vertex_radiance) : background(rays.directions[k]);
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
    if (coverage[i] == 1.0F) {
      out.push_back(radiance[i]);
    }
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
  output::Progress progress(what, static_cast<std::size_t>(size.height));
  tbb::parallel_for(0, size.height, [&](int row) {
    RowOfRays rays;
    trace_row(tracer, camera, size, row, rays);
    shade_row(mesh, vertex_radiance, rays, size, row, background, picture);
    progress.advance();
  });
  progress.finish();
  return picture;
}

}  // namespace sh::prt
