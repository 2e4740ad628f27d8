// The tables of the READMEs that shgen prints are up to date; those of times, which no test can repeat, name their commands.
#include "tests/readme_tables.hpp"

#include <gtest/gtest.h>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

TEST(Readmes, ShowTheTablesThatTheirCommandsPrint) {
  const std::string root = SHFORGE_SOURCE_DIR;
  std::size_t count = 0;
  for (const char* page : {"/README.md", "/generated/README.md"}) {
    for (const auto& [command, table] : sh::test::parts_of_page(root + page)) {
      if (!command.starts_with("shgen ")) continue;
      ++count;
      const test::CommandResult printed = test::run_command("cd '" + root + "' && '" SHFORGE_BIN_DIR "/'" + command);
      EXPECT_EQ(printed.exit_code, 0) << printed.err;
      EXPECT_EQ(printed.out, table) << page << ": " << command;
    }
  }
  EXPECT_GE(count, 2U);
}

}  // namespace
}  // namespace sh::codegen
