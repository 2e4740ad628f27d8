// Commands from outside: the documents of `shgen tex` and `shgen markdown` compile; bad arguments give one line.
#include <gtest/gtest.h>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

using test::shgen;

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

TEST(TypesetCommand, BadInputIsOneLineAndExitCodeTwo) {
  const char* const cases[][2] = {{"tex cap --degree -1", "0 to 20"},
                                  {"tex rotation --degree 7", "0 to 6"},
                                  {"tex cones --degree 2", "sphere-light"},
                                  {"markdown cap --degree 2 --convention godot", "directxmath"},
                                  {"tex wigner-d --degree 2 --convention threejs --degree 2", "--degree"},
                                  {"tex wigner-d --degree 2 --convention scipy", "--convention"},
                                  {"tex gaunt --degree 2 --convention unity", "clamped cosine"},
                                  {"tex cap", "--degree"},
                                  {"tex --degree 2", "family"},
                                  {"tex cap --degree two", "two"}};
  for (const auto& [arguments, part] : cases) {
    EXPECT_EQ(test::expect_refused(arguments, part).out, "") << arguments;
  }
}

}  // namespace
}  // namespace sh::codegen
