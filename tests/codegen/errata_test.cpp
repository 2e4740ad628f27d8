// `shgen errata` from outside: the table, its filters, the JSON file, exit codes, bad arguments.
#include "codegen/commands/errata.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using errata::Entry;
using errata::Source;
using test::contains;
using test::shgen;

TEST(Errata, AWrongFormulaIsShownWithTheCorrectOne) {
  const auto result = shgen("errata B-08");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "B: Brown, Spherical Harmonic Basis Functions, 2004\n")) << result.out;
  EXPECT_TRUE(contains(result.out, "B-08    wrong                  Table l <= 2, labels\n")) << result.out;
  EXPECT_TRUE(contains(result.out, "        correct   Y_1^-1 = sqrt3/(2 sqrt pi) y, Y_1^1")) << result.out;
  EXPECT_TRUE(contains(result.err, "1 entries decided in ")) << result.err;
  EXPECT_TRUE(contains(result.err, ": 1 wrong\n")) << result.err;
}

TEST(Errata, ReadingsSayWhichHoldAndWhichFail) {
  const auto result = shgen("errata BL-10");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "holds     0 <= b < pi, cos b other than m/l\n")) << result.out;
  EXPECT_TRUE(contains(result.out, "fails     cos b = m/l, as b = pi/2 with m = 0\n")) << result.out;
}

TEST(Errata, AMeasuredClaimShowsItsNumberAndTheToolThatMeasuresIt) {
  const auto result = shgen("errata S-33");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "average squared error: 0.7 % (measured by shcheck report)\n")) << result.out;
  EXPECT_TRUE(contains(result.out, "fails     six 16 x 16 images")) << result.out;
}

TEST(Errata, ASourceAndAVerdictChooseEntries) {
  const auto result = shgen("errata IR CH --verdict wrong");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* id : {"IR-09 ", "CH-08 ", "CH-10 "}) EXPECT_TRUE(contains(result.out, id)) << id;
  EXPECT_FALSE(contains(result.out, "IR-04 "));
  EXPECT_TRUE(contains(result.err, "3 entries ")) << result.err;
}

TEST(Errata, NoLineIsLongerThanAPage) {
  std::istringstream table(shgen("errata B RH").out);
  for (std::string line; std::getline(table, line);) EXPECT_LE(line.size(), 118U) << line;
}

TEST(Errata, TheJsonFileHoldsEveryEntryOfTheSources) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "errata.json";
  const auto result = shgen("errata --json " + test::quoted(file));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto report = nlohmann::json::parse(test::read_file(file));
  const auto sources = errata::all_sources();
  ASSERT_EQ(report.size(), sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    EXPECT_EQ(report[i].at("source"), sources[i].prefix);
    ASSERT_EQ(report[i].at("entries").size(), sources[i].entries.size());
    for (std::size_t k = 0; k < sources[i].entries.size(); ++k) {
      const auto& entry = report[i].at("entries")[k];
      EXPECT_EQ(entry.at("id"), sources[i].entries[k].place.id);
      EXPECT_EQ(entry.at("verdict"), to_string(recorded_verdict(sources[i].entries[k]))) << entry.at("id");
      EXPECT_EQ(entry.at("contradiction"), "");
      EXPECT_EQ(entry.at("readings").size(), sources[i].entries[k].readings.size());
      for (const char* key : {"where", "kind", "print", "printed", "stated", "correct", "remark", "seconds"}) {
        EXPECT_TRUE(entry.contains(key)) << key;
      }
    }
  }
}

std::vector<Source> source_of(const Entry& entry) { return {{"X", "a source", "source", {entry}}}; }

TEST(Errata, ARecordedVerdictThatTheDecisionsContradictIsNamed) {
  const Entry wrong{
      .place = {"X-1", "Eq. 1"}, .printed = "1 = 1", .readings = {{"as printed", false, "1 == 1", "", ""}}};
  const Entry unfit{
      .place = {"X-1", "Eq. 1"}, .printed = "1 = 2", .readings = {{"as printed", false, "1 == 2", "", ""}}};
  for (const Entry& entry : {wrong, unfit}) {
    std::ostringstream out;
    std::ostringstream progress;
    EXPECT_FALSE(errata(source_of(entry), {}, out, progress));
    EXPECT_TRUE(contains(out.str(), "X-1     CONTRADICTED")) << out.str();
    EXPECT_TRUE(contains(progress.str(), "contradicted: ")) << progress.str();
    EXPECT_TRUE(contains(progress.str(), "X-1")) << progress.str();
  }
}

TEST(Errata, BadArgumentsAreOneLineAndExitTwo) {
  const char* const cases[][2] = {{"B-99", "B (B-02 to B-19)"},
                                  {"Brown", "GP (GP-01 to GP-54)"},
                                  {"B- ", "RH (RH-02 to "},
                                  {"--verdict right", "'correct', 'correct under reading', 'wrong', 'lost, derived'"},
                                  {"B-08 --json /no/such/folder/errata.json", "/no/such/folder/errata.json"}};
  for (const auto& [arguments, mention] : cases) test::expect_refused(std::string("errata ") + arguments, mention);
}

}  // namespace
}  // namespace sh::codegen
