// What a bake of a scene can leave out, decided before it: each decision with what it saves and an error it costs.
// Errors are of exit radiance, relative to the largest that the mesh would have unshadowed under the declared lights
// (any vertex, any channel), RMS over the vertices; a bound holds for every vertex, and so for their RMS. They are
// against a bake of the asked degree and kind with converged directions, under the declared lights as a whole, turned
// as PlanOptions says. What the asked degree itself leaves out of the lights is said beside, and not counted.
//   analytic    vertices above whose horizon nothing lies: closed form, no rays (prt/plan/open_vertices.hpp) bounces
//   none, or a looser tolerance, where little light comes back channels    one, where every albedo is grey bands a
//   lower degree, where |T_l| |L_l| summed over the bands left out is small [Sloan, Kautz, Snyder 2002] symmetry only
//   the coefficients that the lights have storage     half or 8 bits directions  the fewest whose error, measured on a
//   probe and fitted by a power of their number, fits
// Without a budget only analytic and channels are taken, which change no number under any light.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/scene/plan_options.hpp"
#include "prt/scene/scene.hpp"

namespace sh::prt {

/// Of the transfer section of the file, and of the bake's rays (about half the directions of every vertex that needs
/// any; with bounces also those that find closest hits).
struct PlanCost {
  std::int64_t bytes = 0;
  std::int64_t rays = 0;
};

struct Plan {
  PlanRecord record;
  BakeOptions bake;                // in place of the scene's
  std::vector<std::uint8_t> open;  // (vertices), or empty
  Storage storage;
  std::vector<float> largest;  // (bands^2) that the storage was chosen for; empty where it does not matter
  double reference = 0.0;      // W m^-2 sr^-1; 0 where no error was asked for
  double beyond = 0.0;  // bound on what bands of the lights above the asked degree, up to 10, would add; relative
  PlanCost asked;
  PlanCost planned;
};

/// Throws std::invalid_argument, one line, for a budget that cannot be met (it says what can), lights that leave the
/// mesh dark, and names that are no decisions. `settings`: threads and instruction set.
Plan make_plan(const Scene& scene, const PlanOptions& options, const BakeSettings& settings = {});

/// Bakes the scene by the plan; the transfer names its decisions. A storage type that a number does not fit after all
/// gives way to the next wider one. Else as bake().
Transfer bake_planned(const Scene& scene, const Plan& plan, BakeSettings settings = {}, BakeReport* report = nullptr);

}  // namespace sh::prt
