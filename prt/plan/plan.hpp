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
#include "prt/bake/job.hpp"

namespace sh::prt {

/// Returns the job with its `plan`, made according to scene.plan, and with scene.bake lowered to follow it. Throws
/// std::invalid_argument, one line, for a budget that cannot be met (the line names one that can), for lights that
/// leave the mesh dark, and for unknown names of decisions.
BakeJob planned(BakeJob job);

}  // namespace sh::prt
