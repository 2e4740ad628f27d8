#include "prt/translucent/bake_translucent.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "numeric/output/progress.hpp"
#include "prt/arrays.hpp"
#include "prt/bake/gray.hpp"
#include "prt/chunks.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/translucent/body_rays.hpp"
#include "prt/translucent/dipole.hpp"
#include "prt/translucent/surface_scatter.hpp"

namespace sh::prt {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}: {}", scene.name, why));
}

// The part of a constant irradiance that a flat, thick body gives back in one color.
double reflectance_of(const Translucence& material, int color) {
  return Dipole(static_cast<double>(material.absorption[color]), static_cast<double>(material.scattering[color]),
                static_cast<double>(material.ior))
      .of_plane(0.0);
}

// The most that a surface of this albedo sends of the light that arrives on its front and behind it: at most all of it.
void check_energy(const Scene& scene) {
  const Mesh& mesh = scene.mesh;
  constexpr double kRounding = 1e-6;
  std::vector<Eigen::Array3d> passed;
  for (const Translucence& material : mesh.translucences.heads) {
    passed.emplace_back(material.transmission.cast<double>().array());
    if (!material.scatters()) continue;
    for (int c = 0; c < 3; ++c) passed.back()[c] = reflectance_of(material, c);
  }
  for (std::size_t v = 0; v < mesh.translucence.size(); ++v) {
    if (mesh.translucence[v] == 0) continue;
    Eigen::Array3d all = mesh.albedo[v].cast<double>().array() + passed[mesh.translucence[v] - 1U];
    if (!mesh.mirror.empty()) all += mesh.mirror[v].cast<double>().array();
    const double sum = all.maxCoeff();
    if (sum > 1.0 + kRounding) {
      refuse(scene, fmt::format("albedo, mirror and light from the body make {:.4g} together; expected at most 1: a "
                                "lower albedo beside a translucent material",
                                sum));
    }
  }
}

// R_d is resolved down to some 1e-12 of an edge (prt/translucent/surface_scatter.cpp).
void check_lengths(const Scene& scene) {
  constexpr double kShortest = 1e-9;
  const Mesh& mesh = scene.mesh;
  const double extent = mesh.frame.unit * static_cast<double>(bounding_box(mesh.positions).sizes().maxCoeff());
  for (const Translucence& material : mesh.translucences.heads) {
    const double rate = static_cast<double>((material.absorption + material.scattering).maxCoeff());
    if (material.scatters() && !(rate * kShortest * extent <= 1.0)) {
      refuse(scene,
             fmt::format("light scatters within {:.2g}, less than {:g} of the scene's extent; expected an albedo in "
                         "place of `subsurface`",
                         1.0 / rate, kShortest));
    }
  }
}

void check_mesh(const Scene& scene) {
  if (scene.mesh.faces.empty()) refuse(scene, "the mesh has no faces, expected at least one triangle");
  if (scene.bake.degree < 0 || scene.bake.degree > kMaxDegree) {
    refuse(scene, fmt::format("degree: expected 0 to {}, got {}", kMaxDegree, scene.bake.degree));
  }
}

void check(const BakeJob& job) {
  const Scene& scene = job.scene;
  check_mesh(scene);
  if (scene.mesh.translucence.empty()) {
    refuse(scene, "no material is translucent; expected `translucent` or `subsurface` in a mesh or material");
  }
  if (scene.plan.mode == PlanMode::kLossy || !job.settings.plan_file.empty()) {
    refuse(scene, "light through bodies is in no plan; expected the plan none or exact");
  }
  if (scene.bake.compress.clusters > 0 || scene.bake.compress_by_plan) {
    refuse(scene, "light through bodies is stored as rows; expected no `compress`");
  }
  if (has_colored_mirrors(scene.mesh)) {
    refuse(scene, "its mirrors have colors, which shadowed transfer cannot hold; expected gray mirrors");
  }
  if (!job.settings.checkpoint.shard.is_whole() || !job.settings.checkpoint.parts.empty()) {
    refuse(scene, "light through bodies is traced in one piece; expected no shard");
  }
  check_lengths(scene);
  check_energy(scene);
}

void report_open(const BakeJob& job, const BodyRays& rays) {
  if (rays.open == 0) return;
  report_flaw(
      job.settings.on_flaw,
      fmt::format("{}: of {} of {} vertices rays leave no body ({:.2g} of their rays): surfaces that are not closed, "
                  "or fronts inside (`flip` turns a mesh)",
                  job.scene.name, rays.open, job.scene.mesh.positions.size(), rays.share));
}

// The light that the front reflects, three channels.
std::vector<float> reflected(const Mesh& mesh, const Transfer& shadowed) {
  const std::size_t count = shadowed.shape.count();
  std::vector<float> rows(mesh.positions.size() * 3 * count);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      as_array(rows.data() + (3 * v + c) * count, count) =
          mesh.albedo[v][static_cast<Eigen::Index>(c)] * as_array(shadowed.row(v), count);
    }
  }
  return rows;
}

// Those of kind DT, in the place of shadowed vectors.
void take_rows(std::vector<float> rows, Transfer& transfer) {
  const int degree = transfer.degree();
  transfer.kind = &kTranslucent;
  transfer.shape = kTranslucent.shape(degree);
  transfer.coefficients = std::move(rows);
  transfer.plan = {};  // its bytes are those of shadowed vectors
}

}  // namespace

Transfer bake_translucent(BakeJob job, BakeReport* report, const BakeObserver& say) {
  check(job);
  job.scene.bake.kind = &kShadowed;
  BakeReport measured;
  const BakeSettings settings = job.settings;
  Transfer transfer = bake(job, &measured, say);
  const Mesh& mesh = job.scene.mesh;
  const std::size_t count = transfer.shape.count();
  std::vector<float> rows = reflected(mesh, transfer);
  const auto any = [&](bool scatters) {
    return std::any_of(mesh.translucences.heads.begin(), mesh.translucences.heads.end(),
                       [&](const Translucence& material) { return material.scatters() == scatters; });
  };
  try {
    on_threads(settings.threads, [&] {
      if (any(false)) {
        const BodyRays rays = transmitted(mesh, job.scene.bake, settings.threads, settings.instruction_set);
        report_open(job, rays);
        measured.rays += rays.rays;
        as_array(rows) += as_array(rays.rows);
      }
      if (any(true)) add_scattered(mesh, transfer.coefficients, count, rows);
    });
  } catch (const output::Interrupted&) {
    if (measured.kept.empty()) throw;
    throw output::Interrupted(measured.kept);
  }
  take_rows(std::move(rows), transfer);
  if (report != nullptr) *report = measured;
  return transfer;
}

Transfer bake_thickness(BakeJob job, BakeReport* report) {
  const Scene& scene = job.scene;
  check_mesh(scene);
  Transfer transfer = Transfer::of(kThickness, scene.bake.degree);
  transfer.scene = scene.name;
  transfer.mesh = scene.mesh;
  leave_out_gloss(transfer.mesh);
  transfer.directions = static_cast<std::uint32_t>(scene.bake.directions);
  transfer.sampler = scene.bake.sampler;
  transfer.seed = scene.bake.seed;
  on_threads(job.settings.threads, [&] {
    BodyRays rays = thickness(scene.mesh, scene.bake, job.settings.threads, job.settings.instruction_set);
    report_open(job, rays);
    if (report != nullptr) report->rays = rays.rays;
    transfer.coefficients = std::move(rays.rows);
    transfer.instruction_set = rays.instruction_set;
  });
  return transfer;
}

Transfer bake_translucent_to_file(const std::string& file, BakeJob job, BakeReport* report, const BakeObserver& say) {
  BakeReport measured;
  Transfer transfer = bake_translucent(std::move(job), &measured, say);
  write_transfer(file, transfer);
  if (!measured.checkpoint.empty()) std::filesystem::remove(measured.checkpoint);
  if (report != nullptr) *report = measured;
  return transfer;
}

}  // namespace sh::prt
