#include "prt/bake/bake.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "numeric/output/progress.hpp"
#include "prt/bake/bake_run.hpp"
#include "prt/bake/chunks.hpp"
#include "prt/bake/colored_mirrors.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/plan/plan.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {

namespace {

void check(const BakeJob& job) {
  const BakeOptions& options = job.scene.bake;
  if (options.degree < 0 || options.degree > kMaxDegree) {
    throw std::invalid_argument(fmt::format("degree: expected 0 to {}, got {}", kMaxDegree, options.degree));
  }
  if (job.settings.threads < 0) {
    throw std::invalid_argument(fmt::format("threads: expected 0 (every core) or more, got {}", job.settings.threads));
  }
  const Mesh& mesh = job.scene.mesh;
  if (mesh.faces.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: the mesh has no faces, expected at least one triangle", job.scene.name));
  }
  if (job.plan && !job.plan->open.empty() && job.plan->open.size() != mesh.positions.size()) {
    throw std::invalid_argument(
        fmt::format("{} marks of open vertices for {} vertices", job.plan->open.size(), mesh.positions.size()));
  }
}

Transfer run_steps(const Scene& scene, const BakeSettings& settings, const Plan& plan, BakeReport& report) {
  BakeRun run(scene, settings, plan.open);
  try {
    for (const BakeStep& step : scene.bake.kind->steps) step.run(run);
  } catch (const output::Interrupted&) {
    if (!run.checkpoint) throw;
    throw output::Interrupted(run.checkpoint->interrupted());
  }
  if (run.rays) {
    report.rays += run.rays->tracer.rays();
    report.checkpoint = settings.checkpoint.path;
  }
  return std::move(run.transfer);
}

Transfer run_steps(const BakeJob& job, BakeReport& report) {
  if (!job.scene.bake.kind->traces_rays() || !has_colored_mirrors(job.scene.mesh)) {
    return run_steps(job.scene, job.settings, *job.plan, report);
  }
  BakeSettings part = job.settings;
  part.checkpoint = {};  // it holds one bake
  return bake_by_channel(job.scene, [&](const Scene& grey) { return run_steps(grey, part, *job.plan, report); });
}

void say_estimate(const BakeEstimate& estimate, const BakeObserver& say) {
  constexpr double kWorthSaying = 2.0;  // seconds
  if (estimate.seconds() >= kWorthSaying) {
    say(fmt::format("about {:.2g} s, {:.0f} MiB: {:.3g} million rays{}", estimate.seconds(),
                    static_cast<double>(estimate.bytes) / 1048576.0, estimate.rays * 1e-6,
                    estimate.bounces > 0.0 ? fmt::format(", {:.0f} bounces", estimate.bounces) : ""));
  }
}

// Sets fewer directions and a deadline for the bounces if there is a budget.
void prepare(BakeJob& job, const BakeObserver& say) {
  if (!job.scene.bake.kind->traces_rays() || (!say && !job.budget)) return;
  const BakeEstimate estimate = estimate_bake(job);
  if (say) say_estimate(estimate, say);
  if (!job.budget) return;
  const auto& [seconds, spent] = *job.budget;
  const int wanted = job.scene.bake.directions;
  job.scene.bake = within_budget(job.scene.bake, estimate, seconds - spent.seconds());
  job.scene.bake.bounces.deadline = spent.after(seconds);
  if (say && job.scene.bake.directions < wanted) {
    say(fmt::format("{} of {} directions fit into {} s", job.scene.bake.directions, wanted, seconds));
  }
}

bool fits(const Transfer& transfer, const std::vector<float>& largest) {
  for (std::size_t i = 0; i < transfer.coefficients.size(); ++i) {
    if (std::abs(transfer.coefficients[i]) > largest[i % largest.size()]) return false;
  }
  return true;
}

void take_plan(const Plan& plan, Transfer& transfer) {
  transfer.plan = plan.record;
  transfer.shape.storage = plan.storage;
  if (plan.storage.element == Element::kByte && !fits(transfer, plan.largest)) {
    transfer.shape.storage.element = Element::kHalf;  // an outlier would coarsen every other number of its column
  }
}

}  // namespace

Transfer bake(BakeJob job, BakeReport* report, const BakeObserver& say) {
  check(job);
  if (!job.plan) job = planned(std::move(job));
  const BakeOptions wanted = job.scene.bake;
  prepare(job, say);
  Transfer transfer;
  BakeReport measured;
  on_threads(job.settings.threads, [&] { transfer = run_steps(job, measured); });
  take_plan(*job.plan, transfer);
  transfer.missing = shortfall(wanted, transfer);
  if (report != nullptr) *report = measured;
  return transfer;
}

Transfer bake_to_file(const std::string& file, BakeJob job, BakeReport* report, const BakeObserver& say) {
  BakeReport measured;
  Transfer transfer = bake(std::move(job), &measured, say);
  write_transfer(file, transfer);
  if (!measured.checkpoint.empty()) std::filesystem::remove(measured.checkpoint);
  if (report != nullptr) *report = measured;
  return transfer;
}

}  // namespace sh::prt
