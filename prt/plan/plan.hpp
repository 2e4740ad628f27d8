// The work and the numbers that a bake of a scene can leave out, decided before it: each decision with its savings and
// the error that it introduces. Errors are of exit radiance, relative to the largest that the mesh would have
// unshadowed under the declared lights (any vertex, any channel), RMS over the vertices; a bound holds for every
// vertex, and so for their RMS. They are against a bake of the asked degree and kind with converged directions, under
// the declared lights as a whole, turned as PlanOptions says. The loss by the asked degree itself is said beside, and
// not counted.
//   analytic    vertices above whose horizon nothing lies: closed form, no rays (prt/plan/open_vertices.hpp)
//   bounces     none, or a looser tolerance, where little light comes back
//   channels    one, where every albedo is grey
//   bands       a lower degree, where |T_l| |L_l| summed over the bands left out is small [Sloan, Kautz, Snyder 2002]
//   symmetry    only the coefficients that the lights have
//   storage     half or 8 bits
//   directions  the fewest whose error, measured on a probe and fitted by a power of their number, fits
// Without a budget only analytic and channels are taken, which change no number under any light.
#pragma once
#include "prt/bake/job.hpp"

namespace sh::prt {

/// The job with its `plan` made as scene.plan says, and scene.bake lowered to follow it. Throws std::invalid_argument,
/// one line, for a budget that cannot be met (it says which can), lights that leave the mesh dark, and names that are
/// no decisions.
BakeJob planned(BakeJob job);

}  // namespace sh::prt
