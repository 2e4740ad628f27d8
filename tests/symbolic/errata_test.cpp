// The list of the sources' errata: every recorded verdict is the one that exact decisions give, and no decision is
// vacuous.
#include "numeric/errata/errata.hpp"

#include <cln/rational.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/decide.hpp"
#include "symbolic/errata/definitions.hpp"
#include "symbolic/errata/statement.hpp"

namespace sh::symbolic::errata {
namespace {

using sh::errata::Entry;
using sh::errata::Reading;
using sh::errata::Source;
using sh::errata::Verdict;

const std::vector<Source>& sources() {
  static const std::vector<Source> all = sh::errata::all_sources();
  return all;
}

TEST(ErrataList, EveryEntryHasItsOwnNumberOfItsSource) {
  std::set<std::string> given;
  for (const Source& source : sources()) {
    EXPECT_FALSE(source.entries.empty()) << source.name;
    for (const Entry& entry : source.entries) {
      EXPECT_EQ(entry.place.id.substr(0, entry.place.id.find('-')), source.prefix);
      EXPECT_TRUE(given.insert(entry.place.id).second) << entry.place.id << " is given twice";
      EXPECT_FALSE(entry.place.where.empty() || entry.printed.empty()) << entry.place.id;
    }
  }
}

// The mistakes that readers look for: none may drop out of the list or change its verdict unnoticed.
TEST(ErrataList, HoldsEveryKnownMistake) {
  const std::set<std::string> expected{"G-04", "G-19", "G-22",  "G-23",  "G-27",  "G-32",  "G-47",  "G-53",  "G-73",
                                       "G-94", "G-97", "GP-01", "GP-02", "GP-07", "GP-20", "GP-29", "GP-50", "S-18",
                                       "S-24", "B-02", "B-08",  "B-10",  "IR-09", "CH-08", "CH-10", "RH-11"};
  std::set<std::string> wrong;
  for (const Source& source : sources()) {
    for (const Entry& entry : source.entries) {
      if (sh::errata::recorded_verdict(entry) == Verdict::kWrong) wrong.insert(entry.place.id);
    }
  }
  EXPECT_EQ(wrong, expected);
}

// The parts of a statement between ; and &, each a relation, some after the ranges of its indices.
struct Piece {
  std::size_t begin;
  std::size_t end;
};
std::vector<Piece> relations(const std::string& statement) {
  std::vector<Piece> pieces;
  for (std::size_t begin = 0; begin < statement.size();) {
    const std::size_t end = std::min(statement.find_first_of(";&", begin), statement.size());
    const std::size_t colon = statement.substr(0, end).find(':', begin);
    pieces.push_back({colon == std::string::npos ? begin : colon + 1, end});
    begin = end + 1;
  }
  return pieces;
}

// Copies of the statement with one number of that relation raised by one, or with 1 added to its left side.
std::vector<std::string> spoiled(const std::string& statement, const Piece& relation) {
  std::vector<std::string> copies;
  constexpr const char* kDigits = "0123456789";
  for (std::size_t i = statement.find_first_of(kDigits, relation.begin); i < relation.end;) {
    const std::size_t end = std::min(statement.find_first_not_of(kDigits, i), statement.size());
    const std::string number = std::to_string(std::stol(statement.substr(i, end - i)) + 1);
    copies.push_back(statement.substr(0, i) + number + statement.substr(end));
    i = statement.find_first_of(kDigits, end);
  }
  const std::size_t equal = statement.find(" == ", relation.begin);
  if (equal < relation.end) copies.push_back(std::string(statement).insert(equal, "+1"));
  return copies;
}

// Not where a copy means nothing: a pole, an order beyond its degree.
bool is_refuted(const std::string& statement) {
  try {
    return !holds(statement);
  } catch (const std::invalid_argument&) {
    return false;
  }
}

class ErrataOfSource : public testing::TestWithParam<std::size_t> {};

TEST_P(ErrataOfSource, RecordsWhatExactDecisionsGive) {
  for (const Entry& entry : sources()[GetParam()].entries) {
    SCOPED_TRACE(entry.place.id + " " + entry.place.where);
    const Decision decision = decide(entry);
    EXPECT_EQ(decision.contradiction, "");
    EXPECT_EQ(decision.verdict, sh::errata::recorded_verdict(entry));
  }
}

// A changed number may leave a zero unchanged, so one refuted change of each relation is enough.
TEST_P(ErrataOfSource, RefutesEveryRelationWithAChangedNumber) {
  for (const Entry& entry : sources()[GetParam()].entries) {
    std::vector<std::string> right{entry.correct_statement};
    for (const Reading& reading : entry.readings) {
      if (reading.holds) right.push_back(reading.statement);
    }
    for (const std::string& statement : right) {
      for (const Piece& relation : relations(statement)) {
        if (statement.substr(relation.begin, relation.end - relation.begin).find_first_of("<>") != std::string::npos) {
          continue;  // a bound, which need not be tight
        }
        const std::vector<std::string> copies = spoiled(statement, relation);
        EXPECT_TRUE(copies.empty() || std::ranges::any_of(copies, is_refuted))
            << entry.place.id << ": " << copies.front();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sources, ErrataOfSource, testing::Range<std::size_t>(0, 9),
                         [](const auto& source) { return sources()[source.param].prefix; });

Entry entry_of(bool first_holds, const std::string& first, const std::string& correct = "") {
  return {.place = {"X-1", "Eq. 1"},
          .printed = "a",
          .readings = {{"a", first_holds, first, "", ""}},
          .correct_statement = correct};
}

TEST(ErrataDecision, ComparesWhatIsRecordedWithWhatIsDecided) {
  EXPECT_EQ(decide(entry_of(true, "1 == 1")).contradiction, "");
  EXPECT_EQ(decide(entry_of(false, "1 == 2", "1 == 1")).verdict, Verdict::kWrong);
  EXPECT_EQ(decide(entry_of(true, "1 == 2")).contradiction, "X-1: 'a' is recorded as right, but fails");
  EXPECT_EQ(decide(entry_of(false, "1 == 1")).contradiction, "X-1: 'a' is recorded as wrong, but holds");
}

TEST(ErrataDecision, AsksForADecidedCorrection) {
  EXPECT_EQ(decide(entry_of(false, "1 == 2")).contradiction, "X-1: nothing decides the correct formula");
  EXPECT_EQ(decide(entry_of(false, "1 == 2", "1 == 3")).contradiction, "X-1: the correct formula fails");
  EXPECT_EQ(decide(entry_of(true, "")).contradiction, "X-1: nothing decides 'a'");
  EXPECT_THROW(decide(entry_of(true, "1 = 1")), std::invalid_argument);
}

TEST(ErrataStatement, SpeaksOfTheBasisOfTheProject) {
  const std::array<cln::cl_RA, 3> rational{cln::cl_RA(2) / 7, cln::cl_RA(-3) / 7, cln::cl_RA(6) / 7};
  const GiNaC::exmap point{
      {symbol("x"), GiNaC::numeric(2, 7)}, {symbol("y"), GiNaC::numeric(-3, 7)}, {symbol("z"), GiNaC::numeric(6, 7)}};
  for (int i = 0; i < 49; ++i) {
    const auto [l, m] = degree_order(i);
    const BasisFunction y = basis_function(l, m);
    const double value =
        cln::double_approx(y.factor.evaluate(30)) * cln::double_approx(y.homogeneous.evaluate(rational));
    EXPECT_NEAR(GiNaC::ex_to<GiNaC::numeric>(real_harmonic(l, m).subs(point).evalf()).to_double(), value, 1e-14) << i;
  }
}

TEST(ErrataStatement, IsExactAboutRootsPiAndTheSphere) {
  EXPECT_TRUE(holds("sqrt(12)+sqrt(1/3) == 7/sqrt(3)"));
  EXPECT_TRUE(holds("sqrt(15/(4*Pi)) == sqrt(3/Pi)*sqrt(5)/2"));
  EXPECT_FALSE(holds("sqrt(2)+sqrt(3) == sqrt(10)"));
  EXPECT_TRUE(holds("x^2+y^2 == 1-z^2; c/s == c*s/(1-c^2)"));
  EXPECT_FALSE(holds("x^2+y^2 == 1+z^2"));
}

TEST(ErrataStatement, RunsOverItsRangesAndRoundsAtThePrintedDigit) {
  EXPECT_TRUE(holds("l=0..3, m=-l..l: m^2 <= l^2"));
  EXPECT_FALSE(holds("l=0..3, m=-l..l: m^2 < l^2"));
  EXPECT_TRUE(holds("Pi ~ 3.14; Pi ~ 3; -Pi ~ -3.1416"));
  EXPECT_FALSE(holds("Pi ~ 3.15"));
  EXPECT_THROW(holds("x < 1"), std::invalid_argument);
  EXPECT_THROW(holds("unknown == 1"), std::invalid_argument);
}

}  // namespace
}  // namespace sh::symbolic::errata
