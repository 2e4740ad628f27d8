// The tables of lanes: the exact tables, correctly rounded, that kernels with SIMD inside one call read.
#include "codegen/recipes/lane_tables.hpp"

#include "codegen/ir/literal.hpp"
#include "codegen/print/batch_driver.hpp"
#include "codegen/print/statements.hpp"
#include "codegen/recipes/parts.hpp"
#include "codegen/recipes/product/orbits.hpp"
#include "codegen/recipes/product/transfer_rings.hpp"
#include "numeric/oracle/index.hpp"

namespace sh::codegen::print {
namespace {

constexpr std::size_t kMostColumns = 120;

constexpr std::size_t kIndent = 6;

std::string rows_of(const std::vector<std::string>& items) { return wrapped_list(items, kIndent, kMostColumns); }

std::string in_float(const ExactReal& value) {
  const float rounded = is_zero(value) ? 0.0F : nearest<float>(value);
  const std::string digits = decimal(rounded);
  return digits == "0.0" ? "0" : digits + "F";
}

std::string orbit_file(int degree) {
  const recipes::OrbitQuadrature orbits(degree);
  constexpr int kLine = 16;
  const int padded = orbits.count() <= kLine / 2 ? kLine / 2 : (orbits.count() + kLine - 1) / kLine * kLine;
  const int size = numeric::coefficient_count(degree);

  std::vector<std::string> values;
  for (int i = 0; i < size; ++i) {
    for (int q = 0; q < padded; ++q) values.push_back(q < orbits.count() ? in_float(orbits.value(i, q)) : "0");
  }
  std::vector<std::string> slots;
  std::vector<std::string> sums;
  for (const bool opposite : {false, true}) {
    for (const recipes::ClassRow& row : orbits.rows(opposite)) {
      for (const int i : row) slots.push_back(std::to_string(i));
      for (int j = 0; j < 4; ++j) {
        for (int lane = 0; lane < padded; ++lane) {
          const int i = row[lane % 4];
          const int q = lane / 4 * 4 + j;
          if (i < 0 || q >= orbits.count() || is_zero(orbits.value(i, q))) {
            sums.emplace_back("0");
            continue;
          }
          const ExactReal weight = multiply(symbolic::Surd(cln::cl_RA(1) / 2), orbits.weight(q));
          sums.push_back(in_float(multiply(weight, orbits.value(i, q))));
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
                 {"slots", rows_of(slots)},
                 {"values", rows_of(values)},
                 {"sums", rows_of(sums)}});
}

// Theta of every (m, l >= m) for cosines and sines, all pairs of rings of each; `of` gives one number.
template <class Of>
std::vector<ExactReal> thetas(int degree, int pairs, bool is_sine, const Of& of) {
  std::vector<ExactReal> numbers;
  for (int m = 0; m <= degree; ++m) {
    for (int l = m; l <= degree; ++l) {
      for (int pair = 0; pair < pairs; ++pair) numbers.push_back(of(is_sine, l, m, pair));
    }
  }
  return numbers;
}

std::string in_double(const ExactReal& value) {
  const std::string digits = decimal(is_zero(value) ? 0.0 : nearest<double>(value));
  return digits == "0.0" ? "0" : digits;
}

// Numbers in a scalar, row by row.
std::string numbers_in(const std::string& scalar, const std::vector<ExactReal>& numbers) {
  std::vector<std::string> items;
  for (const ExactReal& number : numbers) items.push_back(scalar == "float" ? in_float(number) : in_double(number));
  return rows_of(items);
}

std::string table(const std::string& scalar, const std::string& name) {
  return "  alignas(64) static constexpr " + scalar + " " + name;
}

// A member of two rows, for cosines and sines.
template <class Row>
std::string two_rows(const std::string& scalar, const std::string& name, const Row& row) {
  const std::vector<ExactReal> cosines = row(false);
  return table(scalar, name) + "[2][" + std::to_string(cosines.size()) + "] = {\n      {" +
         numbers_in(scalar, cosines).substr(kIndent) + "},\n      {" + numbers_in(scalar, row(true)).substr(kIndent) +
         "}};\n";
}

std::string one_row(const std::string& scalar, const std::string& name, const std::vector<ExactReal>& numbers) {
  return table(scalar, name) + "[] = {\n" + numbers_in(scalar, numbers) + "};\n";
}

std::string rings_struct(int degree) {
  const recipes::TransferRings rings(degree);
  const auto theta = [&](bool is_sine) {
    return thetas(2 * degree, degree, is_sine, [&](auto... at) { return rings.theta(at...); });
  };
  const auto result = [&](bool is_sine) {
    return thetas(degree, degree, is_sine, [&](auto... at) { return rings.result(at...); });
  };
  const auto ratios = [&](bool is_sine) {
    std::vector<ExactReal> numbers;
    for (int m = 0; m <= 2 * degree; ++m) {
      for (int j = 0; j < degree; ++j) numbers.push_back(rings.ratio(is_sine, m, j));
    }
    return numbers;
  };
  std::vector<ExactReal> pole;
  std::vector<ExactReal> pole_result;
  for (int l = 0; l <= 2 * degree; ++l) pole.push_back(rings.pole(l));
  for (int l = 0; l <= degree; ++l) pole_result.push_back(rings.pole_result(l));
  std::string text = "\n// " + rings.definition() + "\n";
  for (const std::string scalar : {"float", "double"}) {
    text += "template <>\nstruct Rings<" + std::to_string(degree) + ", " + scalar + "> : RingPlaces {\n" +
            two_rows(scalar, "kTheta", theta) + one_row(scalar, "kPole", pole) + two_rows(scalar, "kResult", result) +
            one_row(scalar, "kPoleResult", pole_result) + two_rows(scalar, "kRatio", ratios) + "};\n";
  }
  return text;
}

std::string printed(int number) { return std::to_string(number); }
std::string printed(const symbolic::Surd& value) { return in_float(value); }

// "{a, b, c}", broken into lines.
template <class Lanes>
std::string lane_row(const Lanes& lanes) {
  std::vector<std::string> items;
  for (const auto& lane : lanes) items.push_back(printed(lane));
  return "{" + rows_of(items).substr(kIndent) + "}";
}

template <class Lanes>
std::string lane_rows(const std::vector<Lanes>& rows) {
  std::string text;
  for (const Lanes& row : rows) text += "      " + lane_row(row) + ",\n";
  return text;
}

// The same array of every round.
template <class Round, class Lanes>
std::vector<Lanes> of_each(const std::vector<Round>& rounds, Lanes Round::*lanes) {
  std::vector<Lanes> rows;
  for (const Round& round : rounds) rows.push_back(round.*lanes);
  return rows;
}

// Members of a struct of tables: a number, an array of lanes, an array of rows of lanes.
std::string member(const std::string& name, std::size_t value) {
  return "  static constexpr int " + name + " = " + std::to_string(value) + ";\n";
}

template <class Lanes>
std::string member(const std::string& type, const std::string& name, const Lanes& lanes) {
  return "  alignas(64) static constexpr " + type + " " + name + "[] = " + lane_row(lanes) + ";\n";
}

template <class T, std::size_t Lanes>
std::string member(const std::string& type, const std::string& name, const std::vector<std::array<T, Lanes>>& rows) {
  return "  alignas(64) static constexpr " + type + " " + name + "[][" + std::to_string(Lanes) + "] = {\n" +
         lane_rows(rows) + "  };\n";
}

std::string triples_file() {
  using recipes::LaneTriples;
  const LaneTriples triples = recipes::lane_triples();
  std::string even;
  for (const auto& scale : triples.scales) even += (even.empty() ? "" : ", ") + std::to_string(scale.e);
  const std::string members =
      member("float", "kScales", of_each(triples.scales, &LaneTriples::Scale::g)) +
      member("kRounds", triples.rounds.size()) + member("int", "kI", of_each(triples.rounds, &LaneTriples::Round::i)) +
      member("int", "kJ", of_each(triples.rounds, &LaneTriples::Round::j)) +
      member("float", "kG", of_each(triples.rounds, &LaneTriples::Round::g)) + member("int", "kMore", triples.more);
  return filled(R"(// The Gaunt tensor G of degree 2 in lanes: for product_one.cpp.
//
$stamp#pragma once

namespace sh::batch::detail {

// c_k = scale(a)_k b_k + scale(b)_k a_k + sum over rounds of G a_I b_J, and lane More of the sums is added;
// scale(a) = sum over e of Scales a_Even.
struct Triples2 {
  static constexpr int kEven[] = {$even};
$members};

}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp}, {"even", even}, {"members", members}});
}

// The rounds of a matrix: how many, the lane of every row's column, its entry.
template <std::size_t Lanes>
std::string rounds_of(const std::string& name, const std::vector<recipes::TurnRound<Lanes>>& rounds) {
  using Round = recipes::TurnRound<Lanes>;
  return member(name + "Rounds", rounds.size()) + member("int", name + "Column", of_each(rounds, &Round::column)) +
         member("float", name, of_each(rounds, &Round::entry));
}

std::string turns_struct(int first, int last) {
  const recipes::LaneTurns turns = recipes::lane_turns(first, last);
  std::vector<std::array<int, recipes::kLanes>> multiples(3, turns.order);
  for (int angle = 0; angle < 3; ++angle) {
    for (int& m : multiples[angle]) m = 4 * m + angle;
  }
  return "struct " + recipes::numbered("Turns", first) + " {\n" + member("kFirst", first) + member("kLast", last) +
         member("kLanes", turns.lanes()) + member("int", "kMultiple", multiples) +
         member("int", "kPartner", turns.partner) + member("float", "kSign", turns.sign) +
         rounds_of("kSwap", turns.swap) + "};\n";
}

std::string pairs_struct(const std::vector<int>& bands) {
  const recipes::LanePairs pairs = recipes::lane_pairs(bands);
  return "template <>\nstruct Pairs<" + std::to_string(bands[0]) + "> {\n" + member("int", "kBands", bands) +
         rounds_of("kCosine", pairs.cosines) + rounds_of("kSine", pairs.sines) + "};\n";
}

std::string turns_file() {
  std::vector<std::vector<int>> columns(7);
  for (int j = 0; j < 7; ++j) {
    for (int l = 0; l <= 3; ++l) columns[j].insert(columns[j].end(), 2 * l + 1, l * l + std::min(j, 2 * l));
  }
  std::string turns = turns_struct(0, 3);
  for (int l = 4; l <= kLastTurnDegree; ++l) turns += "\n" + turns_struct(l, l);
  std::string pairs = pairs_struct({3, 2});
  for (int l = 4; l <= kLastPairDegree; ++l) pairs += "\n" + pairs_struct({l});
  return filled(R"(// Turns of bands in lanes: for rotate_one.cpp.
//
$stamp//
// S swaps y and z. Round t of a matrix adds entry [t][i] times lane column [t][i] to lane i.
#pragma once

namespace sh::batch::detail {

// Column j of bands 0 to 3: the lane of each band's order j - l.
alignas(64) inline constexpr int kColumnOfBands[][16] = {
$columns};

constexpr int kLastTurnDegree = $last;

// Turns*: bands in 16 lanes; lane i holds coefficient kFirst^2 + i.
// Multiple: 4 |m| + angle; Partner: the lane of -m; Sign: of the sine; Swap: D(S).
$turns
// Pairs: bands in lanes of two registers; lane m of the one holds order m, of the other order -m.
// Cosine, Sine: the rows m >= 0 and m < 0 of D(S). Columns: l + |m| even for cosines, odd for sines; order -m stands in
// lane m - 1.
template <int Band>
struct Pairs;

$pairs
}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp},
                 {"columns", lane_rows(columns)},
                 {"last", std::to_string(kLastTurnDegree)},
                 {"turns", turns},
                 {"pairs", pairs}});
}

}  // namespace

std::string rings_file(int largest) {
  std::string structs;
  for (int degree = kFirstRingDegree; degree <= largest; ++degree) structs += rings_struct(degree);
  return filled(R"(// The rings on which visibility of degree 2n meets a light of degree n: for transfer_rings.hpp.
//
$stamp#pragma once

namespace sh::batch::detail {

constexpr int kFirstRingDegree = $first;

struct RingPlaces {
  // Of (l, m) among the degrees m .. largest of every order m.
  static constexpr int place(int l, int m, int largest) { return m * (largest + 1) - m * (m - 1) / 2 + l - m; }
};

// kTheta, kResult: by cosine or sine, place and pair of rings; kPole, kPoleResult: by degree; kRatio: by cosine or sine,
// order and angle.
template <int Degree, class T>
struct Rings;
$structs
}  // namespace sh::batch::detail
)",
                {{"stamp", kStamp}, {"first", std::to_string(kFirstRingDegree)}, {"structs", structs}});
}

std::map<std::string, std::string> lane_tables() {
  std::map<std::string, std::string> files{{"batch/triples_l2.hpp", triples_file()}, {"batch/turns.hpp", turns_file()}};
  for (int degree = kFirstOrbitDegree; degree <= kLastOrbitDegree; ++degree) {
    files["batch/orbits_l" + std::to_string(degree) + ".hpp"] = orbit_file(degree);
  }
  return files;
}

}  // namespace sh::codegen::print
