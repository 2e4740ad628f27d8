// Plans a bake: decides which work and which numbers it can leave out. Each decision states its savings and the error
// that it introduces. Errors are errors of exit radiance, RMS over the vertices. They are relative to the largest exit
// radiance of the unshadowed mesh under the declared lights (any vertex, any channel). A bound holds for every vertex,
// and so for the RMS. The reference is a bake of the requested degree and kind with converged directions, under the
// declared lights as a whole, with all rotations that PlanOptions allows. The loss by the requested degree itself is
// reported separately and not counted.
//   analytic    vertices with nothing above their horizon: closed form, no rays (prt/plan/open_vertices.hpp)
//   bounces     none, or a looser tolerance, if little light comes back
//   channels    one, if every albedo is gray
//   bands       a lower degree, if the sum of |T_l| |L_l| over the omitted bands is small [Sloan, Kautz, Snyder 2002]
//   symmetry    only the coefficients that the lights have
//   storage     half or 8 bits
//   directions  the fewest whose error fits; it is measured on a probe and fitted by a power law
// A plan without a budget takes only `analytic` and `channels`, which change no number under any light.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Bytes of the transfer section of the file, and number of rays of the bake: about half the directions of every vertex
/// that needs rays and, with bounces, also the rays that find closest hits.
struct PlanCost {
  std::int64_t bytes = 0;
  std::int64_t rays = 0;
};

/// The work and the numbers that a bake leaves out.
struct Plan {
  PlanRecord record;
  std::vector<std::uint8_t> open;  // (vertices), or empty: 1 if nothing blocks the vertex, so that it needs no rays
  Storage storage;
  std::vector<float> largest;  // (bands^2) largest numbers for which the storage was chosen; empty if irrelevant
  double reference = 0.0;      // W m^-2 sr^-1; 0 if no error was requested
  double beyond = 0.0;  // bound on the relative radiance that bands of the lights above the requested degree would add
  PlanCost asked;
  PlanCost planned;
};

/// Makes a plan according to scene.plan and lowers scene.bake to follow it. `instruction_set` is as in Tracer. Runs on
/// the threads of the caller's arena. Throws std::invalid_argument, one line, for a budget that cannot be met (the line
/// names one that can), for lights that leave the mesh dark, and for unknown names of decisions.
Plan make_plan(Scene& scene, const std::string& instruction_set);

/// A table with one row for each decision and its reason below it.
std::string plan_text(const Plan& plan, const Scene& scene);

/// The same as JSON. `scene` is the scene that follows the plan.
std::string plan_json(const Plan& plan, const Scene& scene);

}  // namespace sh::prt
