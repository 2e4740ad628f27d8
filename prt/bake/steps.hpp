// The steps of a bake; kinds of transfer name those they need (prt/kinds/diffuse.cpp) [SloanKautzSnyder02].
//   unshadowed  closed: T_lm = A_l/pi Y_lm(n), A_l the clamped-cosine factors [RamamoorthiHanrahan01]
//   shadow      sums over shared directions s_j, weights w_j = 4/N max(0, n.s_j): with S over the visible ones, S_all
//               over all of them and f = (sum of visible w) / (sum of w), T = S + f (T_unshadowed - S_all): a control
//               variate, exact where nothing is in the way, zero where everything is, continuous between. Rays that
//               meet mirrors go on from there (prt/bake/mirror_light.hpp)
//   bounce      adds the light that bounces (prt/bake/bounces.hpp): rays that something blocks are traced on to their
//               closest hit
// Surfaces' own light is kept apart (Transfer::emitted): with its bounces where there are any.
#pragma once
#include "prt/transfer/kind.hpp"

namespace sh::prt {

/// In: nothing. Out: vectors of one channel, without the albedo.
void take_unshadowed(BakeRun& run);
/// In: those. Out: the same with shadows, and what became of the rays.
void trace_shadows(BakeRun& run);
/// In: those and the form factors. Out: vectors of three channels that hold the albedo. Bounces that do not settle are
/// reported as a flaw.
void add_bounces(BakeRun& run);

inline constexpr BakeStep kUnshadowedStep = {take_unshadowed};
inline constexpr BakeStep kShadowStep = {trace_shadows, true};
inline constexpr BakeStep kBounceStep = {add_bounces, true, true};

}  // namespace sh::prt
