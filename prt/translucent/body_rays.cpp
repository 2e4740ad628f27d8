#include "prt/translucent/body_rays.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/chunks.hpp"
#include "prt/mesh/corners.hpp"
#include "prt/rays/gather.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr int kMostSurfaces = 256;      // on the way of a ray; what has more counts as blocked
constexpr int kMostTries = 3;           // of a ray that found no exit: it may have met an edge between faces
constexpr float kRoundings = 32.0F;     // of the coordinates, to the other side of a surface that was met
constexpr double kNoticedShare = 1e-3;  // of rays that leave no body

// A ray on its way.
struct Way {
  std::uint32_t direction;                              // its number
  int tries = 0;                                        // from the beginning, before this one
  int surfaces = 0;                                     // that it has met
  Eigen::Vector3f origin;                               // of the piece that comes next
  int depth = 1;                                        // surfaces that it has entered and not left
  std::uint16_t material = 0;                           // 1 + number of that of the piece
  double inside = 0.0;                                  // distance, in the frame
  Eigen::Array3d attenuation = Eigen::Array3d::Zero();  // optical depth by color
};

enum class End { kGoesOn, kFree, kBlocked, kNoExit };

using Followed = std::function<void(const Way&, End)>;

// The shape of sums over directions with the cosine.
TransferShape sums_of(int degree) { return {.degree = degree}; }

// The rays of one vertex after another, with the buffers of one thread. The way ends at the exit from the first body if
// `to_exit`, else where nothing is left or something opaque stands.
class Follower {
 public:
  Follower(const Mesh& mesh, const Tracer& tracer, const SharedDirections& directions, bool to_exit)
      : mesh_(mesh), tracer_(tracer), directions_(directions), to_exit_(to_exit), heights_(directions.size()) {}

  // Calls each(way, end) once for each direction of the inner hemisphere.
  void follow(std::size_t vertex, const RayStart& start, const Followed& each) {
    directions_.cosines_with(mesh_.geometric_normals[vertex], heights_.data());
    const Eigen::Vector3f& up = mesh_.geometric_normals[vertex];
    const Eigen::Vector3f off = start.origin - mesh_.positions[vertex];
    depth_ = off.dot(up);
    reach_ = start.reach;
    material_ = mesh_.translucence.empty() ? std::uint16_t{0} : mesh_.translucence[vertex];
    const Eigen::Vector3f inside = mesh_.positions[vertex] + off - 2.0F * depth_ * up;
    const Eigen::Vector3f aside = 0.25F * depth_ * up.unitOrthogonal();
    starts_ = {inside, inside + aside, inside + up.cross(aside), inside - aside};
    ways_.clear();
    for (std::uint32_t j = 0; j < directions_.size(); ++j) {
      if (heights_[j] < 0.0F) ways_.push_back(begin(j, 0));
    }
    while (!ways_.empty()) {
      trace();
      std::size_t left = 0;
      for (std::size_t i = 0; i < ways_.size(); ++i) {
        Way& way = ways_[i];
        End end = advance(hits_[i], way);
        if (end == End::kNoExit && way.tries < kMostTries) {
          way = begin(way.direction, way.tries + 1);
          end = End::kGoesOn;
        }
        if (end == End::kGoesOn) {
          ways_[left++] = way;
        } else {
          each(way, end);
        }
      }
      ways_.resize(left);
    }
  }

 private:
  // The beginning of a way. It starts a little below the surface; the piece above counts, too.
  [[nodiscard]] Way begin(std::uint32_t direction, int tries) const {
    Way way{.direction = direction, .tries = tries, .origin = starts_[static_cast<std::size_t>(tries)]};
    way.material = material_;
    pass(std::min(depth_ / -heights_[direction], reach_), way);
    return way;
  }

  void trace() {
    origins_.clear();
    along_.clear();
    for (const Way& way : ways_) {
      origins_.push_back(way.origin);
      along_.push_back(directions_.direction(way.direction));
    }
    hits_.resize(ways_.size());
    tracer_.intersect(origins_, along_, hits_);
  }

  // Takes a piece inside.
  void pass(float length, Way& way) const {
    way.inside += static_cast<double>(length);
    if (way.material == 0) return;
    const Translucence& material = mesh_.translucences.at(way.material - 1U);
    way.attenuation += (mesh_.frame.unit * static_cast<double>(length)) * material.extinction.cast<double>().array();
  }

  // Takes the piece of the way up to the hit.
  [[nodiscard]] End advance(const Hit& hit, Way& way) const {
    if (hit.face == Hit::kNothing) return way.depth == 0 ? End::kFree : End::kNoExit;
    const Eigen::Vector3f& along = directions_.direction(way.direction);
    const Face& face = mesh_.faces[hit.face];
    if (++way.surfaces > kMostSurfaces) return End::kBlocked;
    if (way.depth > 0) pass(hit.distance, way);
    const Eigen::Vector3f outwards = face_normal(mesh_.positions, face);
    const bool enters = outwards.dot(along) < 0.0F;
    const std::uint16_t material = mesh_.translucence.empty() ? std::uint16_t{0} : mesh_.translucence[face[0]];
    if (!to_exit_ && (material == 0 || mesh_.translucences.at(material - 1U).scatters())) return End::kBlocked;
    if (enters) {
      if (way.depth == 0) way.material = material;
      ++way.depth;
    } else {
      way.depth = std::max(0, way.depth - 1);  // a vertex inside another body leaves that one, too
      if (way.depth == 0 && to_exit_) return End::kFree;
    }
    const Eigen::Vector3f point = way.origin + hit.distance * along;
    const float rounding = std::numeric_limits<float>::epsilon() * std::max(point.cwiseAbs().maxCoeff(), hit.distance);
    way.origin = point + (enters ? -kRoundings : kRoundings) * rounding * outwards;
    return End::kGoesOn;
  }

  const Mesh& mesh_;
  const Tracer& tracer_;
  const SharedDirections& directions_;
  bool to_exit_;
  std::vector<float> heights_;
  std::array<Eigen::Vector3f, kMostTries + 1> starts_;
  float depth_ = 0.0F;  // of the starts below the surface
  float reach_ = 0.0F;
  std::uint16_t material_ = 0;
  std::vector<Way> ways_;
  std::vector<Eigen::Vector3f> origins_;
  std::vector<Eigen::Vector3f> along_;
  std::vector<Hit> hits_;
};

// The buffers of one thread.
struct Worker {
  Worker(const Mesh& mesh, const Tracer& tracer, const SharedDirections& directions, bool to_exit)
      : follower(mesh, tracer, directions, to_exit), cosines(directions.size()) {
    for (std::vector<float>& color : weights) color.resize(directions.size());
  }
  Follower follower;
  std::vector<std::uint32_t> chosen;
  std::array<std::vector<float>, 3> weights;
  std::vector<float> cosines;
  Gathered sums{};
  std::size_t no_exit = 0;
};

// Calls each(vertex, start, worker) for every vertex, which follows its rays. `row` numbers a vertex.
template <class Each>
BodyRays follow_all(const Mesh& mesh, const BakeOptions& options, int threads, const std::string& instruction_set,
                    std::size_t row, bool to_exit, const char* name, const Each& each) {
  const Tracer tracer(mesh, threads, instruction_set);
  BakeOptions whole = options;
  if (whole.sampler == Sampler::kCosine) whole.sampler = Sampler::kFibonacci;  // it is about the normal
  const SharedDirections directions(whole, sums_of(options.degree));
  const std::vector<RayStart> starts = ray_starts(mesh);
  const std::size_t vertices = mesh.positions.size();
  BodyRays result;
  result.rows.assign(vertices * row, 0.0F);
  result.instruction_set = tracer.instruction_set();
  output::Progress progress(name, vertices);
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(mesh, tracer, directions, to_exit); });
  std::vector<float> open(vertices, 0.0F);
  for_chunks(vertices, [&](std::size_t chunk) {
    Worker& worker = workers.local();
    const VertexRange range = chunk_range(chunk, vertices);
    for (std::size_t v = range.first; v < range.last; ++v) {
      output::check_interrupt();
      worker.no_exit = 0;
      const std::size_t all = each(v, starts[v], directions, worker, result.rows.data() + v * row);
      open[v] = all == 0 ? 0.0F : static_cast<float>(worker.no_exit) / static_cast<float>(all);
    }
    progress.advance(range.size());
  });
  progress.finish();
  for (const float part : open) {
    if (!(static_cast<double>(part) > kNoticedShare)) continue;
    ++result.open;
    result.share += static_cast<double>(part);
  }
  if (result.open > 0) result.share /= static_cast<double>(result.open);
  result.rays = tracer.rays();
  return result;
}

}  // namespace

BodyRays thickness(const Mesh& mesh, const BakeOptions& options, int threads, const std::string& instruction_set) {
  const std::size_t count = coefficient_count(options.degree);
  const auto each = [&](std::size_t vertex, const RayStart& start, const SharedDirections& directions, Worker& worker,
                        float* row) {
    const double weight = 4.0 * std::numbers::pi / static_cast<double>(directions.size()) * mesh.frame.unit;
    worker.chosen.clear();
    std::size_t all = 0;
    worker.follower.follow(vertex, start, [&](const Way& way, End end) {
      ++all;
      if (end != End::kFree) {
        worker.no_exit += 1;
        return;
      }
      worker.chosen.push_back(way.direction);
      worker.weights[0][way.direction] = static_cast<float>(weight * way.inside);
    });
    directions.sum(worker.chosen, worker.chosen.size(), worker.weights[0].data(), worker.sums.visible.data());
    as_array(row, count) = as_array(worker.sums.visible.data(), count);
    return all;
  };
  return follow_all(mesh, options, threads, instruction_set, count, true, "thickness", each);
}

BodyRays transmitted(const Mesh& mesh, const BakeOptions& options, int threads, const std::string& instruction_set) {
  const std::size_t count = coefficient_count(options.degree);
  const auto each = [&](std::size_t vertex, const RayStart& start, const SharedDirections& directions, Worker& worker,
                        float* row) -> std::size_t {
    const std::uint16_t number = mesh.translucence.empty() ? std::uint16_t{0} : mesh.translucence[vertex];
    if (number == 0 || mesh.translucences.at(number - 1U).scatters()) return 0;
    const Translucence& material = mesh.translucences.at(number - 1U);
    const Eigen::Vector3f behind = -mesh.normals[vertex];
    directions.cosines_with(behind * (4.0F / static_cast<float>(directions.size())), worker.cosines.data());
    // All directions behind the surface by its shading normal; those of them that rays go along come to an end.
    for (std::vector<float>& color : worker.weights) std::fill(color.begin(), color.end(), 0.0F);
    std::size_t all = 0;
    worker.follower.follow(vertex, start, [&](const Way& way, End end) {
      ++all;
      if (end == End::kNoExit) worker.no_exit += 1;
      if (end != End::kFree || !(worker.cosines[way.direction] > 0.0F)) return;
      const auto cosine = static_cast<double>(worker.cosines[way.direction]);
      for (std::size_t c = 0; c < 3; ++c) {
        worker.weights[c][way.direction] =
            static_cast<float>(cosine * std::exp(-way.attenuation[static_cast<Eigen::Index>(c)]));
      }
    });
    worker.chosen.clear();
    for (std::uint32_t j = 0; j < directions.size(); ++j) {
      if (worker.cosines[j] > 0.0F) worker.chosen.push_back(j);
    }
    Gathered& sums = worker.sums;
    directions.sum(worker.chosen, worker.chosen.size(), worker.cosines.data(), sums.all.data());
    const std::vector<float> free = unshadowed_transfer(options.degree, {behind});
    for (std::size_t c = 0; c < 3; ++c) {
      float* color = row + c * count;
      directions.sum(worker.chosen, worker.chosen.size(), worker.weights[c].data(), sums.visible.data());
      std::copy(free.begin(), free.end(), color);
      control_with_unshadowed(sums, count, color);
      as_array(color, count) *= material.transmission[static_cast<Eigen::Index>(c)];
    }
    return all;
  };
  return follow_all(mesh, options, threads, instruction_set, 3 * count, false, "transmit", each);
}

}  // namespace sh::prt
