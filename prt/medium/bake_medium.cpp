#include "prt/medium/bake_medium.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/output/stopwatch.hpp"
#include "prt/bake/bounces.hpp"
#include "prt/bake/estimate.hpp"
#include "prt/bake/steps.hpp"
#include "prt/medium/anisotropic.hpp"
#include "prt/medium/medium_grid.hpp"
#include "prt/medium/scattering.hpp"
#include "prt/rays/tracer.hpp"

namespace sh::prt {
namespace {

constexpr double kMiB = 1048576.0;
constexpr double kThickest = 200.0;  // exp(-200) of the light is left

bool is_gray(const Medium& medium) { return (medium.albedo.array() == medium.albedo[0]).all(); }

Scattering scattering_of(const Scene& scene) {
  return {scene.medium->extinction, medium_directions(directions_along(scene.bake.directions))};
}

// The panels of a solver of bounces, or the tables of orders, and the transfer.
std::size_t table_bytes(const Scene& scene) {
  constexpr std::size_t kPanels = 8;
  const std::size_t voxels = scene.medium->extinction.size();
  const std::size_t count = coefficient_count(scene.bake.degree);
  if (scene.medium->anisotropy != 0.0) return anisotropic_bytes(voxels, scene.bake.degree);
  return voxels *
         (kPanels * Panel(1, BounceLayout{count}.columns()).columns * sizeof(double) + 7 * count * sizeof(float));
}

void check(const Scene& scene) {
  require_degree(scene.bake.degree);
  constexpr int kFewest = 24;
  if (scene.bake.directions < kFewest || scene.bake.directions > kMostMediumDirections) {
    throw std::invalid_argument(fmt::format("{}: directions of a medium: expected {} to {}, got {}", scene.name,
                                            kFewest, kMostMediumDirections, scene.bake.directions));
  }
  const std::vector<float>& values = scene.medium->extinction.values;
  const double thickest = values.empty() ? 0.0
                                         : static_cast<double>(*std::max_element(values.begin(), values.end())) *
                                               scene.medium->extinction.spacing.maxCoeff();
  if (thickest > kThickest) {
    throw std::runtime_error(
        fmt::format("{}: its densest voxels are {:.3g} mean free paths thick, too thick to tell what gets through; "
                    "expected at most "
                    "{:g}: a lower extinction or more voxels",
                    scene.name, thickest, kThickest));
  }
  const auto needed = static_cast<double>(table_bytes(scene));
  const double there = memory_of_machine();
  if (needed <= there) return;
  const auto voxels = static_cast<double>(scene.medium->extinction.size());
  throw std::runtime_error(fmt::format(
      "{}: its medium of {} voxels needs {:.0f} MiB, this machine has {:.0f}; expected at most {:.0f} voxels, "
      "or a lower degree",
      scene.name, voxels, needed / kMiB, there / kMiB, std::floor(voxels * there / needed)));
}

// A solution without a digit that is proved is refused.
void check(const BounceReport& report, const std::string& name) {
  if (report.bound <= report.largest) return;
  throw std::runtime_error(
      fmt::format("{}: the light that scatters has no sum that can be told (residual {:.2g} after {} applications): it "
                  "is too thick "
                  "for its albedo; expected a lower extinction or albedo",
                  name, report.residual, report.applications));
}

// One order of scattering of every voxel, then all of them: three channels with the albedo.
void scatter(const Scene& scene, const Scattering& scattering, std::size_t bounce_memory, Transfer& transfer) {
  const Medium& medium = *scene.medium;
  Mesh voxels;  // what the solver takes of a mesh: how many receivers there are, and their albedo
  voxels.positions.resize(medium.extinction.size());
  voxels.albedo.assign(medium.extinction.size(), medium.albedo);
  Transfer solved = Transfer::of(kMedium, scene.bake.degree);
  solved.shape.channels = 1;
  solved.coefficients = scattering.direct(scene.bake.degree);
  const BounceLayout layout{solved.shape.count()};
  Panel x = direct_light(voxels, solved, layout);
  solved.bounces =
      solve_bounces(scattering.between_voxels(bounce_memory), voxels.albedo, layout, x, scene.bake.bounces);
  check(solved.bounces, scene.name);
  take_solution(x, layout, solved);
  transfer.shape = solved.shape;
  transfer.coefficients = std::move(solved.coefficients);
  transfer.bounces = solved.bounces;
}

// Receivers are voxels on input, the points of the grid on output.
void add_border(const Density& density, Transfer& transfer) {
  const PaddedDensity padded(density);
  GridOfMedium points(density);
  const std::size_t length = transfer.shape.length();
  const std::vector<float> voxels = std::move(transfer.coefficients);
  transfer.coefficients.resize(points.grid.points() * length);
  for (std::size_t point = 0; point < points.grid.points(); ++point) {
    std::copy_n(&voxels[padded.voxel(point) * length], length, transfer.row(point));
  }
  transfer.grid = points.grid;
  transfer.density = std::move(points.density);
}

}  // namespace

MediumEstimate estimate_medium(const Scene& scene, std::size_t bounce_memory) {
  check(scene);
  const Density& density = scene.medium->extinction;
  const output::Stopwatch stopwatch;
  const Scattering scattering = scattering_of(scene);
  const SampledRows rows = scattering.sample(0.05);
  MediumEstimate estimate{density.size(), scattering.directions().size(), table_bytes(scene), stopwatch.seconds()};
  const double all = static_cast<double>(density.size()) / static_cast<double>(rows.count);
  estimate.seconds += rows.seconds * all;
  if (scene.medium->anisotropy == 0.0) {
    estimate.bytes += std::min(bounce_memory, static_cast<std::size_t>(static_cast<double>(rows.bytes) * all));
  }
  return estimate;
}

Transfer bake_medium(const Scene& scene, std::size_t bounce_memory) {
  check(scene);
  const Medium& medium = *scene.medium;
  const Scattering scattering = scattering_of(scene);
  Transfer transfer = Transfer::of(kMedium, scene.bake.degree);
  transfer.scene = scene.name;
  transfer.instruction_set = choose_instruction_set();  // exp() rounds differently on others
  std::copy_n(medium.albedo.data(), 3, transfer.medium.albedo.begin());
  transfer.medium.anisotropy = medium.anisotropy;
  transfer.medium.directions = static_cast<std::uint32_t>(scattering.directions().size());
  if (medium.anisotropy == 0.0) {
    scatter(scene, scattering, bounce_memory, transfer);
  } else {
    AnisotropicLight light =
        scatter_anisotropically(scattering, medium, scene.bake.degree, scene.bake.bounces, scene.name);
    transfer.shape.result_degree = scene.bake.degree;
    transfer.coefficients = std::move(light.rows);
    transfer.bounces = light.report;
  }
  transfer.shape.storage.one_channel = is_gray(medium);
  add_border(medium.extinction, transfer);
  return transfer;
}

}  // namespace sh::prt
