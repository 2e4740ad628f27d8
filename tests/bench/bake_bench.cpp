// The time of baking the embedded scene with one thread: rays against tracing alone, bounces against the pass that
// finds the visible surfaces, and the whole bake in seconds. Bake and control take turns in one process, and the least
// time of each counts. Usage: bake_bench [--markdown] [rays|bounces|glossy|whole]..., by default all. Exit 1 if a target is missed by more
// than the noise.
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/bake/bake_volume.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/glossy_bounces.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/unshadowed.hpp"
#include "tests/bench/harness.hpp"

namespace {

using sh::bench::Table;
using namespace sh::prt;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kVertexStep = 16;  // every 16th vertex: the rays fit in memory
constexpr std::size_t kGroup = 16;       // vertices
constexpr std::size_t kStreamRays = 1024;
constexpr int kPasses = 7;
constexpr double kMilli = 1e3;
constexpr double kOfTracing = 1.0 / 0.9;  // at least 90 % of its rays a second
constexpr double kOfTracingGlossy = 1.0 / 0.85;
constexpr double kOfFirstPass = 0.25;
constexpr double kGlossyOfFirstPass = 3.0;
constexpr double kWholeSeconds = 10.0;

template <class Work>
double seconds(const Work& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Of all threads; long work meets disturbance anyway.
template <class Work>
double processor_seconds(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Every kVertexStep-th receiver, in groups: short enough that some pass meets each undisturbed.
struct Group {
  std::vector<std::size_t> vertices;
  std::vector<std::vector<ShadowRay>> rays;  // that a gatherer makes of each
  double traced = std::numeric_limits<double>::max();
  double baked = std::numeric_limits<double>::max();
};

std::vector<Group> groups_of(std::size_t receivers, Gatherer& gatherer) {
  std::vector<Group> groups;
  for (std::size_t v = 0; v < receivers; v += kVertexStep) {
    if (v % (kVertexStep * kGroup) == 0) groups.emplace_back();
    groups.back().vertices.push_back(v);
    groups.back().rays.push_back(gatherer.rays(v));
  }
  return groups;
}

void trace(const Tracer& tracer, std::vector<std::vector<ShadowRay>>& rays) {
  for (std::vector<ShadowRay>& vertex : rays) {
    for (std::size_t first = 0; first < vertex.size(); first += kStreamRays) {
      tracer.occluded({vertex.data() + first, std::min(kStreamRays, vertex.size() - first)});
    }
  }
}

// `traced` is nothing but Embree over prebuilt, culled rays; `baked` makes the same rays, traces and sums them.
void rays_of(Table& table, const std::string& what, const RaySetup& setup, double target) {
  Gatherer gatherer(setup.mesh, setup.starts, setup.tracer, setup.directions);
  std::vector<Group> groups = groups_of(setup.starts.size(), gatherer);
  float sum = 0.0F;
  for (int pass = 0; pass < kPasses; ++pass) {
    for (Group& group : groups) {
      auto fresh = group.rays;
      group.traced = std::min(group.traced, seconds([&] { trace(setup.tracer, fresh); }));
      group.baked = std::min(group.baked, seconds([&] {
                               for (const std::size_t v : group.vertices) sum += gatherer.gather(v).fraction();
                             }));
    }
  }
  sh::bench::keep(sum);
  double traced = 0.0;
  double baked = 0.0;
  std::size_t count = 0;
  for (const Group& group : groups) {
    traced += group.traced;
    baked += group.baked;
    for (const auto& vertex : group.rays) count += vertex.size();
  }
  const double nano = 1e9 / static_cast<double>(count);
  table.ratio(what, "ns/ray", baked * nano, traced * nano, "tracing alone", target);
}

void rays_at(Table& table, const TransferKind& kind, int degree, double target) {
  Scene scene = load_scene("demo", OnFlaw::kMend);
  scene.bake.degree = degree;
  scene.bake.kind = &kind;
  const RaySetup setup(scene.mesh, scene.bake, 1, "");
  rays_of(table, std::string(kind.letters) + ", degree " + std::to_string(degree), setup, target);
}

// The space around the embedded scene: 64 x 64 x 8 points in its box without lights, 49 numbers each.
void rays_around(Table& table) {
  Scene scene = load_scene("demo", OnFlaw::kMend);
  scene.lights.clear();  // the box would be larger, and most rays short
  const VolumeOptions options;
  const PointGrid grid{default_box(scene, options), options.counts};
  std::vector<RayStart> points;
  for (std::size_t p = 0; p < grid.points(); ++p) {
    points.push_back({scene.mesh.frame.local(grid.point(p)).cast<float>(), 0.0F, true});
  }
  const BakeOptions bake{.degree = options.degree, .directions = options.directions, .kind = &kNeighborhood};
  const RaySetup setup(scene.mesh, bake, kNeighborhood.shape(options.degree), std::move(points), 1, "");
  rays_of(table, "N, degree 2 to 4", setup, kOfTracingGlossy);
}

void rays(Table& table) {
  table.section("Rays of the shadowed bake",
                "the same rays; at least 90 % of rtcOccluded1M's speed is at most 1.11, 85 % 1.18");
  rays_at(table, kShadowed, 4, kOfTracing);
  rays_at(table, kShadowed, 10, kOfTracing);
  rays_at(table, kGlossyShadowed, 4, kOfTracingGlossy);
  rays_around(table);
}

void bounces(Table& table) {
  table.section("Bounces, degree 4", "each further one with the hits of the first pass; processor time");
  Scene scene = load_scene("demo", OnFlaw::kMend);
  const RaySetup setup(scene.mesh, scene.bake, 1, "");
  const std::size_t vertices = scene.mesh.positions.size();
  Transfer transfer;
  transfer.shape.degree = scene.bake.degree;
  transfer.coefficients = unshadowed_transfer(scene.bake.degree, scene.mesh.normals);
  FormFactors factors(vertices);
  ShadowResult result{transfer, std::vector<Sight>(vertices), &factors};
  Checkpoint none({}, "", result);
  const double pass = processor_seconds([&] { ShadowPass(setup, {}, result).run(none); });
  const BounceLayout layout{transfer.shape.count()};
  const Panel x(vertices, layout.columns());
  Panel y = x;
  double bounce = std::numeric_limits<double>::max();
  for (int i = 0; i < kPasses; ++i) bounce = std::min(bounce, processor_seconds([&] { factors.apply(x, y); }));
  table.ratio("one more bounce", "ms", bounce * kMilli, pass * kMilli, "first pass", kOfFirstPass);
}

// A bounce of matrices: the time of two of them without that of one, which holds the search for the hits, too.
void glossy(Table& table) {
  table.section("Bounces of glossy transfer, degree 4, matrices of 25 x 75", "512 directions; processor time");
  Scene scene = load_scene("demo", OnFlaw::kMend);
  scene.bake.kind = &kGlossyInterreflected;
  scene.bake.directions = 512;
  const std::size_t vertices = scene.mesh.positions.size();
  scene.mesh.specular.assign(vertices, Eigen::Vector3f(0.3F, 0.25F, 0.2F));
  scene.mesh.exponent.assign(vertices, 20.0F);
  const RaySetup setup(scene.mesh, scene.bake, 1, "");
  Transfer transfer = Transfer::of(kGlossyShadowed, scene.bake.degree);
  transfer.coefficients = unshadowed_transfer(transfer.shape, scene.mesh);
  ShadowResult found{transfer, std::vector<Sight>(vertices), nullptr};
  Checkpoint none({}, "", found);
  const double pass = processor_seconds([&] { ShadowPass(setup, {}, found).run(none); });
  transfer.kind = &kGlossyInterreflected;
  const auto bounced = [&](int times) {
    return processor_seconds(
        [&] { solve_glossy_bounces(setup, found, {}, SIZE_MAX, {.tolerance = 0.0, .most_applications = times}); });
  };
  const double once = bounced(1);
  table.ratio("one more bounce, " + std::to_string(vertices) + " vertices", "s", bounced(2) - once, pass, "first pass",
              kGlossyOfFirstPass);
}

// As `prt bake demo --plan MODE` does, but for its estimate and the file.
double planned_seconds(PlanMode mode) {
  return processor_seconds([mode] {
    Scene scene = load_scene("demo", OnFlaw::kMend);
    scene.plan.mode = mode;
    sh::bench::keep(bake(std::move(scene)));
  });
}

void whole(Table& table) {
  table.section("The embedded scene as it is, shadowed", "processor time of load, plan and bake");
  table.figure("plan exact, the default", "s", planned_seconds(PlanMode::kExact), kWholeSeconds);
  table.figure("plan lossy, error 0.01", "s", planned_seconds(PlanMode::kLossy), kWholeSeconds);
  table.figure("plan none", "s", planned_seconds(PlanMode::kNone), kWholeSeconds);
}

}  // namespace

int main(int argc, char** argv) {
  return oneapi::tbb::task_arena(1).execute([&] {
    return sh::bench::run_sections(argc, argv,
                                   {{"rays", rays}, {"bounces", bounces}, {"glossy", glossy}, {"whole", whole}});
  });
}
