// shgen tex and shgen markdown from outside: their documents compile, and bad input gives one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

test::CommandResult shgen(const std::string& arguments) {
  return test::run_command(test::quoted(SHFORGE_BIN_DIR "/shgen") + " " + arguments);
}

TEST(TypesetCommand, TexCompilesWithPlainLatex) {
  ASSERT_EQ(test::run_command("command -v pdflatex").exit_code, 0)
      << "pdflatex is missing; install it with: apt-get install --no-install-recommends texlive-latex-base";
  for (const std::string table : {"rotation --degree 3", "gaunt --degree 2", "cap --degree 6", "basis --degree 4",
                                  "cosine-power --degree 4", "product --degree 2", "rotation-quaternion --degree 2",
                                  "turned-zonal --degree 2 --convention scipy", "linear-lobe --degree 3"}) {
    const test::TemporaryFolder folder;
    const auto result =
        test::run_command("cd " + test::quoted(folder.path()) + " && " + test::quoted(SHFORGE_BIN_DIR "/shgen") +
                          " tex " + table + " > table.tex && pdflatex -halt-on-error -interaction=batchmode table.tex");
    EXPECT_EQ(result.exit_code, 0) << table << "\n" << result.out << result.err;
    // A line that runs over the margin means a formula that nobody can read.
    EXPECT_EQ(test::read_file(folder.path() / "table.log").find("Overfull"), std::string::npos) << table;
  }
}

TEST(TypesetCommand, MarkdownHoldsTheSameFormulas) {
  const auto result = shgen("markdown cap --degree 1");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("| $z_{1}$ | $-\\frac{1}{2}\\sqrt{3\\pi}\\,(c^{2} - 1)$ |"), std::string::npos)
      << result.out;
}

TEST(TypesetCommand, OutputIsTheSameInEveryRun) {
  for (const std::string table : {"tex rotation --degree 2", "markdown cosine-power --degree 5"}) {
    EXPECT_EQ(shgen(table).out, shgen(table).out) << table;
  }
}

struct Refusal {
  std::string arguments;
  std::string expected;
};

TEST(TypesetCommand, BadInputIsOneLineAndExitCodeTwo) {
  for (const Refusal& bad :
       {Refusal{"tex cap --degree -1", "0 to 20"}, Refusal{"tex rotation --degree 7", "0 to 6"},
        Refusal{"tex cones --degree 2", "sphere-light"},
        Refusal{"markdown cap --degree 2 --convention godot", "directxmath"},
        Refusal{"tex wigner-d --degree 2 --convention threejs --degree 2", "--degree"},
        Refusal{"tex wigner-d --degree 2 --convention scipy", "--convention"},
        Refusal{"tex gaunt --degree 2 --convention unity", "clamped cosine"}, Refusal{"tex cap", "--degree"},
        Refusal{"tex --degree 2", "family"}, Refusal{"tex cap --degree two", "two"}}) {
    const auto result = shgen(bad.arguments);
    EXPECT_EQ(result.exit_code, 2) << bad.arguments;
    EXPECT_EQ(result.out, "") << bad.arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << bad.arguments << ": " << result.err;
    EXPECT_NE(result.err.find(bad.expected), std::string::npos) << bad.arguments << ": " << result.err;
  }
}

}  // namespace
}  // namespace sh::codegen
