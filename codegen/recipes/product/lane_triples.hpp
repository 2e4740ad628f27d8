// The product of two functions of degree 2, term by term, in 16 SIMD lanes: c_k = sum over i, j of G_ijk a_i b_j.
//
// Functions even in x, y and z (e = 00, 20, 22) multiply every other one by a number: their terms are
// scale(a)_k b_k + scale(b)_k a_k with scale(a)_k = sum over e of a_e G_ekk (half of it where e = k), and need no
// permutation. The other terms are done in rounds, g a_i b_j in every lane. Lane k < 9 adds to c_k. The lanes
// beyond take the terms that are too many for one lane, and are added at the end.
#pragma once

#include <array>
#include <vector>

#include "symbolic/number/surd.hpp"

namespace sh::codegen::recipes {

inline constexpr int kTripleLanes = 16;

struct LaneTriples {
  struct Scale {
    int e = 0;
    std::array<symbolic::Surd, kTripleLanes> g;
  };
  struct Round {
    std::array<int, kTripleLanes> i{};
    std::array<int, kTripleLanes> j{};
    std::array<symbolic::Surd, kTripleLanes> g;
  };
  std::vector<Scale> scales;
  std::vector<Round> rounds;
  std::array<int, kTripleLanes> more{};  // which lane is added to lane k; the last one is 0
};

LaneTriples lane_triples();

}  // namespace sh::codegen::recipes
