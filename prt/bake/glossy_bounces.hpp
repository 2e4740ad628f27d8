// Light that bounces between surfaces with lobes [SloanKautzSnyder02, section 5]. The radiance that reaches a vertex p is
// linear in the light: F_p = G_p + M_p, its direct part G_p from the visibility. Rays from p that are blocked bring back
// what leaves the surfaces there (prt/bake/glossy_exit.hpp). The sum of all bounces M = K G + K K G + ... ends when what is
// left, by the rate at which its terms shrink, is below the tolerance: a measurement and not a bound, because band-limited
// lobes have negative parts.
#pragma once
#include "prt/bake/steps.hpp"

namespace sh::prt {

/// In: visibility with shadows, and the Sight of every vertex. Out: Transfer::indirect. Throws std::runtime_error if the
/// bounces do not shrink (closed rooms that lose hardly any light).
void add_glossy_bounces(BakeRun& run);

/// The same for `found`, whose transfer is the visibility along these rays: sets Transfer::indirect, its shape and the report.
/// Vertices with open[v] != 0 have no hits, none if `open` is empty; hits beyond `bounce_memory` bytes are traced again.
void solve_glossy_bounces(const RaySetup& rays, const ShadowResult& found, const std::vector<std::uint8_t>& open,
                          std::size_t bounce_memory, const BounceOptions& options);

/// The memory of its matrices; the hits of rays need more, as far as the memory for bounces allows.
std::size_t glossy_bounce_bytes(const Mesh& mesh, int degree);

/// Throws std::runtime_error if the matrices of a scene need more than `there`, the bytes of this machine.
void require_glossy_bounce_memory(const Scene& scene, double there);

inline constexpr BakeStep kGlossyBounceStep = {add_glossy_bounces, true, true};

}  // namespace sh::prt
