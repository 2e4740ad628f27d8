// The product of two functions of degree 2, term by term, in 16 SIMD lanes: c_k = sum over i, j of G_ijk a_i b_j.
//
// Functions that are even in x, y and z (e = 00, 20, 22) multiply every other function by a number. Their terms are
// scale(a)_k b_k + scale(b)_k a_k with scale(a)_k = sum over e of a_e G_ekk (half of it for e = k), and need no
// permutation. Rounds compute the other terms: g a_i b_j in every lane. Lane k < 9 adds to c_k. The further lanes take
// the terms that do not fit into one lane; the kernel adds these lanes at the end.
#pragma once

#include <array>
#include <vector>

#include "symbolic/number/surd.hpp"

namespace sh::codegen::recipes {

/// The number of SIMD lanes.
inline constexpr int kTripleLanes = 16;

/// The tables of the kernel.
struct LaneTriples {
  /// The entries G_ekk of one e, by lane k.
  struct Scale {
    int e = 0;
    std::array<symbolic::Surd, kTripleLanes> g;
  };
  /// One term g a_i b_j for each lane.
  struct Round {
    std::array<int, kTripleLanes> i{};
    std::array<int, kTripleLanes> j{};
    std::array<symbolic::Surd, kTripleLanes> g;
  };
  std::vector<Scale> scales;
  std::vector<Round> rounds;
  std::array<int, kTripleLanes> more{};  ///< the lane that is added to lane k; the last lane is 0
};

/// The tables, from the exact Gaunt tensor. Throws std::logic_error if the terms do not fit into the lanes.
LaneTriples lane_triples();

}  // namespace sh::codegen::recipes
