#include "codegen/recipes/lane_tables.hpp"

#include <algorithm>
#include <stdexcept>

#include "symbolic/number/matrix.hpp"
#include "symbolic/product/gaunt.hpp"
#include "symbolic/rotation/rotation.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::gaunt;
using symbolic::Surd;

constexpr int kCount = 9;
constexpr int kZero = kLanes - 1;  // the lane with factors 0
constexpr std::array<int, 3> kEven{0, 6, 8};

struct Term {
  int i = 0;
  int j = 0;
  Surd g;
};

// The part of c_k that the scales do not give.
std::vector<Term> remaining(int k) {
  std::vector<Term> terms;
  const auto even = [](int e) { return std::find(kEven.begin(), kEven.end(), e) != kEven.end(); };
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j < kCount; ++j) {
      const Surd g = gaunt(i, j, k);
      const bool scaled = (even(i) && j == k) || (even(j) && i == k);
      if (!g.is_zero() && !scaled) terms.push_back({i, j, g});
    }
  }
  return terms;
}

}  // namespace

LaneTriples lane_triples() {
  LaneTriples result;
  for (const int e : kEven) {
    LaneTriples::Scale scale{e, {}};
    for (int k = 0; k < kCount; ++k) {
      scale.g[k] = gaunt(e, k, k) * Surd(e == k ? cln::cl_RA(1) / 2 : cln::cl_RA(1));
    }
    result.scales.push_back(scale);
  }
  constexpr int kRounds = 4;  // c_00 has the most terms, 8
  LaneTriples::Round empty;
  empty.i.fill(kZero);
  empty.j.fill(kZero);
  result.rounds.assign(kRounds, empty);
  result.more.fill(kZero);
  int next = kCount;  // the first unused lane
  for (int k = 0; k < kCount; ++k) {
    const std::vector<Term> terms = remaining(k);
    const bool beyond = terms.size() > kRounds;
    if (beyond) result.more[k] = next;
    if (terms.size() > std::size_t{2} * kRounds || next >= kZero)
      throw std::logic_error("lane triples: too many terms");
    for (std::size_t t = 0; t < terms.size(); ++t) {
      LaneTriples::Round& round = result.rounds[t % kRounds];
      const auto lane = t < kRounds ? k : next;
      round.i[lane] = terms[t].i;
      round.j[lane] = terms[t].j;
      round.g[lane] = terms[t].g;
    }
    if (beyond) ++next;
  }
  return result;
}

namespace {

// Entries of a band's matrix, row by row, dealt out to rounds; `start`: lane of its first row and column.
void deal(const symbolic::Matrix<Surd>& matrix, int start, std::vector<TurnRound>& rounds) {
  for (int i = 0; i < matrix.rows(); ++i) {
    std::size_t round = 0;
    for (int j = 0; j < matrix.columns(); ++j) {
      if (matrix(i, j).is_zero()) continue;
      if (round == rounds.size()) {
        rounds.emplace_back();
        for (int lane = 0; lane < kLanes; ++lane) rounds.back().column[lane] = lane;
      }
      rounds[round].column[start + i] = start + j;
      rounds[round].entry[start + i] = matrix(i, j);
      ++round;
    }
  }
}

}  // namespace

LaneTurns lane_turns(int first, int last) {
  LaneTurns turns{first, last, {}, {}, {}, {}, {}};
  if (turns.lanes() > kLanes) throw std::logic_error("lane turns: more coefficients than lanes");
  for (int lane = 0; lane < kLanes; ++lane) turns.partner[lane] = lane;
  for (int l = first; l <= last; ++l) {
    const int start = l * l - first * first;
    for (int m = -l; m <= l; ++m) {
      const std::size_t lane = start + l + m;
      turns.order[lane] = m < 0 ? -m : m;
      turns.partner[lane] = start + l - m;
      turns.sign[lane] = m > 0 ? -1 : m < 0 ? 1 : 0;
    }
    const auto quarter = symbolic::surd_entries(l, symbolic::rotation_x90(l));
    deal(quarter, start, turns.quarter);
    deal(quarter.transposed(), start, turns.back);
  }
  return turns;
}

}  // namespace sh::codegen::recipes
