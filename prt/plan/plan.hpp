// Plans a bake: decides which work and which numbers it can leave out. Each decision states its savings and the error
// that it introduces. Errors are errors of exit radiance, RMS over the vertices. They are relative to the largest exit
// radiance of the unshadowed mesh under the declared lights (any vertex, any channel). The reference is a bake of the
// requested degree and kind with converged directions, under the declared lights as a whole, with all rotations that
// PlanOptions allows. Errors of glossy kinds are RMS over the eyes, too (prt/plan/views.hpp). The loss by the requested
// degree itself is reported separately and not counted.
//   receivers   fewer vertices on faces that were split, where interpolation between them adds little; diffuse kinds
//               (prt/plan/decide_receivers.cpp)
//   analytic    vertices with nothing above their horizon: closed form, no rays (prt/plan/open_vertices.hpp)
//   bounces     none, or a looser tolerance, if little light comes back
//   channels    one, if every albedo is gray
//   bands       a lower degree, if the omitted bands add little
//   matrices    fewer rows or columns, if the bands of them add little (prt/transfer/kept_bands.hpp)
//   visibility  the lower bands, if the others add little
//   symmetry    only the coefficients that the lights have; diffuse kinds only
//   storage     half or 8 bits
//   clusters    those that the scene asks for, or the fewest of some counts for which the bake finds that they lose
//               little; only if it asks
//   directions  the fewest for which the error of all decisions together stays within the budget
// A bound holds for every vertex, and so for the RMS. What is measured holds with a confidence, on a probe of vertices
// (prt/plan/measure.hpp). The error of the plan as a whole is measured, too: the planned bake of the probe against the
// reference. If the user skips `directions`, the reference has the same directions.
// A plan without a budget takes only `analytic` and `channels`, which change no number under any light.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Bytes of the transfer section of the file, and number of rays of the bake: the directions above the horizon of every
/// vertex that needs rays. With a budget also the rays that find closest hits, as counted in coarse bakes.
struct PlanCost {
  std::int64_t bytes = 0;
  std::int64_t rays = 0;
};

inline constexpr std::string_view kReceiversDecision = "receivers";
inline constexpr std::string_view kClustersDecision = "clusters";

/// The work and the numbers that a bake leaves out.
struct Plan {
  PlanRecord record;
  std::vector<std::uint8_t> receivers;  // (vertices of the asked mesh), or empty: 1 if the bake keeps the vertex
  std::vector<std::uint8_t> open;  // (vertices), or empty: 1 if nothing blocks the vertex, so that it needs no rays
  Storage storage;
  std::vector<float> largest;  // (bands^2) largest numbers for which the storage was chosen; empty if irrelevant
  std::vector<ClusterCounts> clusters;    // that a bake tries in turn, bytes rising, until one loses little enough
  std::vector<LightCoefficients> lights;  // the declared ones, turned, for which errors are measured; empty without
  std::string known_by;    // how the error of all decisions together is known; empty: it is the sum of bounds
  double reference = 0.0;  // W m^-2 sr^-1; 0 if no error was requested
  double beyond = 0.0;  // bound on the relative radiance that bands of the lights above the requested degree would add
  PlanCost asked;
  PlanCost planned;
};

/// Makes a plan according to scene.plan and lowers scene.bake to follow it, and scene.mesh if it keeps fewer receivers. `instruction_set` is as in Tracer. Runs on
/// the threads of the caller's arena. Throws std::invalid_argument, one line, for a budget that cannot be met (the line
/// names one that can), for lights that leave the mesh dark, and for unknown names of decisions.
Plan make_plan(Scene& scene, const std::string& instruction_set);

/// A table with one row for each decision and its reason below it.
std::string plan_text(const Plan& plan, const Scene& scene);

/// The same as JSON. `scene` is the scene that follows the plan.
std::string plan_json(const Plan& plan, const Scene& scene);

}  // namespace sh::prt
