// Visibility times a prepared light, projected, in stages on rings of constant z: for the drivers `transfer_apply*`.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include "lanes.hpp"
#include "rings.hpp"

namespace sh::batch::SH_BATCH_ISA {

/// Whether transfer of a degree is applied in stages: below, that is slower.
template <int Degree, class T>
inline constexpr bool kInStages = Degree >= (sizeof(T) == sizeof(float) ? detail::kFirstRingDegree : 3);

/// Applies light of degree N, in 1 or 3 channels, to visibility of degree 2N: every register of every block.
/// Stored: T, or Half, where `in[0]` and `step[0]` count two numbers as one.
template <int N, int Channels, class Stored, class T>
void apply_on_rings(const Blocks<T>& blocks);

}  // namespace sh::batch::SH_BATCH_ISA
