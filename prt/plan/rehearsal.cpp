#include "prt/plan/rehearsal.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "prt/bake/bounces.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/bake/steps.hpp"
#include "prt/transfer/unshadowed.hpp"

namespace sh::prt {

namespace {

constexpr double kCoarseTolerance = 1e-2;
constexpr std::size_t kChannels = 3;

BakeOptions with(BakeOptions options, int directions, Sampler sampler, std::uint32_t seed) {
  options.directions = directions;
  options.sampler = sampler;
  options.seed = seed;
  return options;
}

// Traces vertices; returns their shadowed vectors and sights, and adds their rows to `factors` unless it is null. The
// tables have a row for every vertex of the mesh.
ShadowResult traced(const RaySetup& setup, const std::vector<std::uint32_t>& vertices,
                    const std::vector<std::uint8_t>& open, Transfer& transfer, FormFactors* factors) {
  transfer.coefficients = unshadowed_transfer(transfer.degree(), setup.mesh.normals);
  ShadowResult result{transfer, std::vector<Sight>(setup.mesh.positions.size()), factors};
  if (!vertices.empty()) ShadowPass(setup, open, result).sample(vertices, std::numeric_limits<double>::infinity());
  return result;
}

}  // namespace

Rehearsal::Half::Half(const RaySetup& first, const BakeOptions& options)
    : setup(first, options),
      transfer(Transfer::of(kShadowed, options.degree)),
      factors(options.kind->has_bounces() ? first.mesh.positions.size() : 0) {}

Rehearsal::Rehearsal(Mesh mesh, const BakeOptions& asked, const std::string& instruction_set)
    : mesh_(std::move(mesh)),
      asked_(asked),
      first_(mesh_, coarse_options(0), tbb::this_task_arena::max_concurrency(), instruction_set) {
  for (std::uint32_t half = 0; half < halves_.size(); ++half) {
    halves_[half] = std::make_unique<Half>(first_, coarse_options(half));
    bake(*halves_[half]);
  }
  rays_a_direction_ = static_cast<double>(first_.tracer.rays()) / (2.0 * kCoarseDirections);
}

BakeOptions Rehearsal::coarse_options(std::uint32_t half) const {
  const Sampler sampler = asked_.sampler == Sampler::kCosine ? Sampler::kCosine : Sampler::kSobol;
  return with(asked_, kCoarseDirections, sampler, half + 1);
}

void Rehearsal::bake(Half& half) const {
  const bool bounces = asked_.kind->has_bounces();
  std::vector<std::uint32_t> all(asked_.kind->traces_rays() ? mesh_.positions.size() : 0);
  std::iota(all.begin(), all.end(), 0U);
  half.sight = traced(half.setup, all, {}, half.transfer, bounces ? &half.factors : nullptr).sight;
  Fill fill(closed_vertices(mesh_, half.sight));
  const std::size_t length = half.transfer.shape.length();
  fill.apply(half.transfer.coefficients.data(), length, length);
  if (!bounces) return;
  half.factors.fill_with(std::move(fill));
  const BounceLayout layout{half.transfer.shape.count()};
  half.transfer.kind = asked_.kind;
  Panel x = direct_light(mesh_, half.transfer, layout);
  solve_bounces(half.factors, mesh_.albedo, layout, x, {.tolerance = kCoarseTolerance});
  take_solution(x, layout, half.transfer);
}

std::vector<float> Rehearsal::rows(const BakeOptions& options, const TracedPart& part,
                                   const std::vector<std::uint8_t>& open) const {
  const bool bounces = options.kind->has_bounces();
  BakeOptions full = options;
  full.degree = asked_.degree;
  const RaySetup setup(first_, full);
  Transfer direct = Transfer::of(kShadowed, full.degree);
  FormFactors factors(bounces ? mesh_.positions.size() : 0);
  const bool traces = options.kind->traces_rays();
  const ShadowResult result = traced(setup, traces ? part.vertices() : std::vector<std::uint32_t>(), open, direct,
                                     bounces ? &factors : nullptr);
  const TransferShape shape = options.kind->shape(full.degree);
  const std::size_t count = shape.count();
  const std::size_t length = shape.length();
  std::vector<float> rows(part.size() * length);
  std::vector<Sight> sight;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::uint32_t v = part.vertices()[i];
    sight.push_back(result.sight[v]);
    float* row = rows.data() + i * length;
    for (std::size_t c = 0; c < shape.channels; ++c) std::copy_n(direct.row(v), count, row + c * count);
    if (!bounces) continue;
    for (const FormFactor& factor : factors.row(v)) {
      const auto weight = static_cast<float>(factor.weight) / 2.0F;
      const float* x = coarse(0).data() + factor.vertex * length;
      const float* y = coarse(1).data() + factor.vertex * length;
      for (std::size_t k = 0; k < length; ++k) row[k] += weight * (x[k] + y[k]);
    }
  }
  part.fill(sight).apply(rows.data(), length, length);
  rows.resize(part.wanted() * length);
  for (std::size_t i = 0; shape.holds_albedo && i < rows.size(); ++i) {
    rows[i] *= mesh_.albedo[part.vertices()[i / length]][static_cast<Eigen::Index>(i % length / count)];
  }
  return rows;
}

double Rehearsal::spread(const std::vector<LightCoefficients>& lights) const {
  if (!asked_.kind->has_bounces()) return 1.0;
  const std::size_t vertices = mesh_.positions.size();
  const TransferShape shape = asked_.kind->shape(asked_.degree);
  Panel difference(vertices, kChannels * lights.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t column = 0; column < kChannels * lights.size(); ++column) {
      const std::size_t c = column % kChannels;
      const std::size_t first = v * shape.length() + c * shape.count();
      double& sum = difference.row(v)[column];
      for (std::size_t k = 0; k < shape.count(); ++k) {
        sum += static_cast<double>(coarse(0)[first + k] - coarse(1)[first + k]) * lights[column / kChannels].at(c, k);
      }
    }
  }
  double whole = 0.0;
  double local = 0.0;
  std::array<Panel, 2> reflected = {Panel(vertices, difference.columns), Panel(vertices, difference.columns)};
  for (std::size_t half = 0; half < 2; ++half) halves_[half]->factors.apply(difference, reflected[half]);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t column = 0; column < kChannels * lights.size(); ++column) {
      const auto albedo = static_cast<double>(mesh_.albedo[v][static_cast<Eigen::Index>(column % kChannels)]);
      const double own = difference.row(v)[column];
      const double mean = (reflected[0].row(v)[column] + reflected[1].row(v)[column]) / 2.0;
      whole += own * own;
      local += std::pow(own - albedo * mean, 2);
    }
  }
  return local > 0.0 ? std::max(1.0, std::sqrt(whole / local)) : 1.0;
}

}  // namespace sh::prt
