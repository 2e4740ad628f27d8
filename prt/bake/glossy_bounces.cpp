#include "prt/bake/glossy_bounces.hpp"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/bake/fill_closed.hpp"
#include "prt/bake/glossy_exit.hpp"
#include "prt/chunks.hpp"
#include "prt/rays/row_sums.hpp"

namespace sh::prt {

namespace {

constexpr int kBouncesBeforeJudgment = 8;
constexpr double kMostBounces = 300.0;

class Bounces {
 public:
  Bounces(const RaySetup& rays, const ShadowResult& found, const std::vector<std::uint8_t>& open,
          std::size_t bounce_memory)
      : rays_(rays),
        mesh_(rays.mesh),
        open_(open),
        bounce_memory_(bounce_memory),
        transfer_(found.transfer),
        vertices_(mesh_.positions.size()),
        fill_(closed_vertices(mesh_, found.sight)),
        term_(mesh_, transfer_.degree()),
        next_(mesh_, transfer_.degree()),
        hits_(vertices_),
        tracers_([&rays] { return Gatherer(rays.mesh, rays.starts, rays.tracer, rays.along_bounces()); }) {}

  void solve(const BounceOptions& options) {
    term_.take_direct(transfer_.rows());
    trace();
    MatrixTable sum(mesh_, transfer_.degree());
    BounceReport& report = transfer_.bounces;
    report = {.solver = "series"};
    for (double before = largest_of(term_);;) {
      bounce();
      term_.values.swap(next_.values);
      ++report.applications;
      sum.add(term_);
      const double now = largest_of(term_);
      report.spectral_bound = before > 0.0 ? now / before : 0.0;
      report.residual = now * report.spectral_bound / std::max(1.0 - report.spectral_bound, 1e-9);
      if (is_done(options)) break;
      before = now;
    }
    report.largest = largest_of(sum);
    transfer_.indirect_shape = glossy_matrix_shape(mesh_, sum.degree);
    transfer_.indirect = sum.copies(transfer_.indirect_shape);
  }

 private:
  // Keeps as many hits as the memory for bounces allows; the others are traced again for each bounce.
  void trace() {
    output::Progress progress("hits", vertices_);
    std::atomic<std::size_t> bytes{0};
    kept_.assign(vertices_, 0);
    for_vertices(vertices_, [&](std::size_t v) {
      output::check_interrupt();
      if (is_open(v)) {
        kept_[v] = 1;
      } else if (bytes < bounce_memory_) {
        hits_[v] = rays_to_fronts(tracers_.local(), v);
        kept_[v] = 1;
        bytes += hits_[v].size() * sizeof(BlockedAt);
      }
      progress.advance();
    });
    progress.finish();
  }

  [[nodiscard]] bool is_open(std::size_t vertex) const { return !open_.empty() && open_[vertex] != 0; }

  // next = K term; overwrites the term.
  void bounce() {
    const GlossyExit leaving(mesh_, term_);
    output::Progress progress(fmt::format("bounce {}", transfer_.bounces.applications + 1), vertices_);
    for_vertices(vertices_, [&](std::size_t v) {
      output::check_interrupt();
      const std::vector<BlockedAt> again =
          kept_[v] != 0 ? std::vector<BlockedAt>() : rays_to_fronts(tracers_.local(), v);
      leaving.collect(kept_[v] != 0 ? hits_[v] : again, rays_.along_bounces().size(), next_.of(v));
      progress.advance();
    });
    progress.finish();
    fill_.apply(next_.values.data(), next_.size, next_.size);
  }

  [[nodiscard]] double largest_of(const MatrixTable& table) const {
    std::vector<float> largest(chunk_count(vertices_), 0.0F);
    for_chunks(vertices_, [&](std::size_t chunk) {
      const VertexRange range = chunk_range(chunk, vertices_);
      largest[chunk] =
          as_array(table.of(range.first), range.size() * table.size).abs().maxCoeff<Eigen::PropagateNumbers>();
    });
    return static_cast<double>(*std::max_element(largest.begin(), largest.end()));
  }

  // No number of the direct part is above 1.
  [[nodiscard]] bool is_done(const BounceOptions& options) const {
    const BounceReport& report = transfer_.bounces;
    const double rate = report.spectral_bound;
    const double enough = options.tolerance;
    if (rate < 1.0 && report.residual <= enough) return true;
    if (report.applications >= options.most_applications) return true;
    if (std::chrono::steady_clock::now() >= options.deadline) return true;
    const double left = rate < 1.0 ? std::log(enough / report.residual) / std::log(rate) : kMostBounces;
    if (report.applications >= kBouncesBeforeJudgment && report.applications + left > kMostBounces) {
      throw std::runtime_error(
          fmt::format("{}: its bounces shrink to only {:.4f} of the one before: surfaces that reflect nearly all light "
                      "enclose it; expected lower reflectances{} a larger opening",
                      transfer_.scene, rate, rays_.bounce_directions ? ", more bounce_directions or" : " or"));
    }
    return false;
  }

  const RaySetup& rays_;
  const Mesh& mesh_;
  const std::vector<std::uint8_t>& open_;
  std::size_t bounce_memory_;
  Transfer& transfer_;
  std::size_t vertices_;
  Fill fill_;
  MatrixTable term_;
  MatrixTable next_;
  std::vector<std::vector<BlockedAt>> hits_;
  std::vector<std::uint8_t> kept_;
  tbb::enumerable_thread_specific<Gatherer> tracers_;
};

}  // namespace

std::size_t glossy_bounce_bytes(const Mesh& mesh, int degree) {
  constexpr std::size_t kTables = 4;  // the sum, two terms, the result
  const TransferShape shape = glossy_matrix_shape(mesh, degree);
  const std::size_t row = padded_row(shape.channels * shape.columns());
  return kTables * mesh.positions.size() * shape.rows() * row * sizeof(float);
}

void require_glossy_bounce_memory(const Scene& scene, double there) {
  const auto needed = static_cast<double>(glossy_bounce_bytes(scene.mesh, scene.bake.degree));
  if (needed <= there) return;
  constexpr double kMiB = 1048576.0;
  throw std::runtime_error(
      fmt::format("{}: its bounces need {:.0f} MiB for a matrix at each of {} vertices, this machine has {:.0f}; "
                  "expected fewer vertices, a lower degree, gray materials, or {}",
                  scene.name, needed / kMiB, scene.mesh.positions.size(), there / kMiB, kGlossyShadowed.word));
}

void solve_glossy_bounces(const RaySetup& rays, const ShadowResult& found, const std::vector<std::uint8_t>& open,
                          std::size_t bounce_memory, const BounceOptions& options) {
  Bounces(rays, found, open, bounce_memory).solve(options);
}

void add_glossy_bounces(BakeRun& run) {
  const BakeOptions& options = run.scene.bake;
  solve_glossy_bounces(*run.rays, *run.found, run.open, run.settings.bounce_memory, options.bounces);
  run.transfer.bounces.directions = static_cast<std::uint32_t>(options.fewer_for_bounces());
}

}  // namespace sh::prt
