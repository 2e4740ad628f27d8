#include "codegen/recipes/lane_tables.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

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

symbolic::Matrix<Surd> swap_matrix(int l) {
  // A quarter turn about x takes y to z and z to -y; then y changes its sign.
  symbolic::Matrix<Surd> matrix = symbolic::surd_entries(l, symbolic::rotation_x90(l));
  for (int i = 0; i < l; ++i) {
    for (int j = 0; j < matrix.columns(); ++j) matrix(i, j) = -matrix(i, j);
  }
  return matrix;
}

namespace {

constexpr int kNoLane = -1;

// The entries of D_l(S), dealt out to rounds; lanes: of orders m = -l .. l, or kNoLane. A row that has fewer entries than
// another reads its first column again, times 0.
template <std::size_t Lanes, class RowLane, class ColumnLane>
void deal(int l, const RowLane& row_lane, const ColumnLane& column_lane, std::vector<TurnRound<Lanes>>& rounds) {
  const symbolic::Matrix<Surd> matrix = swap_matrix(l);
  const auto columns_of = [&](int row) {
    std::vector<int> columns;
    for (int j = -l; j <= l; ++j) {
      if (!matrix(l + row, l + j).is_zero()) columns.push_back(j);
    }
    return columns;
  };
  for (int row = -l; row <= l; ++row) {
    if (row_lane(row) == kNoLane) continue;
    while (rounds.size() < columns_of(row).size()) {
      TurnRound<Lanes> round;
      std::iota(round.column.begin(), round.column.end(), 0);
      if (!rounds.empty()) round.column = rounds.front().column;
      rounds.push_back(round);
    }
  }
  for (int row = -l; row <= l; ++row) {
    const int lane = row_lane(row);
    if (lane == kNoLane) continue;
    const std::vector<int> columns = columns_of(row);
    for (std::size_t t = 0; t < rounds.size(); ++t) {
      const int j = columns[t < columns.size() ? t : 0];
      rounds[t].column.at(lane) = column_lane(j);
      rounds[t].entry.at(lane) = t < columns.size() ? matrix(l + row, l + j) : Surd(0);
    }
  }
}

}  // namespace

LaneTurns lane_turns(int first, int last) {
  LaneTurns turns{first, last, {}, {}, {}, {}};
  if (turns.lanes() > kLanes) throw std::logic_error("lane turns: more coefficients than lanes");
  std::iota(turns.partner.begin(), turns.partner.end(), 0);
  for (int l = first; l <= last; ++l) {
    const auto lane_of = [start = l * l - first * first + l](int m) { return start + m; };
    for (int m = -l; m <= l; ++m) {
      const std::size_t lane = lane_of(m);
      turns.order[lane] = m < 0 ? -m : m;
      turns.partner[lane] = lane_of(-m);
      turns.sign[lane] = m > 0 ? -1 : m < 0 ? 1 : 0;
    }
    deal(l, lane_of, lane_of, turns.swap);
  }
  return turns;
}

LanePairs lane_pairs(const std::vector<int>& bands) {
  LanePairs pairs{bands, {}, {}};
  int start = 0;
  for (const int l : bands) {
    if (l >= pairs.lanes()) throw std::logic_error("lane pairs: more orders than lanes");
    const auto column = [start](int m) { return start + (m < 0 ? -m - 1 : m); };
    deal(
        l, [start](int m) { return m < 0 ? kNoLane : start + m; }, column, pairs.cosines);
    deal(
        l, [start](int m) { return m < 0 ? start - m : kNoLane; }, column, pairs.sines);
    start += pairs.lanes();
  }
  return pairs;
}

}  // namespace sh::codegen::recipes
