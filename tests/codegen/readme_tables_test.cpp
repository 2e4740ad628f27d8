// The tables of the READMEs are the output of the commands that stand above them: "<!-- shgen list basis --table -->".
#include <gtest/gtest.h>

#include <fstream>

#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

// Every command of a page, with the lines of the table below it.
std::vector<std::pair<std::string, std::string>> tables_of(const std::string& page) {
  const std::string begin = "<!-- shgen ";
  const std::string end = " -->";
  std::vector<std::pair<std::string, std::string>> tables;
  std::ifstream file(page);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(begin) || !line.ends_with(end)) continue;
    auto& [command, table] = tables.emplace_back();
    command = line.substr(begin.size(), line.size() - begin.size() - end.size());
    while (std::getline(file, line) && line.starts_with('|')) table += line + "\n";
  }
  return tables;
}

TEST(Readmes, ShowTheTablesThatTheirCommandsPrint) {
  const std::string root = SHFORGE_SOURCE_DIR;
  std::size_t count = 0;
  for (const char* page : {"/README.md", "/generated/README.md"}) {
    for (const auto& [command, table] : tables_of(root + page)) {
      ++count;
      const test::CommandResult printed =
          test::run_command("cd '" + root + "' && '" SHFORGE_BIN_DIR "/shgen' " + command);
      EXPECT_EQ(printed.exit_code, 0) << printed.err;
      EXPECT_EQ(printed.out, table) << page << ": " << command;
    }
  }
  EXPECT_GE(count, 2U);
}

}  // namespace
}  // namespace sh::codegen
