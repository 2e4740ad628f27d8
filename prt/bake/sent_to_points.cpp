#include "prt/bake/sent_to_points.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = 3;

// The buffers of one thread.
struct Worker {
  explicit Worker(const RaySetup& setup) : gatherer(setup.mesh, setup.starts, setup.tracer, setup.directions) {}
  Gatherer gatherer;
  std::vector<Leg> legs;
  std::vector<double> sums;   // (3, rows, columns)
  std::vector<double> light;  // (3, columns): what comes along a leg
};

// The radiance that comes along a leg, by light; false if there is none.
bool light_along(const Leg& leg, const RaySetup& setup, const Transfer& surfaces, std::vector<double>& light) {
  const std::size_t columns = surfaces.shape.count();
  light.assign(kChannels * columns, 0.0);
  if (leg.hit.face == Hit::kNothing) {
    if (leg.mirrors == 0) return false;  // the light itself, which visibility has
    const Eigen::Vector3d s = leg.direction.cast<double>();
    for (std::size_t c = 0; c < kChannels; ++c) {
      evaluate_basis(surfaces.degree(), s.x(), s.y(), s.z(), light.data() + c * columns);
    }
    return true;
  }
  if (leg.hit.from_behind) return false;  // backs are black
  const ReceiversAt place = setup.receivers.at(leg.hit);
  for (std::size_t k = 0; k < place.count; ++k) {
    as_array(light) += static_cast<double>(place.part[k]) *
                       as_array(surfaces.row(place.receiver[k]), kChannels * columns).cast<double>();
  }
  return true;
}

void add_sent(const RaySetup& setup, const Transfer& surfaces, const TransferShape& shape, std::size_t point,
              Worker& worker) {
  const auto rows = static_cast<Eigen::Index>(shape.rows());
  const auto columns = static_cast<Eigen::Index>(shape.columns());
  worker.gatherer.gather(point);
  const std::vector<BlockedRay>& closest = worker.gatherer.closest_hits();
  worker.legs.clear();
  for (std::uint32_t i = 0; i < closest.size(); ++i) {
    worker.legs.push_back({setup.starts[point].origin, closest[i].direction, closest[i].hit, i});
  }
  setup.mirrors.follow(worker.legs);
  for (const Leg& leg : worker.legs) {
    if (!light_along(leg, setup, surfaces, worker.light)) continue;
    const BlockedRay& first = closest[leg.ray];
    const Eigen::Vector3d s = first.direction.cast<double>();
    BasisValues seen;
    evaluate_basis(shape.result_degree, s.x(), s.y(), s.z(), seen.data());
    for (std::size_t c = 0; c < kChannels; ++c) {
      const double part =
          4.0 * std::numbers::pi * first.part * static_cast<double>(leg.throughput[static_cast<Eigen::Index>(c)]);
      using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<Block>(worker.sums.data() + c * shape.count(), rows, columns).noalias() +=
          part * Eigen::Map<const Eigen::VectorXd>(seen.data(), rows) *
          Eigen::Map<const Eigen::RowVectorXd>(worker.light.data() + c * shape.columns(), columns);
    }
  }
}

}  // namespace

std::vector<float> sent_to_points(const RaySetup& setup, const Transfer& surfaces, const TransferShape& shape) {
  const std::size_t points = setup.starts.size();
  std::vector<float> matrices(points * shape.length());
  output::Progress progress("reflect", points);
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(setup); });
  for_chunks(points, [&](std::size_t chunk) {
    Worker& worker = workers.local();
    const VertexRange range = chunk_range(chunk, points);
    for (std::size_t p = range.first; p < range.last; ++p) {
      output::check_interrupt();
      worker.sums.assign(shape.length(), 0.0);
      add_sent(setup, surfaces, shape, p, worker);
      as_array(matrices.data() + p * shape.length(), shape.length()) = as_array(worker.sums).cast<float>();
    }
    progress.advance(range.size());
  });
  progress.finish();
  return matrices;
}

}  // namespace sh::prt
