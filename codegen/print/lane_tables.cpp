#include "codegen/print/lane_tables.hpp"

#include <algorithm>

#include "codegen/ir/literal.hpp"
#include "codegen/print/filled.hpp"
#include "codegen/recipes/product/lane_triples.hpp"
#include "codegen/recipes/product/orbits.hpp"
#include "codegen/recipes/rotation/lane_turns.hpp"

namespace sh::codegen::print {
namespace {

constexpr std::size_t kMostColumns = 120;

// "{a, b, c}", broken into lines.
class Rows {
 public:
  void add(const std::string& value) {
    const std::string item = value + ", ";
    if (line_.size() + item.size() > kMostColumns) flush();
    line_ += item;
  }
  std::string text() {
    flush();
    return text_.substr(0, text_.rfind(','));
  }

 private:
  void flush() {
    if (line_.size() <= kIndent) return;
    text_ += line_.substr(0, line_.size() - 1) + "\n";
    line_.assign(kIndent, ' ');
  }
  static constexpr std::size_t kIndent = 6;
  std::string text_;
  std::string line_ = std::string(kIndent, ' ');
};

std::string in_float(const ExactReal& value) {
  const float rounded = is_zero(value) ? 0.0F : nearest<float>(value);
  const std::string digits = decimal(rounded);
  return digits == "0.0" ? "0" : digits + "F";
}

std::string orbit_file(int degree) {
  const recipes::OrbitQuadrature orbits(degree);
  constexpr int kLine = 16;
  const int padded = orbits.count() <= kLine / 2 ? kLine / 2 : (orbits.count() + kLine - 1) / kLine * kLine;
  const int size = (degree + 1) * (degree + 1);

  Rows values;
  for (int i = 0; i < size; ++i) {
    for (int q = 0; q < padded; ++q) values.add(q < orbits.count() ? in_float(orbits.value(i, q)) : "0");
  }
  Rows slots;
  Rows sums;
  for (const bool opposite : {false, true}) {
    for (const recipes::ClassRow& row : orbits.rows(opposite)) {
      for (const int i : row) slots.add(std::to_string(i));
      for (int j = 0; j < 4; ++j) {
        for (int lane = 0; lane < padded; ++lane) {
          const int i = row[lane % 4];
          const int q = lane / 4 * 4 + j;
          if (i < 0 || q >= orbits.count() || is_zero(orbits.value(i, q))) {
            sums.add("0");
            continue;
          }
          const ExactReal weight = multiply(symbolic::Surd(cln::cl_RA(1) / 2), orbits.weight(q));
          sums.add(in_float(multiply(weight, orbits.value(i, q))));
        }
      }
    }
  }
  return filled(R"(// The orbits of (+-x, +-y, +-z) that products of degree $l are summed over: for product_one.cpp.
//
$stamp//
// Points:       $definition
#pragma once

namespace sh::batch::detail {

struct Orbits$l {
  static constexpr int kDegree = $l;
  static constexpr int kOrbits = $lanes;  // $count of them, the others are 0
  static constexpr int kRows = $rows;         // of coefficients of classes 1, y, z, x
  static constexpr int kOppositeRows = $opposite;  // of classes xyz, xz, xy, yz
  // Which coefficient; -1: none.
  static constexpr int kSlots[$all_rows * 4] = {
$slots};
  // Y_i at the orbits.
  alignas(64) static constexpr float kValues[$size * $lanes] = {
$values};
  // Weight Y_i / 2: row of slots, j = 0..3, for every four orbits the values at the j-th of them.
  alignas(64) static constexpr float kSums[$all_rows * 4 * $lanes] = {
$sums};
};

}  // namespace sh::batch::detail
)",
                {{"l", std::to_string(degree)},
                 {"stamp", kStamp},
                 {"definition", orbits.definition()},
                 {"lanes", std::to_string(padded)},
                 {"count", std::to_string(orbits.count())},
                 {"rows", std::to_string(orbits.rows(false).size())},
                 {"opposite", std::to_string(orbits.rows(true).size())},
                 {"all_rows", std::to_string(orbits.rows(false).size() + orbits.rows(true).size())},
                 {"size", std::to_string(size)},
                 {"slots", slots.text()},
                 {"values", values.text()},
                 {"sums", sums.text()}});
}

template <class Lanes, class Print>
std::string lane_row(const Lanes& lanes, const Print& print) {
  Rows row;
  for (const auto& lane : lanes) row.add(print(lane));
  return "      {" + row.text().substr(6) + "},\n";
}

// The same as the value of an array of one row.
template <class Lanes, class Print>
std::string single_row(const Lanes& lanes, const Print& print) {
  const std::string row = lane_row(lanes, print);
  return row.substr(6, row.size() - 8);
}

std::string index(int lane) { return std::to_string(lane); }
std::string surd_in_float(const symbolic::Surd& value) { return in_float(value); }

std::string triples_file() {
  const recipes::LaneTriples triples = recipes::lane_triples();
  std::string scales;
  std::string even;
  for (const auto& scale : triples.scales) {
    scales += lane_row(scale.g, surd_in_float);
    even += (even.empty() ? "" : ", ") + std::to_string(scale.e);
  }
  std::string i;
  std::string j;
  std::string g;
  for (const auto& round : triples.rounds) {
    i += lane_row(round.i, index);
    j += lane_row(round.j, index);
    g += lane_row(round.g, surd_in_float);
  }
  return filled(R"(// The Gaunt tensor G of degree 2 in lanes: for product_one.cpp.
//
$stamp#pragma once

namespace sh::batch::detail {

// c_k = scale(a)_k b_k + scale(b)_k a_k + sum over rounds of G a_I b_J, and lane More of the sums is added;
// scale(a) = sum over e of Scales a_Even.
struct Triples2 {
  static constexpr int kEven[] = {$even};
  alignas(64) static constexpr float kScales[][16] = {
$scales  };
  static constexpr int kRounds = $rounds;
  alignas(64) static constexpr int kI[][16] = {
$i  };
  alignas(64) static constexpr int kJ[][16] = {
$j  };
  alignas(64) static constexpr float kG[][16] = {
$g  };
  alignas(64) static constexpr int kMore[] = $more;
};

}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp},
                 {"even", even},
                 {"scales", scales},
                 {"rounds", std::to_string(triples.rounds.size())},
                 {"i", i},
                 {"j", j},
                 {"g", g},
                 {"more", single_row(triples.more, index)}});
}

// The columns and the entries of all rounds, as two arrays of rows.
struct RoundRows {
  std::string columns;
  std::string entries;
};

RoundRows rows_of(const std::vector<recipes::TurnRound>& rounds) {
  RoundRows rows;
  for (const recipes::TurnRound& round : rounds) {
    rows.columns += lane_row(round.column, index);
    rows.entries += lane_row(round.entry, surd_in_float);
  }
  return rows;
}

std::string turns_struct(int first, int last) {
  const recipes::LaneTurns turns = recipes::lane_turns(first, last);
  std::string multiples;
  for (int angle = 0; angle < 3; ++angle) {
    multiples += lane_row(turns.order, [angle](int m) { return std::to_string(4 * m + angle); });
  }
  const RoundRows quarter = rows_of(turns.quarter);
  const RoundRows back = rows_of(turns.back);
  return filled(R"(struct Turns$first {
  static constexpr int kFirst = $first;
  static constexpr int kLast = $last;
  static constexpr int kLanes = $lanes;
  alignas(64) static constexpr int kMultiple[][16] = {
$multiples  };
  alignas(64) static constexpr int kPartner[] = $partner;
  alignas(64) static constexpr float kSign[] = $sign;
  static constexpr int kRounds = $rounds;
  alignas(64) static constexpr int kQuarterColumn[][16] = {
$quarter_columns  };
  alignas(64) static constexpr float kQuarter[][16] = {
$quarter_entries  };
  static constexpr int kBackRounds = $back_rounds;
  alignas(64) static constexpr int kBackColumn[][16] = {
$back_columns  };
  alignas(64) static constexpr float kBack[][16] = {
$back_entries  };
};
)",
                {{"first", std::to_string(first)},
                 {"last", std::to_string(last)},
                 {"lanes", std::to_string(turns.lanes())},
                 {"multiples", multiples},
                 {"partner", single_row(turns.partner, index)},
                 {"sign", single_row(turns.sign, index)},
                 {"rounds", std::to_string(turns.quarter.size())},
                 {"quarter_columns", quarter.columns},
                 {"quarter_entries", quarter.entries},
                 {"back_rounds", std::to_string(turns.back.size())},
                 {"back_columns", back.columns},
                 {"back_entries", back.entries}});
}

std::string turns_file() {
  std::string columns;
  for (int j = 0; j < 7; ++j) {
    std::vector<int> lanes;
    for (int l = 0; l <= 3; ++l) {
      for (int i = 0; i <= 2 * l; ++i) lanes.push_back(l * l + std::min(j, 2 * l));
    }
    columns += lane_row(lanes, index);
  }
  std::string turns = turns_struct(0, 3);
  for (int l = 4; l <= kLastTurnDegree; ++l) turns += "\n" + turns_struct(l, l);
  return filled(R"(// Turns of bands in lanes: for rotate_one.cpp.
//
$stamp//
// Lane i holds coefficient kFirst^2 + i. Multiple: 4 |m| + angle; Partner: the lane of -m; Sign: of the sine.
// The quarter turn D(Rx(90)) and its transpose: round t adds entry [t][i] times lane column [t][i] to lane i.
#pragma once

namespace sh::batch::detail {

// Column j of bands 0 to 3: the lane of each band's order j - l.
alignas(64) inline constexpr int kColumnOfBands[][16] = {
$columns};

$turns
}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp}, {"columns", columns}, {"turns", turns}});
}

}  // namespace

std::map<std::string, std::string> lane_tables() {
  std::map<std::string, std::string> files{{"batch/triples_l2.hpp", triples_file()}, {"batch/turns.hpp", turns_file()}};
  for (int degree = kFirstOrbitDegree; degree <= kLastOrbitDegree; ++degree) {
    files["batch/orbits_l" + std::to_string(degree) + ".hpp"] = orbit_file(degree);
  }
  return files;
}

}  // namespace sh::codegen::print
