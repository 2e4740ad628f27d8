// How much of the ray tracer's speed the shadowed bake keeps: the embedded scene at degree 4 (or the degree given),
// one thread. `traced` is nothing but Embree over prebuilt, culled rays; `baked` makes the same rays, traces them and
// sums 25 coefficients. Both see the same vertices in the same process, by turns; the least time of each counts.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "prt/bake/gather.hpp"
#include "prt/scene/scene.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kVertexStep = 16;  // every 16th vertex: the rays fit in memory
constexpr std::size_t kStreamRays = 1024;
constexpr int kPasses = 7;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double trace(const sh::prt::Tracer& tracer, std::vector<std::vector<sh::prt::ShadowRay>> rays) {
  const auto start = Clock::now();
  for (std::vector<sh::prt::ShadowRay>& vertex : rays) {
    for (std::size_t first = 0; first < vertex.size(); first += kStreamRays) {
      tracer.occluded({vertex.data() + first, std::min(kStreamRays, vertex.size() - first)});
    }
  }
  return seconds_since(start);
}

double bake(const sh::prt::Mesh& mesh, const std::vector<sh::prt::RayStart>& starts, sh::prt::Gatherer& gatherer,
            double& sum) {
  const auto start = Clock::now();
  for (std::size_t v = 0; v < starts.size(); v += kVertexStep) {
    sum +=
        static_cast<double>(gatherer.gather(starts[v].origin, mesh.normals[v], mesh.geometric_normals[v]).fraction());
  }
  return seconds_since(start);
}

}  // namespace

int main(int argc, char** argv) {
  sh::prt::Scene scene = sh::prt::load_scene("demo", sh::prt::OnFlaw::kMend);
  if (argc > 1) {
    scene.bake.degree = std::atoi(argv[1]);
  }
  const int degree = scene.bake.degree;
  const sh::prt::Mesh& mesh = scene.mesh;
  const sh::prt::Tracer tracer(mesh, 1);
  const sh::prt::SharedDirections directions(scene.bake);
  const std::vector<sh::prt::RayStart> starts = sh::prt::ray_starts(mesh);
  sh::prt::Gatherer gatherer(directions, tracer);
  std::vector<std::vector<sh::prt::ShadowRay>> rays;
  std::size_t count = 0;
  for (std::size_t v = 0; v < starts.size(); v += kVertexStep) {
    rays.push_back(gatherer.rays(starts[v].origin, mesh.normals[v], mesh.geometric_normals[v]));
    count += rays.back().size();
  }
  double traced = std::numeric_limits<double>::max();
  double baked = traced;
  double sum = 0.0;
  for (int pass = 0; pass < kPasses; ++pass) {
    traced = std::min(traced, trace(tracer, rays));
    baked = std::min(baked, bake(mesh, starts, gatherer, sum));
  }
  const double million = static_cast<double>(count) * 1e-6;
  std::printf("shadowed bake, degree %d, %s, %.1f million rays: traced %.2f Mrays/s, baked %.2f Mrays/s, ratio %.3f\n",
              degree, tracer.instruction_set().c_str(), million, million / traced, million / baked, traced / baked);
  return sum > 0.0 ? 0 : 1;
}
