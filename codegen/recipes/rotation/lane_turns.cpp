#include "codegen/recipes/rotation/lane_turns.hpp"

#include <stdexcept>

#include "symbolic/number/matrix.hpp"
#include "symbolic/rotation/rotation.hpp"

namespace sh::codegen::recipes {
namespace {

using symbolic::Surd;

// Entries of a band's matrix, row by row, dealt out to rounds; `start`: lane of its first row and column.
void deal(const symbolic::Matrix<Surd>& matrix, int start, std::vector<TurnRound>& rounds) {
  for (int i = 0; i < matrix.rows(); ++i) {
    std::size_t round = 0;
    for (int j = 0; j < matrix.columns(); ++j) {
      if (matrix(i, j).is_zero()) continue;
      if (round == rounds.size()) {
        rounds.emplace_back();
        for (int lane = 0; lane < kTurnLanes; ++lane) rounds.back().column[lane] = lane;
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
  if (turns.lanes() > kTurnLanes) throw std::logic_error("lane turns: more coefficients than lanes");
  for (int lane = 0; lane < kTurnLanes; ++lane) turns.partner[lane] = lane;
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
