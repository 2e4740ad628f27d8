// The tool shcheck as its users run it: a fixture that runs command lines in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/temporary_folder.hpp"

namespace sh::test {

inline std::string read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

struct Outcome {
  int exit_code;
  std::string out, err;
};

class ShcheckTool : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const auto out = logs_.path() / "stdout";
    const auto err = logs_.path() / "stderr";
    const std::string command =
        std::string(SHFORGE_BIN_DIR) + "/shcheck " + arguments + " >" + out.string() + " 2>" + err.string();
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a fixed command line of a test
    return {WEXITSTATUS(status), read(out), read(err)};
  }

  // Exit 2, nothing on stdout, exactly one line on stderr that begins with the tool's name and contains `part`.
  void expect_refused(const std::string& arguments, const std::string& part) const {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err.find("shcheck: "), 0) << arguments << ": " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << ": " << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << arguments << ": " << outcome.err;
  }

  TemporaryFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();

 private:
  TemporaryFolder logs_;
};

}  // namespace sh::test
