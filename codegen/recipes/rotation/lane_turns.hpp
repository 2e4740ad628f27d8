// The tables that rotate some bands in 16 SIMD lanes by turns about z and the constant quarter turn T = D(Rx(90)).
//
// R = Rz(alpha) Ry(beta) Rz(gamma) with D(Ry(beta)) = T^T D(Rz(beta)) T. A turn about z adds cos(m angle) times a lane
// and, with a sign, sin(m angle) times the lane of -m. Because of parity, T and its transpose have few entries in each
// row. A round multiplies one entry of every row by the lane of its column.
#pragma once

#include <array>
#include <vector>

#include "symbolic/number/surd.hpp"

namespace sh::codegen::recipes {

/// The number of SIMD lanes.
inline constexpr int kTurnLanes = 16;

/// One entry of every row of a matrix: out[lane] += entry[lane] * in[column[lane]].
struct TurnRound {
  std::array<int, kTurnLanes> column{};
  std::array<symbolic::Surd, kTurnLanes> entry;
};

/// The tables of bands first .. last.
struct LaneTurns {
  int first = 0;
  int last = 0;
  std::array<int, kTurnLanes> order{};    ///< |m|
  std::array<int, kTurnLanes> partner{};  ///< the lane of -m
  std::array<int, kTurnLanes> sign{};     ///< the sign of the sine: -1 for m > 0
  std::vector<TurnRound> quarter;         ///< T
  std::vector<TurnRound> back;            ///< the transpose of T
  [[nodiscard]] int lanes() const { return (last + 1) * (last + 1) - first * first; }
};

/// Bands first .. last, at most 16 coefficients, in their usual order. The unused lanes are 0.
LaneTurns lane_turns(int first, int last);

}  // namespace sh::codegen::recipes
