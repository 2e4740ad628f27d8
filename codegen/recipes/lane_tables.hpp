// The exact tables of kernels with SIMD inside one product or rotation.
#pragma once

#include <array>
#include <vector>

#include "numeric/oracle/index.hpp"
#include "symbolic/number/matrix.hpp"
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
template <std::size_t Lanes>
struct TurnRound {
  std::array<int, Lanes> column{};
  std::array<symbolic::Surd, Lanes> entry;
};

/// D_l(S), where S swaps y and z: a symmetric matrix, and its own inverse. Because of parity, its rows have few entries.
symbolic::Matrix<symbolic::Surd> swap_matrix(int l);

/// The tables that rotate some bands in 16 SIMD lanes by turns about z and S: R = Rz(alpha) S Rz(b) S Rz(gamma).
///
/// A turn about z adds cos(m angle) times a lane and, with a sign, sin(m angle) times the lane of -m. A round multiplies
/// one entry of every row of S by the lane of its column.
struct LaneTurns {
  int first = 0;
  int last = 0;
  std::array<int, kLanes> order{};    ///< |m|
  std::array<int, kLanes> partner{};  ///< the lane of -m
  std::array<int, kLanes> sign{};     ///< the sign of the sine: -1 for m > 0
  std::vector<TurnRound<kLanes>> swap;
  [[nodiscard]] int lanes() const { return numeric::coefficient_count(last) - first * first; }
};

/// Bands first .. last, at most 16 coefficients, in their usual order. The unused lanes are 0.
LaneTurns lane_turns(int first, int last);

/// The number of lanes of one of two registers that hold a band by pairs.
inline constexpr int kPairLanes = 8;

/// S for bands in two registers of 8 lanes: lane m of the one has order m, of the other order -m, m > 0. A turn about z
/// needs no permutation. Bands up to 3 take four lanes each, so that two of them share the registers.
///
/// The columns of cosine rows (m >= 0) are the orders with l + |m| even, of sine rows those with l + |m| odd. So each kind
/// of row has all its columns in one register in which order -m is one lane lower: in the lane of a cosine of the other
/// kind.
struct LanePairs {
  std::vector<int> bands;                      ///< from lane 0 on
  std::vector<TurnRound<kPairLanes>> cosines;  ///< rows m >= 0
  std::vector<TurnRound<kPairLanes>> sines;    ///< rows m < 0, in lane -m
  /// Of a band.
  [[nodiscard]] int lanes() const { return kPairLanes / static_cast<int>(bands.size()); }
};

/// One band up to 7, or two up to 3. Throws std::logic_error if they do not fit.
LanePairs lane_pairs(const std::vector<int>& bands);

}  // namespace sh::codegen::recipes
