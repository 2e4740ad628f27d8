// Sums on the widest registers of the processor. Lanes are coefficients, columns or directions, never terms of one sum,
// and nothing is contracted. The bits therefore do not depend on the width.
#pragma once

#define SHFORGE_WIDEST __attribute__((target_clones("avx2", "default")))

namespace sh::prt {

using FloatLanes = float __attribute__((vector_size(32)));
using DoubleLanes = double __attribute__((vector_size(32)));

// Lanes at any address. A vector type with an attribute of alignment would lose it in templates of clang.
struct __attribute__((packed, may_alias)) FloatLanesAnywhere {
  FloatLanes lanes;
};
struct __attribute__((packed, may_alias)) DoubleLanesAnywhere {
  DoubleLanes lanes;
};

}  // namespace sh::prt
