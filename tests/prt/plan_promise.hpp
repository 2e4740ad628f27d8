// The error that a plan costs, measured as prt/plan/plan.hpp defines it: exit radiance of a planned bake against a full
// bake, RMS over the vertices and the eyes that see them, largest channel, worst turn of the light, relative to the plan's
// reference radiance. The eyes stand far off all around, which are others than those of plans.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/chunks.hpp"
#include "prt/light/light.hpp"
#include "prt/mesh/keep_vertices.hpp"
#include "prt/rays/directions.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt::test {

/// Eight turns of a kind that a plan may allow; only the first of them if the light does not turn.
inline std::vector<Eigen::Matrix3d> turns_of(LightTurns turns) {
  std::vector<Eigen::Matrix3d> rotations = {Eigen::Matrix3d::Identity()};
  for (int k = 1; k < 8 && turns != LightTurns::kNone; ++k) {
    rotations.push_back(
        rotation_about(turns == LightTurns::kAny ? Eigen::Vector3d(k, 3 - k, 1) : Eigen::Vector3d::UnitZ(), 50.0 * k));
  }
  return rotations;
}

/// The colors of all vertices of the asked mesh, from those of the receivers that a plan keeps; all of them if it has none.
inline std::vector<Eigen::Vector3f> shown(const Mesh& asked, const std::vector<std::uint8_t>& receivers,
                                          const std::vector<Eigen::Vector3f>& colors) {
  if (receivers.empty()) return colors;
  return shown_by_kept(asked.halving, ends_first(asked.halving), receivers, colors);
}

/// The square of the difference of exit radiance for each vertex.
inline std::vector<double> squares_between(const Transfer& planned, const Transfer& full,
                                           const LightCoefficients& light, const Mesh& asked,
                                           const std::vector<std::uint8_t>& receivers) {
  const LightCoefficients low = first_bands(light, planned.degree());
  std::vector<double> squares(full.mesh.positions.size(), 0.0);
  if (!full.kind->is_glossy()) {
    const auto a = shown(asked, receivers, relight(planned, low));
    const auto b = relight(full, light);
    for (std::size_t v = 0; v < a.size(); ++v) {
      squares[v] = std::pow(static_cast<double>((a[v] - b[v]).cwiseAbs().maxCoeff()), 2);
    }
    return squares;
  }
  static const std::vector<Eigen::Vector3f> eyes = make_directions(Sampler::kFibonacci, 256);
  const TransferredRadiance a(planned, low);
  const TransferredRadiance b(full, light);
  const Mesh& mesh = full.mesh;
  for_vertices(squares.size(), [&](std::size_t v) {
    const Material material = material_of(mesh, v, mesh.albedo[v]);
    double weights = 0.0;
    for (const Eigen::Vector3f& eye : eyes) {
      const auto weight = static_cast<double>(std::max(0.0F, mesh.geometric_normals[v].dot(eye)));
      if (weight == 0.0) continue;
      const Eigen::Vector3f difference = exit_radiance(material, a.degree(), a.at(v), mesh.normals[v], eye) -
                                         exit_radiance(material, b.degree(), b.at(v), mesh.normals[v], eye);
      squares[v] += weight * std::pow(static_cast<double>(difference.cwiseAbs().maxCoeff()), 2);
      weights += weight;
    }
    squares[v] /= weights;
  });
  return squares;
}

inline double measured_error(const Scene& scene, const Transfer& planned, const Transfer& full, LightTurns turns,
                             const Plan& plan) {
  const LightCoefficients light = project(load_lights(scene.lights, OnFlaw::kMend), full.degree());
  double worst = 0.0;
  for (const Eigen::Matrix3d& r : turns_of(turns)) {
    const std::vector<double> all = squares_between(planned, full, turned(light, r), scene.mesh, plan.receivers);
    const double squares = std::accumulate(all.begin(), all.end(), 0.0);
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(all.size())));
  }
  return worst / plan.reference;
}

/// The transfer as a file keeps it.
inline Transfer stored(Transfer transfer) {
  transfer.coefficients = decode(encode(transfer.coefficients, transfer.shape), transfer.shape);
  if (transfer.indirect.empty()) return transfer;
  transfer.indirect = decode(encode(transfer.indirect, transfer.indirect_shape), transfer.indirect_shape);
  return transfer;
}

/// A bake that leaves nothing out, of `directions` directions, or of the scene's if 0.
inline Transfer full_bake(const Scene& scene, int directions = 0) {
  Scene asked = scene;
  asked.plan.mode = PlanMode::kNone;
  asked.bake.directions = directions > 0 ? directions : scene.bake.directions;
  return bake(asked);
}

/// The job with its plan.
inline BakeJob planned_as(Scene scene, const PlanOptions& options, const BakeSettings& settings = {}) {
  scene.plan = options;
  return planned({std::move(scene), settings});
}

}  // namespace sh::prt::test
