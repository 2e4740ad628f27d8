// The exact tables of kernels with SIMD inside one product or rotation.
#pragma once

#include <array>
#include <vector>

#include "numeric/oracle/index.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::codegen::recipes {

/// The number of SIMD lanes.
inline constexpr int kLanes = 16;

/// The product of two functions of degree 2, term by term, in 16 SIMD lanes: c_k = sum over i, j of G_ijk a_i b_j.
///
/// Functions that are even in x, y and z (e = 00, 20, 22) multiply every other function by a number. Their terms are
/// scale(a)_k b_k + scale(b)_k a_k with scale(a)_k = sum over e of a_e G_ekk (half of it for e = k), and need no
/// permutation. Rounds compute the other terms: g a_i b_j in every lane. Lane k < 9 adds to c_k. The further lanes take
/// the terms that do not fit into one lane; the kernel adds these lanes at the end.
struct LaneTriples {
  /// The entries G_ekk of one e, by lane k.
  struct Scale {
    int e = 0;
    std::array<symbolic::Surd, kLanes> g;
  };
  /// One term g a_i b_j for each lane.
  struct Round {
    std::array<int, kLanes> i{};
    std::array<int, kLanes> j{};
    std::array<symbolic::Surd, kLanes> g;
  };
  std::vector<Scale> scales;
  std::vector<Round> rounds;
  std::array<int, kLanes> more{};  ///< the lane that is added to lane k; the last lane is 0
};

/// The tables, from the exact Gaunt tensor. Throws std::logic_error if the terms do not fit into the lanes.
LaneTriples lane_triples();

/// One entry of every row of a matrix: out[lane] += entry[lane] * in[column[lane]].
struct TurnRound {
  std::array<int, kLanes> column{};
  std::array<symbolic::Surd, kLanes> entry;
};

/// The tables that rotate some bands in 16 SIMD lanes by turns about z and the constant quarter turn T = D(Rx(90)).
///
/// R = Rz(alpha) Ry(beta) Rz(gamma) with D(Ry(beta)) = T^T D(Rz(beta)) T. A turn about z adds cos(m angle) times a lane
/// and, with a sign, sin(m angle) times the lane of -m. Because of parity, T and its transpose have few entries in each
/// row. A round multiplies one entry of every row by the lane of its column.
struct LaneTurns {
  int first = 0;
  int last = 0;
  std::array<int, kLanes> order{};    ///< |m|
  std::array<int, kLanes> partner{};  ///< the lane of -m
  std::array<int, kLanes> sign{};     ///< the sign of the sine: -1 for m > 0
  std::vector<TurnRound> quarter;     ///< T
  std::vector<TurnRound> back;        ///< the transpose of T
  [[nodiscard]] int lanes() const { return numeric::coefficient_count(last) - first * first; }
};

/// Bands first .. last, at most 16 coefficients, in their usual order. The unused lanes are 0.
LaneTurns lane_turns(int first, int last);

}  // namespace sh::codegen::recipes
