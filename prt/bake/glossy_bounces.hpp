// Light that bounces between surfaces with lobes [SloanKautzSnyder02, section 5]. The radiance that reaches a vertex p is
// linear in the light: F_p (rows x columns, for each channel), its direct part G_p from the visibility. What leaves a
// surface at q towards d is
//   u_q(d) = albedo (A Y(n))^T F_q + specular (lambda Y(R(d)))^T F_q,
// the same convolutions as at run time (prt/runtime/glossy.hpp), A those of the clamped cosine, lambda those of the lobe.
// Rays from p in directions s_j that are blocked at q_j bring it back:
//   M_p = sum over j of w_j Y(s_j) u_qj(-s_j)^T,   F = G + M,
// interpolated between the corners of the face as in pictures; one-sided faces are black from behind. The sum of all
// bounces M = K G + K K G + ... ends when what is left, by the rate at which its terms shrink, is below the tolerance: a
// measurement and not a bound, because band-limited lobes have negative parts.
#pragma once
#include "prt/bake/steps.hpp"

namespace sh::prt {

/// In: visibility with shadows, and the Sight of every vertex. Out: Transfer::indirect. Throws std::runtime_error if the
/// bounces do not shrink (closed rooms that lose hardly any light).
void add_glossy_bounces(BakeRun& run);

/// The memory of its matrices; the hits of rays need more, as far as the memory for bounces allows.
std::size_t glossy_bounce_bytes(const Mesh& mesh, int degree);

/// Throws std::runtime_error if the matrices of a scene need more than `there`, the bytes of this machine.
void require_glossy_bounce_memory(const Scene& scene, double there);

inline constexpr BakeStep kGlossyBounceStep = {add_glossy_bounces, true, true};

}  // namespace sh::prt
