// Wisdom: reading, writing, choosing; and `shgen tune` on one small kernel.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "codegen/choose/catalogue.hpp"
#include "codegen/choose/wisdom.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::quoted;
using test::run_command;

TEST(Wisdom, ReadsBackWhatItWrites) {
  const test::TemporaryFolder folder;
  Wisdom wisdom;
  wisdom.set_machine("a processor; a compiler");
  wisdom.set("rotate", 3, "zxz", {27.7, 2.3});
  wisdom.set("basis", 10, "recurrence", {36, 3.5});
  test::write_file(folder.path() / "wisdom.txt", wisdom.to_string());
  const Wisdom read = Wisdom::read(folder.path() / "wisdom.txt");
  EXPECT_EQ(read.to_string(), wisdom.to_string());
  EXPECT_EQ(read.find("rotate", 3, "zxz")->call, 27.7);
  EXPECT_EQ(read.find("rotate", 3, "zxz")->lane, 2.3);
  EXPECT_FALSE(read.find("rotate", 4, "zxz"));
}

TEST(Wisdom, OfAMissingFileIsEmpty) {
  EXPECT_FALSE(Wisdom::read("/nonexistent/wisdom").find("basis", 4, "recurrence"));
}

TEST(Wisdom, RefusesALineThatIsNoMeasurementAndNamesIt) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "wisdom.txt";
  for (const std::string line : {"basis four recurrence 1 1", "basis 4 recurrence 1", "basis 4 recurrence -1 1"}) {
    test::write_file(file, "# head\n" + line + "\n");
    try {
      Wisdom::read(file);
      FAIL() << line;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("wisdom.txt:2: not a measurement"), std::string::npos) << error.what();
    }
  }
}

TEST(Wisdom, RatesARecipeByItsMeanSlowdownOnTheMachinesThatMeasuredAll) {
  const std::vector<std::string> all = {"chebyshev", "recurrence", "parity"};
  std::map<std::string, Wisdom> machines;
  const auto measure = [&machines](const std::string& machine, std::vector<std::pair<std::string, double>> calls) {
    for (const auto& [recipe, ns] : calls) machines[machine].set("basis", 4, recipe, {ns, 1});
  };
  EXPECT_TRUE(mean_slowdowns(machines, "basis", 4, all).empty());
  measure("a", {{"chebyshev", 10}, {"recurrence", 20}});
  EXPECT_TRUE(mean_slowdowns(machines, "basis", 4, all).empty()) << "one is not measured";
  measure("a", {{"parity", 5}});
  measure("b", {{"chebyshev", 32}, {"recurrence", 4}, {"parity", 2}});
  measure("c", {{"chebyshev", 1}, {"recurrence", 100}});
  const std::vector<double> rated = mean_slowdowns(machines, "basis", 4, all);
  ASSERT_EQ(rated.size(), 3U);
  EXPECT_NEAR(rated[0], std::sqrt(2.0 * 16.0), 1e-12);
  EXPECT_NEAR(rated[1], std::sqrt(4.0 * 2.0), 1e-12);
  EXPECT_NEAR(rated[2], 1, 1e-12);
  EXPECT_EQ(mean_slowdowns(machines, "basis", 4, {"recurrence"}), (std::vector<double>{1}));
}

TEST(Wisdom, OfEveryCommittedMachineRatesTheSameChoices) {
  const std::map<std::string, Wisdom>& machines = committed_wisdom();
  EXPECT_GE(machines.size(), 2U);
  int compared = 0;
  for (const Family& family : families()) {
    for (int degree = 0; degree <= family.largest_written; ++degree) {
      const std::vector<Recipe> recipes = recipes_for(family, degree);
      for (const Recipe& recipe : recipes) {
        std::string knowing;
        std::size_t count = 0;
        for (const auto& [machine, wisdom] : machines) {
          if (!wisdom.find(family.name, degree, recipe.name)) continue;
          knowing += " " + machine;
          ++count;
        }
        if (recipes.size() < 2) continue;
        compared += static_cast<int>(count);
        EXPECT_TRUE(count == 0 || count == machines.size())
            << family.name << " " << degree << " " << recipe.name << " was measured only on" << knowing;
      }
    }
  }
  EXPECT_GT(compared, 300);
}

TEST(Tune, NamesAMachineByItsProcessorAndCompiler) {
  const std::string name = machine_name();
  EXPECT_TRUE(name.ends_with("-gcc") || name.ends_with("-clang")) << name;
  EXPECT_TRUE(name.starts_with("amd-") || name.starts_with("intel-") || name.starts_with("other-")) << name;
}

TEST(Tune, MeasuresAKernelAndWritesWhatItLearned) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "wisdom.txt";
  const auto result = test::shgen("tune basis --degree 1 --out " + quoted(file));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("basis 1 "), std::string::npos);
  const Wisdom wisdom = Wisdom::read(file);
  EXPECT_NE(wisdom.to_string().find("Measured on: "), std::string::npos);
  ASSERT_TRUE(wisdom.find("basis", 1, "recurrence"));
  EXPECT_GT(wisdom.find("basis", 1, "recurrence")->call, 0);
}

TEST(Tune, BadArgumentsAreOneLineAndExitTwo) {
  test::expect_refused("tune nothing", "unknown family");
  test::expect_refused("tune basis --degree 99", "expected degree 0 to 20, got 99");
  test::expect_refused("tune basis --degree 1 --machine ../amd",
                       "expected small letters, digits and hyphens, got ../amd");
  const auto unwritable = test::shgen("tune basis --degree 0 --out /dev/null/here");
  EXPECT_EQ(unwritable.exit_code, 2);
  EXPECT_NE(unwritable.err.find("shgen: /dev/null/here: "), std::string::npos) << unwritable.err;
  const auto without =
      run_command("CXX=/nonexistent/c++ " + std::string(SHFORGE_BIN_DIR) + "/shgen tune basis --degree 1");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.err.find("expected the name of a C++ compiler in CXX"), std::string::npos) << without.err;
}

}  // namespace
}  // namespace sh::codegen
