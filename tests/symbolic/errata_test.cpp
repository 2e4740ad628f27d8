// Every formula of the sources has a verdict, and it is the one that exact decisions give.
#include "symbolic/errata/errata.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <string>

namespace sh::symbolic::errata {
namespace {

// Identifiers of the committed list of everything that the sources print.
std::set<std::string> inventory() {
  std::set<std::string> ids;
  std::ifstream file(SHFORGE_SOURCE_DIR "/tests/data/errata_inventory.txt");
  std::string line;
  while (std::getline(file, line)) {
    if (!line.empty() && line[0] != '#') ids.insert(line.substr(0, line.find(' ')));
  }
  return ids;
}

TEST(Errata, LeaveOutNothingThatTheSourcesPrint) {
  std::set<std::string> given;
  const std::vector<Source> sources = all_sources();
  for (const Source& source : sources) {
    for (const Entry& entry : source.entries) {
      EXPECT_EQ(entry.id.substr(0, entry.id.find('-')), source.prefix);
      EXPECT_TRUE(given.insert(entry.id).second) << entry.id << " is given twice";
    }
  }
  EXPECT_EQ(given, inventory());
}

// Identifier -> what is recorded of its decisions: the verdict and, for every reading, whether it holds.
std::map<std::string, std::string> recorded_decisions() {
  std::map<std::string, std::string> decisions;
  std::ifstream file(SHFORGE_SOURCE_DIR "/tests/data/errata_decisions.txt");
  std::string line;
  while (std::getline(file, line)) {
    if (!line.empty() && line[0] != '#') decisions[line.substr(0, line.find(' '))] = line.substr(line.find(' ') + 1);
  }
  return decisions;
}

std::string decisions_of(const Entry& entry) {
  std::string text = to_string(decide(entry));
  for (const Reading& reading : entry.readings) text += reading.holds() ? ", holds" : ", fails";
  return text;
}

class ErrataOfSource : public testing::TestWithParam<std::size_t> {};

TEST_P(ErrataOfSource, EveryVerdictFollowsFromExactDecisions) {
  const std::vector<Source> sources = all_sources();
  const std::map<std::string, std::string> recorded = recorded_decisions();
  for (const Entry& entry : sources[GetParam()].entries) {
    SCOPED_TRACE(entry.id + " " + entry.where);
    EXPECT_FALSE(entry.printed.empty());
    EXPECT_EQ(to_string(decide(entry)), to_string(entry.verdict));
    ASSERT_TRUE(recorded.count(entry.id));
    EXPECT_EQ(decisions_of(entry), recorded.at(entry.id));
  }
}

INSTANTIATE_TEST_SUITE_P(Sources, ErrataOfSource, testing::Range<std::size_t>(0, 8),
                         [](const auto& source) { return all_sources()[source.param].prefix; });

bool yes() { return true; }
bool no() { return false; }

TEST(Errata, AVerdictComesFromTheReadings) {
  Entry entry;
  entry.id = "X-1";
  entry.readings = {{"a", yes}};
  EXPECT_EQ(decide(entry), Verdict::kCorrect);
  entry.readings = {{"a", yes}, {"b", no}};
  EXPECT_EQ(decide(entry), Verdict::kUnderReading);
  entry.readings = {{"a", no}};
  EXPECT_THROW(decide(entry), std::logic_error);  // and what is right?
  entry.correct = "c";
  entry.correct_holds = yes;
  EXPECT_EQ(decide(entry), Verdict::kWrong);
  entry.correct_holds = no;
  EXPECT_THROW(decide(entry), std::logic_error);
}

TEST(Errata, AVerdictWithoutADecisionIsRefused) {
  Entry entry;
  entry.id = "X-1";
  entry.verdict = Verdict::kCorrect;
  entry.remark = "obviously";
  EXPECT_THROW(decide(entry), std::logic_error);
  entry.verdict = Verdict::kUndecided;
  EXPECT_EQ(decide(entry), Verdict::kUndecided);
  entry.remark.clear();
  EXPECT_THROW(decide(entry), std::logic_error);
}

}  // namespace
}  // namespace sh::symbolic::errata
