// The error that a plan costs, measured as prt/plan/plan.hpp defines it: exit radiance of a planned bake against a full
// bake, RMS over the vertices, largest channel, worst turn of the light, relative to the plan's reference radiance.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/light/light.hpp"
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

inline double measured_error(const Scene& scene, const Transfer& planned, const Transfer& full, LightTurns turns,
                             double reference) {
  const LightCoefficients light = project(load_lights(scene.lights, OnFlaw::kMend), full.degree());
  double worst = 0.0;
  for (const Eigen::Matrix3d& r : turns_of(turns)) {
    const LightCoefficients turned_light = turned(light, r);
    const auto a = relight(planned, first_bands(turned_light, planned.degree()));
    const auto b = relight(full, turned_light);
    double squares = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      squares += std::pow(static_cast<double>((a[v] - b[v]).cwiseAbs().maxCoeff()), 2);
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(a.size())));
  }
  return worst / reference;
}

/// The transfer as a file keeps it.
inline Transfer stored(Transfer transfer) {
  transfer.coefficients = decode(encode(transfer.coefficients, transfer.shape), transfer.shape);
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
