#include "prt/medium/medium_volume.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/medium/medium_grid.hpp"
#include "prt/medium/medium_ray.hpp"
#include "prt/rays/directions.hpp"
#include "prt/rays/tracer.hpp"

namespace sh::prt {

namespace {

struct Sample {
  Eigen::Vector3d direction;
  BasisValues basis;
};

std::vector<Sample> samples_of(const VolumeOptions& options, int degree) {
  std::vector<Sample> samples;
  for (const Eigen::Vector3f& direction : make_directions(options.sampler, options.directions, options.seed)) {
    Sample& sample = samples.emplace_back(Sample{direction.cast<double>().normalized(), {}});
    evaluate_basis(degree, sample.direction.x(), sample.direction.y(), sample.direction.z(), sample.basis.data());
  }
  return samples;
}

}  // namespace

Transfer bake_medium_volume(const Scene& scene, const VolumeOptions& options, const BakeObserver& say) {
  if (options.reflects) {
    throw std::invalid_argument(
        fmt::format("{}: light that a medium sends is not kept around it; expected no `--reflected`", scene.name));
  }
  Transfer volume = empty_volume(scene, options, say);
  volume.instruction_set = choose_instruction_set();  // exp() rounds differently on others
  const GridOfMedium medium(scene.medium->extinction);
  const std::vector<Sample> samples = samples_of(options, volume.shape.function_degree());
  const double weight = 4.0 * std::numbers::pi / static_cast<double>(samples.size());
  const std::size_t length = volume.shape.length();
  volume.coefficients.resize(volume.receivers() * length);
  output::Progress progress("transmittance", volume.receivers());
  for_chunks(volume.receivers(), [&](std::size_t chunk) {
    const VertexRange range = chunk_range(chunk, volume.receivers());
    std::vector<double> sums(length);
    for (std::size_t p = range.first; p < range.last; ++p) {
      const Eigen::Vector3d point = volume.grid->point(p);
      std::fill(sums.begin(), sums.end(), 0.0);
      sums[0] = std::sqrt(4.0 * std::numbers::pi);
      for (const Sample& sample : samples) {
        const double taken = 1.0 - transmittance(medium.grid, medium.density, point, sample.direction);
        if (taken > 0.0) as_array(sums.data(), length) -= weight * taken * as_array(sample.basis.data(), length);
      }
      as_array(volume.row(p), length) = as_array(sums.data(), length).cast<float>();
    }
    progress.advance(range.size());
  });
  progress.finish();
  volume.shape.storage.element = options.element;
  return volume;
}

}  // namespace sh::prt
