// The step `bounce`: makes the right sides of the bounces from shadowed vectors, and interreflected vectors from the
// solution.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "prt/bake/bake_run.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/steps.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kChannels = BounceLayout::kChannels;

// The light that leaves every vertex without bounces: albedo * T, and the emission.
Panel direct_light(const Mesh& mesh, const Transfer& transfer, const BounceLayout& layout) {
  Panel x(mesh.positions.size(), layout.columns());
  for (std::size_t v = 0; v < x.rows; ++v) {
    const float* direct = transfer.row(v);
    for (std::size_t c = 0; c < kChannels; ++c) {
      const auto channel = static_cast<Eigen::Index>(c);
      const auto albedo = static_cast<double>(mesh.albedo[v][channel]);
      double* own = std::transform(direct, direct + transfer.shape.count(), x.row(v) + layout.channel(c),
                                   [albedo](float value) { return albedo * static_cast<double>(value); });
      if (layout.emitted > 0) *own = static_cast<double>(mesh.emission[v][channel]);
    }
  }
  return x;
}

void take_solution(const Panel& x, const BounceLayout& layout, Transfer& transfer) {
  transfer.shape = transfer.kind->shape(transfer.degree());
  transfer.coefficients.resize(x.rows * transfer.shape.length());
  float* out = transfer.coefficients.data();
  for (std::size_t v = 0; v < x.rows; ++v) {
    for (std::size_t c = 0; c < kChannels; ++c) {
      const double* values = x.row(v) + layout.channel(c);
      out = std::transform(values, values + transfer.shape.count(), out,
                           [](double value) { return static_cast<float>(value); });
      if (layout.emitted > 0) {
        transfer.emitted[v][static_cast<Eigen::Index>(c)] = static_cast<float>(values[transfer.shape.count()]);
      }
    }
  }
}

}  // namespace

void add_bounces(BakeRun& run) {
  const Scene& scene = run.scene;
  Transfer& transfer = run.transfer;
  const std::size_t emitted = scene.mesh.emission.empty() ? 0 : 1;
  const BounceLayout layout{transfer.shape.count() + emitted, emitted};
  Panel x = direct_light(scene.mesh, transfer, layout);
  transfer.bounces = solve_bounces(*run.factors, scene.mesh.albedo, layout, x, scene.bake.bounces);
  take_solution(x, layout, transfer);
  if (!transfer.bounces.certified && std::chrono::steady_clock::now() < scene.bake.bounces.deadline) {
    report_flaw(
        run.settings.on_flaw,
        fmt::format("{}: bounces did not converge within {} (residual {:.2g} after {} applications): surfaces of "
                    "albedo 1 enclose light (kept as it is)",
                    scene.name, scene.bake.bounces.tolerance, transfer.bounces.residual,
                    transfer.bounces.applications));
  }
}

}  // namespace sh::prt
