#include "prt/bake/bake_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/sent_to_points.hpp"
#include "prt/bake/shadow_box.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/basis.hpp"
#include "prt/chunks.hpp"
#include "prt/rays/directions.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {

namespace {

constexpr double kMiB = 1048576.0;
constexpr float kInside = 0.5F;

Transfer without_numbers(const Scene& scene, const VolumeOptions& options, const PointGrid& grid) {
  const TransferKind& kind = options.reflects ? kReflectingNeighborhood : kNeighborhood;
  Transfer volume = Transfer::of(kind, options.degree);
  volume.scene = scene.name;
  volume.shape.result_degree = options.result_degree;
  if (options.reflects) {
    volume.indirect_shape = kind.indirect(options.degree);
    volume.indirect_shape.result_degree = options.result_degree;
  }
  volume.grid = grid;
  volume.directions = static_cast<std::uint32_t>(options.directions);
  volume.sampler = options.sampler;
  volume.seed = options.seed;
  return volume;
}

// Numbers, the start and the sight of every point, and the rows of the file where they are not those in memory.
double bytes_a_point(const Transfer& volume, Element element) {
  const TransferShape& shape = volume.shape;
  const std::size_t encoded = element == Element::kSingle ? 0 : shape.length() * bytes_of(element);
  const std::size_t matrices =
      volume.kind->stores_matrices() ? volume.indirect_shape.length() * (sizeof(float) + bytes_of(Element::kHalf)) : 0;
  return static_cast<double>(shape.length() * sizeof(float) + sizeof(RayStart) + sizeof(Sight) + encoded + matrices);
}

void require_memory(const Transfer& volume, const VolumeOptions& options, const BakeObserver& say) {
  const double there = options.memory > 0.0 ? options.memory : memory_of_machine();
  const double each = bytes_a_point(volume, options.element);
  const double needed = each * static_cast<double>(volume.receivers());
  if (needed > there) {
    const double shrink = std::cbrt(there / needed);
    const auto fits = [&](std::uint32_t n) {
      return std::max(kFewestAlong, static_cast<std::uint32_t>(std::floor(shrink * n)));
    };
    const auto& n = volume.grid->counts;
    throw std::invalid_argument(fmt::format(
        "{}: {} points need {:.0f} MiB, {:.0f} are allowed; expected at most {:.0f} points, such as {} x {} x {}",
        volume.scene, fmt::join(n, " x "), needed / kMiB, there / kMiB, std::floor(there / each), fits(n[0]),
        fits(n[1]), fits(n[2])));
  }
  if (say) {
    say(fmt::format("{} points of {} numbers, {:.3g} million rays, {:.0f} MiB", fmt::join(volume.grid->counts, " x "),
                    volume.shape.length() + (volume.kind->stores_matrices() ? volume.indirect_shape.length() : 0),
                    1e-6 * static_cast<double>(volume.receivers()) * static_cast<double>(volume.directions),
                    std::ceil(needed / kMiB)));
  }
}

Eigen::AlignedBox3d bounds_of(const Scene& scene) {
  return scene.medium ? scene.medium->extinction.support() : bounding_box(points_of(scene.mesh));
}

PointGrid grid_of(const Scene& scene, const VolumeOptions& options) {
  PointGrid grid{options.box ? *options.box : default_box(scene, options), options.counts};
  if (const std::string flaw = flaw_of(grid); !flaw.empty()) {
    throw std::invalid_argument(fmt::format("{}: {}", scene.name, flaw));
  }
  const Eigen::AlignedBox3d bounds = bounds_of(scene);
  if (!grid.box.contains(bounds)) {
    const auto text = [](const Eigen::Vector3d& p) { return fmt::format("{:.6g} {:.6g} {:.6g}", p.x(), p.y(), p.z()); };
    throw std::invalid_argument(
        fmt::format("{}: the box from {} to {} does not contain the object, which reaches from {} to {}", scene.name,
                    text(grid.box.min()), text(grid.box.max()), text(bounds.min()), text(bounds.max())));
  }
  return grid;
}

void check(const Scene& scene, const VolumeOptions& options) {
  const auto require = [&](const char* what, int value) {
    if (value < 0 || value > kHighestProduct) {
      throw std::invalid_argument(
          fmt::format("{}: expected 0 to {} around an object, got {}", what, kHighestProduct, value));
    }
  };
  require("degree", options.degree);
  require("result degree", options.result_degree);
  if (options.directions < 1 || options.directions > kMaxDirections) {
    throw std::invalid_argument(
        fmt::format("directions: expected 1 to {}, got {}", kMaxDirections, options.directions));
  }
  if (!(options.faintest_shadow >= kFaintestShadow && options.faintest_shadow < 1.0)) {
    throw std::invalid_argument(
        fmt::format("faintest shadow: expected a part of the light, {} or more and below 1, got {}", kFaintestShadow,
                    options.faintest_shadow));
  }
  if (options.sampler == Sampler::kCosine) {
    throw std::invalid_argument(fmt::format(
        "{}: the sampler cosine has directions of one half of the sphere; expected another one", scene.name));
  }
  if (scene.mesh.faces.empty() && !scene.medium) {
    throw std::invalid_argument(fmt::format("{}: the mesh has no faces, expected at least one triangle", scene.name));
  }
}

std::vector<RayStart> starts_of(const PointGrid& grid, const Frame& frame) {
  std::vector<RayStart> starts(grid.points());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    starts[i] = {frame.local(grid.point(i)).cast<float>(), 0.0F, true};
  }
  return starts;
}

// Gives the points inside solids that lie beside others the numbers of these; tells how many lie inside.
std::size_t fill_inside(const std::vector<Sight>& sight, Transfer& volume) {
  PointGrid& grid = *volume.grid;
  const auto is_inside = [&](std::size_t p) { return sight[p].closed() > kInside; };
  std::vector<std::uint8_t> deep(sight.size(), 0);
  for (std::size_t p = 0; p < sight.size(); ++p) {
    if (!is_inside(p)) continue;
    deep[p] = 1;
    for_neighbors(grid, p, [&](std::size_t q) {
      if (!is_inside(q)) deep[p] = 0;
    });
  }
  std::vector<ClosedVertex> closed;
  std::size_t inside = 0;
  for (std::size_t p = 0; p < sight.size(); ++p) {
    inside += is_inside(p) ? 1 : 0;
    if (!(sight[p].closed() > 0.0F) || deep[p] != 0) continue;
    ClosedVertex& point = closed.emplace_back(ClosedVertex{static_cast<std::uint32_t>(p), sight[p].closed(), {}});
    for_neighbors(grid, p, [&](std::size_t q) {
      if (deep[q] == 0) point.neighbors.push_back(static_cast<std::uint32_t>(q));
    });
    grid.filled += is_inside(p) ? 1 : 0;
  }
  const Fill fill(std::move(closed));
  fill.apply(volume.coefficients.data(), volume.shape.length(), volume.shape.length());
  const std::size_t length = volume.indirect_shape.length();
  if (!volume.indirect.empty()) fill.apply(volume.indirect.data(), length, length);
  return inside;
}

std::string key_of(const Scene& scene, const BakeOptions& bake, const Transfer& volume) {
  Scene described = scene;  // its own bake does not matter
  described.bake = bake;
  const PointGrid& grid = *volume.grid;
  const Eigen::Vector3d& low = grid.box.min();
  const Eigen::Vector3d& high = grid.box.max();
  return bake_key(described, volume.instruction_set, {},
                  fmt::format("{} points from {} {} {} to {} {} {}, result of degree {}", fmt::join(grid.counts, " x "),
                              low.x(), low.y(), low.z(), high.x(), high.y(), high.z(), volume.shape.result_degree));
}

// The matrices of what the scene's surfaces send, which are baked for this first.
std::uint64_t reflect(const Scene& scene, const BakeOptions& bake, const BakeSettings& settings, Transfer& volume) {
  Scene surfaces = scene;
  surfaces.bake = bake;
  surfaces.bake.kind = &kInterreflected;
  surfaces.plan = {};
  surfaces.mesh.emission.clear();  // no light of a volume is there without the light
  BakeReport report;
  BakeSettings own = settings;
  own.checkpoint = {};
  const Transfer baked = sh::prt::bake(BakeJob(std::move(surfaces), own), &report);
  const RaySetup setup(baked.mesh, bake, volume.shape, starts_of(*volume.grid, baked.mesh.frame), settings.threads,
                       settings.instruction_set);
  volume.indirect = sent_to_points(setup, baked, volume.indirect_shape);
  return report.rays + setup.tracer.rays();
}

BakeOptions bake_of(const VolumeOptions& options) {
  return {.degree = options.degree,
          .directions = options.directions,
          .sampler = options.sampler,
          .seed = options.seed,
          .kind = &kNeighborhood};
}

// A mirror blocks rays as any surface does.
Scene without_mirrors(const Scene& scene) {
  Scene blocking = scene;
  blocking.mesh.mirror.clear();
  return blocking;
}

// The whole sphere at every point.
void open_all(Transfer& volume) {
  volume.coefficients.assign(volume.receivers() * volume.shape.length(), 0.0F);
  for (std::size_t p = 0; p < volume.receivers(); ++p) {
    volume.row(p)[0] = static_cast<float>(std::sqrt(4.0 * std::numbers::pi));
  }
}

// Takes away what the rays find to be blocked.
void trace(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings, Transfer& volume,
           VolumeReport& report) {
  const Scene blocking = without_mirrors(scene);
  const BakeOptions bake = bake_of(options);
  volume.instruction_set = choose_instruction_set(settings.instruction_set);
  open_all(volume);
  ShadowResult result{volume, std::vector<Sight>(volume.receivers()), nullptr};
  Checkpoint checkpoint(settings.checkpoint, key_of(blocking, bake, volume), result);
  if (settings.checkpoint.parts.empty()) {
    const RaySetup setup(blocking.mesh, bake, volume.shape, starts_of(*volume.grid, scene.mesh.frame), settings.threads,
                         settings.instruction_set);
    try {
      ShadowPass(setup, {}, result).run(checkpoint);
    } catch (const output::Interrupted&) {
      throw output::Interrupted(checkpoint.interrupted());
    }
    report.bake.rays = setup.tracer.rays();
    report.bake.checkpoint = settings.checkpoint.path;
  }
  if (!settings.checkpoint.shard.is_whole()) return;  // the checkpoint is the result
  if (options.reflects) report.bake.rays += reflect(scene, bake, settings, volume);
  report.inside = fill_inside(result.sight, volume);
  report.border = blocked_at_border(volume);
}

}  // namespace

Eigen::AlignedBox3d default_box(const Scene& scene, const VolumeOptions& options) {
  if (!scene.lights.empty() && !options.reflects) {
    const LightCoefficients light = project(load_lights(scene.lights, OnFlaw::kMend), options.degree);
    if (const auto box = shadow_box(bounds_of(scene), light, scene.plan.turns, options.faintest_shadow)) return *box;
  }
  const Eigen::AlignedBox3d bounds = bounds_of(scene);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kBoxMargin * 0.5 * bounds.diagonal().norm());
  return {bounds.min() - margin, bounds.max() + margin};
}

double blocked_at_border(const Transfer& volume) {
  const PointGrid& grid = *volume.grid;
  const auto whole = static_cast<float>(std::sqrt(4.0 * std::numbers::pi));
  float least = whole;
  for (std::size_t p = 0; p < grid.points(); ++p) {
    const std::array<std::uint32_t, 3> at = grid.place(p);
    bool is_border = false;
    for (std::size_t axis = 0; axis < 3; ++axis) is_border |= at[axis] == 0 || at[axis] + 1 == grid.counts[axis];
    if (is_border) least = std::min(least, volume.row(p)[0]);
  }
  return 1.0 - static_cast<double>(least / whole);
}

Transfer empty_volume(const Scene& scene, const VolumeOptions& options, const BakeObserver& say) {
  check(scene, options);
  Transfer volume = without_numbers(scene, options, grid_of(scene, options));
  require_memory(volume, options, say);
  return volume;
}

Transfer bake_volume(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings,
                     VolumeReport* report, const BakeObserver& say) {
  if (settings.threads < 0) {
    throw std::invalid_argument(fmt::format("threads: expected 0 (every core) or more, got {}", settings.threads));
  }
  const bool traces = settings.checkpoint.parts.empty();
  Transfer volume = empty_volume(scene, options, traces ? say : BakeObserver());
  VolumeReport measured;
  on_threads(settings.threads, [&] { trace(scene, options, settings, volume, measured); });
  volume.shape.storage.element = options.element;
  if (report != nullptr) *report = measured;
  return volume;
}

void bake_volume_shard(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings,
                       VolumeReport* report, const BakeObserver& say) {
  require_shard(settings.checkpoint.shard);
  bake_volume(scene, options, settings, report, say);
}

BakeEstimate estimate_volume(const Scene& scene, const VolumeOptions& options, const BakeSettings& settings) {
  Transfer volume = empty_volume(scene, options, {});
  const Scene blocking = without_mirrors(scene);
  const output::Stopwatch stopwatch;
  const RaySetup setup(blocking.mesh, bake_of(options), volume.shape, starts_of(*volume.grid, scene.mesh.frame),
                       settings.threads, settings.instruction_set);
  BakeEstimate estimate;
  estimate.setup_seconds = stopwatch.seconds();
  open_all(volume);
  ShadowResult result{volume, std::vector<Sight>(volume.receivers()), nullptr};
  on_threads(settings.threads, [&] { estimate_pass(setup, {}, settings.threads, result, estimate); });
  return estimate;
}

Transfer bake_volume_to_file(const std::string& file, const Scene& scene, const VolumeOptions& options,
                             const BakeSettings& settings, VolumeReport* report, const BakeObserver& say) {
  VolumeReport measured;
  Transfer volume = bake_volume(scene, options, settings, &measured, say);
  write_transfer(file, volume);
  if (!measured.bake.checkpoint.empty()) std::filesystem::remove(measured.bake.checkpoint);
  if (report != nullptr) *report = measured;
  return volume;
}

}  // namespace sh::prt
