#include "prt/plan/rehearsal.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "prt/arrays.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/glossy_bounces.hpp"
#include "prt/bake/glossy_exit.hpp"
#include "prt/bake/shadow_pass.hpp"
#include "prt/bake/steps.hpp"
#include "prt/chunks.hpp"
#include "prt/plan/views.hpp"
#include "prt/runtime/glossy.hpp"
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

// What rays tell of this kind, before bounces.
const TransferKind& direct_kind(const TransferKind& kind) { return kind.is_glossy() ? kGlossyShadowed : kShadowed; }

// Traces vertices; returns their shadowed numbers and sights, and adds their rows to `factors` unless it is null. The
// tables have a row for every vertex of the mesh.
ShadowResult traced(const RaySetup& setup, const std::vector<std::uint32_t>& vertices,
                    const std::vector<std::uint8_t>& open, Transfer& transfer, FormFactors* factors) {
  transfer.coefficients = unshadowed_transfer(transfer.shape, setup.mesh);
  ShadowResult result{transfer, std::vector<Sight>(setup.mesh.positions.size()), factors};
  if (!vertices.empty()) ShadowPass(setup, open, result).sample(vertices, std::numeric_limits<double>::infinity());
  return result;
}

}  // namespace

Rehearsal::Half::Half(const RaySetup& first, const BakeOptions& options)
    : setup(first, options),
      transfer(Transfer::of(direct_kind(*options.kind), options.degree)),
      factors(options.kind->has_form_factors() ? first.mesh.positions.size() : 0) {}

Rehearsal::Rehearsal(const Scene& scene, const std::string& instruction_set)
    : name_(scene.name),
      mesh_(scene.mesh),
      asked_(scene.bake),
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
  const bool bounces = asked_.kind->has_form_factors();
  std::vector<std::uint32_t> all(asked_.kind->traces_rays() ? mesh_.positions.size() : 0);
  std::iota(all.begin(), all.end(), 0U);
  half.sight = traced(half.setup, all, {}, half.transfer, bounces ? &half.factors : nullptr).sight;
  Fill fill(closed_vertices(mesh_, half.sight));
  const std::size_t length = half.transfer.shape.length();
  fill.apply(half.transfer.coefficients.data(), length, length);
  if (asked_.kind->indirect != nullptr) {
    half.transfer.kind = asked_.kind;
    half.transfer.scene = name_;
    solve_glossy_bounces(half.setup, {half.transfer, half.sight, nullptr}, {}, SIZE_MAX,
                         {.tolerance = kCoarseTolerance});
  }
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
  const bool bounces = options.kind->has_form_factors();
  BakeOptions full = options;
  full.degree = asked_.degree;
  const RaySetup setup(first_, full);
  Transfer direct = Transfer::of(direct_kind(*options.kind), full.degree);
  FormFactors factors(bounces ? mesh_.positions.size() : 0);
  const bool traces = options.kind->traces_rays();
  const ShadowResult result = traced(setup, traces ? part.vertices() : std::vector<std::uint32_t>(), open, direct,
                                     bounces ? &factors : nullptr);
  const RowShape shape(*options.kind, mesh_, full.degree);
  const std::size_t count = shape.numbers.count();
  const std::size_t length = shape.length();
  std::vector<float> rows(part.size() * length);
  std::vector<Sight> sight;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::uint32_t v = part.vertices()[i];
    sight.push_back(result.sight[v]);
    float* row = rows.data() + i * length;
    for (std::size_t c = 0; c < shape.numbers.channels; ++c) std::copy_n(direct.row(v), count, row + c * count);
    if (!bounces) continue;
    for (const FormFactor& factor : factors.row(v)) {
      const std::size_t first = factor.vertex * length;
      as_array(row, length) += static_cast<float>(factor.weight) / 2.0F *
                               (as_array(&coarse(0)[first], length) + as_array(&coarse(1)[first], length));
    }
  }
  if (shape.matrices) gather_from_lobes(options, setup, part, open, rows.data());
  part.fill(sight).apply(rows.data(), length, length);
  rows.resize(part.wanted() * length);
  for (std::size_t i = 0; shape.numbers.holds_albedo && i < part.wanted(); ++i) {
    Eigen::Map<Eigen::MatrixX3f>(&rows[i * length], Eigen::Index(count), 3) *=
        mesh_.albedo[part.vertices()[i]].asDiagonal();
  }
  return rows;
}

// What reaches every vertex, by the mean of the coarse bakes.
MatrixTable Rehearsal::reaching(int degree) const {
  const std::size_t whole = coefficient_count(2 * asked_.degree);
  const std::size_t some = coefficient_count(2 * degree);
  std::vector<float> visibility(mesh_.positions.size() * some);
  for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
    as_array(&visibility[v * some], some) =
        (as_array(&coarse(0)[v * whole], some) + as_array(&coarse(1)[v * whole], some)) / 2.0F;
  }
  MatrixTable table(mesh_, degree);
  table.take_direct({visibility, {}, kGlossyShadowed.shape(degree)});
  for (const auto& half : halves_) table.add(half->transfer.indirect, half->transfer.indirect_shape, 0.5F);
  return table;
}

// Writes the matrices of `rows`: one bounce of what leaves the surfaces by the mean of the coarse bakes.
void Rehearsal::gather_from_lobes(const BakeOptions& options, const RaySetup& setup, const TracedPart& part,
                                  const std::vector<std::uint8_t>& open, float* rows) const {
  MatrixTable light = reaching(options.degree);
  const GlossyExit leaving(mesh_, light);
  const RowShape shape(*options.kind, mesh_, asked_.degree);
  tbb::enumerable_thread_specific<Gatherer> tracers(
      [&] { return Gatherer(setup.mesh, setup.starts, setup.tracer, setup.along_bounces()); });
  for_vertices(part.size(), [&](std::size_t i) {
    const std::uint32_t v = part.vertices()[i];
    if (!open.empty() && open[v] != 0) return;
    std::vector<float> matrix(light.size);
    leaving.collect(rays_to_fronts(tracers.local(), v), setup.along_bounces().size(), matrix.data());
    light.copy(matrix.data(), *shape.matrices, rows + i * shape.length() + shape.numbers.length());
  });
}

Transfer Rehearsal::difference() const {
  Transfer difference = halves_[0]->transfer;
  const Transfer& other = halves_[1]->transfer;
  as_array(difference.coefficients) -= as_array(other.coefficients);
  as_array(difference.indirect) -= as_array(other.indirect);
  difference.mesh.positions.resize(mesh_.positions.size());
  return difference;
}

// The same as spread(), with exit radiance towards the eyes of plans.
double Rehearsal::spread_between_lobes(const std::vector<LightCoefficients>& lights) const {
  const std::size_t vertices = mesh_.positions.size();
  Transfer difference = this->difference();
  MatrixTable whole(mesh_, asked_.degree);
  whole.take_direct(difference.rows());
  whole.add(difference.indirect, difference.indirect_shape);
  MatrixTable sent = whole;
  const GlossyExit leaving(mesh_, sent);
  MatrixTable local = whole;  // whole - K whole, K the mean operator of the coarse bakes
  for (const auto& half : halves_) {
    const RaySetup& setup = half->setup;
    tbb::enumerable_thread_specific<Gatherer> tracers(
        [&] { return Gatherer(setup.mesh, setup.starts, setup.tracer, setup.along_bounces()); });
    MatrixTable reflected(mesh_, asked_.degree);
    for_vertices(vertices, [&](std::size_t v) {
      leaving.collect(rays_to_fronts(tracers.local(), v), setup.along_bounces().size(), reflected.of(v));
    });
    Fill(closed_vertices(mesh_, half->sight)).apply(reflected.values.data(), reflected.size, reflected.size);
    local.add(reflected, -0.5F);
  }
  std::fill(difference.coefficients.begin(), difference.coefficients.end(), 0.0F);
  const auto squares = [&](const MatrixTable& table) {
    difference.indirect = table.copies(difference.indirect_shape);
    double sum = 0.0;
    for (const LightCoefficients& light : lights) {
      const std::vector<double> seen = seen_squares(TransferredRadiance(difference, light), mesh_);
      sum = std::accumulate(seen.begin(), seen.end(), sum);
    }
    return sum;
  };
  const double after = squares(whole);
  const double before = squares(local);
  return before > 0.0 ? std::max(1.0, std::sqrt(after / before)) : 1.0;
}

double Rehearsal::spread(const std::vector<LightCoefficients>& lights) const {
  if (!asked_.kind->has_bounces()) return 1.0;
  if (asked_.kind->indirect != nullptr) return spread_between_lobes(lights);
  const std::size_t vertices = mesh_.positions.size();
  const TransferShape shape = asked_.kind->shape(asked_.degree);
  Panel difference(vertices, kChannels * lights.size());
  std::vector<float> row(shape.length());
  for (std::size_t v = 0; v < vertices; ++v) {
    as_array(row) = as_array(&coarse(0)[v * row.size()], row.size()) - as_array(&coarse(1)[v * row.size()], row.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      as_array(difference.row(v) + kChannels * i, kChannels) =
          integral_with(row.data(), shape.channels, lights[i]).array();
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
