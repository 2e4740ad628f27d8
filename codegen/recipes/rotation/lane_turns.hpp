// Rotation of some bands in 16 SIMD lanes: turns about z and the constant quarter turn T = D(Rx(90)), lane by lane.
//
// R = Rz(alpha) Ry(beta) Rz(gamma) with D(Ry(beta)) = T^T D(Rz(beta)) T. A turn about z is cos(m angle) times a lane
// and sin(m angle), with a sign, times the lane of -m. T and its transpose have few entries a row, by parity: a round
// multiplies one entry of every row with the lane of its column.
#pragma once

#include <array>
#include <vector>

#include "symbolic/number/surd.hpp"

namespace sh::codegen::recipes {

inline constexpr int kTurnLanes = 16;

/// One entry of every row of a matrix: out[lane] += entry[lane] * in[column[lane]].
struct TurnRound {
  std::array<int, kTurnLanes> column{};
  std::array<symbolic::Surd, kTurnLanes> entry;
};

struct LaneTurns {
  int first = 0;  // band
  int last = 0;
  /// |m|, the lane of -m, and the sign of the sine: -1 for m > 0.
  std::array<int, kTurnLanes> order{};
  std::array<int, kTurnLanes> partner{};
  std::array<int, kTurnLanes> sign{};
  std::vector<TurnRound> quarter;  // T
  std::vector<TurnRound> back;     // its transpose
  [[nodiscard]] int lanes() const { return (last + 1) * (last + 1) - first * first; }
};

/// Bands first .. last, at most 16 coefficients, in their usual order; lanes beyond are 0.
LaneTurns lane_turns(int first, int last);

}  // namespace sh::codegen::recipes
