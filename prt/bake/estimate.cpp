#include "prt/bake/estimate.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "prt/bake/bounces.hpp"
#include "prt/bake/glossy_bounces.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr double kSampleSeconds = 0.05;
constexpr std::size_t kMostSamples = 4096;
// Neighbors are sampled one after the other, as the bake traces them: the first rays of a run bring what the others need
// into the caches. A run is one vertex if it has so many rays.
constexpr std::size_t kRunRays = 2048;
constexpr std::size_t kLongestRun = 32;       // vertices
constexpr std::size_t kPanels = 4;            // of the series: sum, term, next term, right sides
constexpr std::size_t kBytesADirection = 72;  // of a thread's buffers
constexpr double kUsedOfBudget = 5.0 / 6.0;
constexpr double kBouncesOfBudget = 0.5;
constexpr double kSeriesAtMost = 60.0;  // then the Krylov solver is quicker

std::size_t resident_memory() {
  std::size_t pages = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

// Vertices that need rays, in runs in golden-ratio order: any number of the first runs is spread over the mesh.
std::vector<std::uint32_t> spread_vertices(std::size_t vertices, std::size_t directions,
                                           const std::vector<std::uint8_t>& open, std::size_t& traced) {
  std::vector<std::uint32_t> closed;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (open.empty() || open[v] == 0) closed.push_back(static_cast<std::uint32_t>(v));
  }
  traced = closed.size();
  std::vector<std::uint32_t> spread;
  const std::size_t run =
      closed.size() > kMostSamples ? std::clamp<std::size_t>(kRunRays / directions, 1, kLongestRun) : 1;
  const std::size_t runs = closed.size() / run;
  for (std::size_t i = 0; i < std::min(kMostSamples / run, runs); ++i) {
    const double turn = static_cast<double>(i) / std::numbers::phi;
    const auto first = static_cast<std::size_t>((turn - std::floor(turn)) * static_cast<double>(runs)) * run;
    spread.insert(spread.end(), closed.begin() + static_cast<std::ptrdiff_t>(first),
                  closed.begin() + static_cast<std::ptrdiff_t>(first + run));
  }
  return spread;
}

// The seconds that K x takes for some rows, the least of three.
double apply_seconds(const FormFactors& factors, std::size_t vertices, std::size_t columns) {
  const Panel x(vertices, columns);
  Panel y(factors.size(), columns);
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i) {
    const output::Stopwatch stopwatch;
    factors.apply(x, y);
    least = std::min(least, stopwatch.seconds());
  }
  return least;
}

// Estimates the bounces from the rows of the sampled vertices.
void estimate_bounces(const BakeJob& job, const FormFactors& all, const std::vector<std::uint32_t>& samples,
                      BakeEstimate& estimate) {
  const Scene& scene = job.scene;
  const std::size_t memory = job.settings.bounce_memory;
  FormFactors factors(samples.size());
  std::size_t entries = 0;
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FormFactorRow& row = all.row(samples[i]);
    double reflected = 0.0;  // share of the vertex's light that comes back to it
    for (const FormFactor& factor : row) {
      reflected += factor.weight * static_cast<double>(scene.mesh.albedo[factor.vertex].maxCoeff());
    }
    entries += row.size();
    sum += reflected;
    square += reflected * reflected;
    factors.keep(i, row);
  }
  const double scale = static_cast<double>(estimate.vertices) / static_cast<double>(samples.size());
  const BounceLayout layout{scene.bake.kind->shape(scene.bake.degree).count()};
  estimate.factor_bytes = static_cast<std::size_t>(static_cast<double>(entries * sizeof(FormFactor)) * scale);
  estimate.bounce_seconds = apply_seconds(factors, scene.mesh.positions.size(), layout.columns()) * scale;
  const double kept =
      estimate.factor_bytes <= memory ? 1.0 : static_cast<double>(memory) / static_cast<double>(estimate.factor_bytes);
  estimate.bounce_seconds += (1.0 - kept) * estimate.pass_seconds;
  const double rate = sum > 0.0 ? std::min(square / sum, 0.99) : 0.0;  // light goes where much of it comes back
  estimate.bounces = rate > 0.0 ? std::log(scene.bake.bounces.tolerance) / std::log(rate) : 1.0;
  estimate.bounces = std::clamp(std::ceil(estimate.bounces), 1.0, kSeriesAtMost);
  const Panel row(1, layout.columns());
  estimate.bytes += std::min(estimate.factor_bytes, memory) +
                    scene.mesh.positions.size() * (kPanels * row.columns * sizeof(double) +
                                                   BounceLayout::kChannels * layout.count * sizeof(float));
}

BakeEstimate estimate_rays(const BakeJob& job) {
  const Scene& scene = job.scene;
  const BakeSettings& settings = job.settings;
  const std::vector<std::uint8_t> open = job.plan ? job.plan->open : std::vector<std::uint8_t>();
  const output::Stopwatch stopwatch;
  const RaySetup setup(scene.mesh, scene.bake, settings.threads, settings.instruction_set);
  BakeEstimate estimate;
  estimate.tracer = setup.shared;
  estimate.setup_seconds = stopwatch.seconds();
  const std::size_t vertices = scene.mesh.positions.size();
  Transfer transfer;
  transfer.shape = scene.bake.kind->traced_shape(scene.bake.degree);
  transfer.coefficients = unshadowed_transfer(transfer.shape, scene.mesh);
  const bool bounces = scene.bake.kind->has_form_factors();
  FormFactors factors(bounces ? vertices : 0);
  ShadowResult result{transfer, std::vector<Sight>(vertices), bounces ? &factors : nullptr};
  const std::vector<std::uint32_t> samples = estimate_pass(setup, open, settings.threads, result, estimate);
  if (samples.empty()) return estimate;
  if (scene.bake.kind->indirect != nullptr) estimate.bytes += glossy_bounce_bytes(scene.mesh, scene.bake.degree);
  if (bounces) estimate_bounces(job, factors, samples, estimate);
  return estimate;
}

}  // namespace

std::vector<std::uint32_t> estimate_pass(const RaySetup& setup, const std::vector<std::uint8_t>& open, int threads,
                                         ShadowResult& result, BakeEstimate& estimate) {
  std::vector<std::uint32_t> samples =
      spread_vertices(result.sight.size(), setup.directions.size(), open, estimate.vertices);
  const ShadowPass::Sampled sampled = ShadowPass(setup, open, result).sample(samples, kSampleSeconds);
  samples.resize(sampled.vertices);
  if (samples.empty()) return samples;
  const double scale = static_cast<double>(estimate.vertices) / static_cast<double>(samples.size());
  estimate.pass_seconds = sampled.seconds * scale;
  estimate.rays = static_cast<double>(setup.tracer.rays()) * scale;
  estimate.bytes = resident_memory() + setup.directions.size() * kBytesADirection * thread_count(threads);
  return samples;
}

BakeEstimate estimate_bake(const BakeJob& job) {
  BakeEstimate estimate;
  if (job.scene.bake.kind->traces_rays()) on_threads(job.settings.threads, [&] { estimate = estimate_rays(job); });
  return estimate;
}

BakeOptions within_budget(const BakeOptions& wanted, const BakeEstimate& estimate, double seconds) {
  const double available = kUsedOfBudget * seconds - estimate.setup_seconds;
  const double bounces = std::min(estimate.bounces * estimate.bounce_seconds, kBouncesOfBudget * available);
  const double part = (available - bounces) / std::max(estimate.pass_seconds, 1e-9);
  const int least = std::min(kLeastDirections, wanted.directions);
  BakeOptions options = wanted;
  if (part < 1.0) options.directions = static_cast<int>(part * static_cast<double>(wanted.directions));
  if (options.directions < least) {
    const double pass = estimate.pass_seconds * static_cast<double>(least) / static_cast<double>(wanted.directions);
    const double needed =
        (estimate.setup_seconds + pass + std::min(pass, estimate.bounces * estimate.bounce_seconds)) / kUsedOfBudget;
    throw std::runtime_error(
        fmt::format("--budget-seconds {}: too short; {} directions, the least, take about {:.2g} s", seconds, least,
                    std::max(needed, 1.01 * seconds)));
  }
  return options;
}

Shortfall shortfall(const BakeOptions& wanted, const Transfer& transfer) {
  Shortfall missing;
  if (transfer.directions > 0 && static_cast<int>(transfer.directions) < wanted.directions) {
    missing.directions = static_cast<std::uint32_t>(wanted.directions);
  }
  if (transfer.kind->indirect != nullptr && !(transfer.bounces.residual <= wanted.bounces.tolerance)) {
    missing.tolerance = wanted.bounces.tolerance;
  }
  if (transfer.kind->has_form_factors() &&
      !(transfer.bounces.bound <= (wanted.bounces.tolerance + kSingleRounding) * transfer.bounces.largest)) {
    missing.tolerance = wanted.bounces.tolerance;
  }
  return missing;
}

std::size_t peak_memory() {
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t{1024} * usage.ru_maxrss;
}

double memory_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace sh::prt
