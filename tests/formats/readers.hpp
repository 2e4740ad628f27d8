// The readers of other languages as child processes: read.mjs (engines' npm packages) and read_npz.py (NumPy).
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {

/// Why the engines' packages cannot be used; empty if they can.
inline std::string no_engines() {
  if (std::system("node --version > /dev/null 2>&1") != 0) return "node is not installed";
  if (!std::filesystem::exists(SHFORGE_SOURCE_DIR "/tests/formats/node_modules")) {
    return "tests/formats/node_modules is missing; ./bootstrap test installs it";
  }
  return {};
}

/// Debian's, whose NumPy bootstrap installs.
inline constexpr const char* kPython = "/usr/bin/python3";

inline std::string no_numpy() {
  return std::system("/usr/bin/python3 -c 'import numpy' > /dev/null 2>&1") == 0 ? ""
                                                                                 : "python3-numpy is not installed";
}

/// The JSON that a command prints; its standard error becomes the failure.
inline nlohmann::json printed_by(const std::string& command) {
  const TemporaryFolder folder;
  const std::string out = folder.file("out"), err = folder.file("err");
  const int status = std::system((command + " > " + out + " 2> " + err).c_str());
  EXPECT_EQ(status, 0) << command << "\n" << read_all(err);
  return status == 0 ? nlohmann::json::parse(read_all(out)) : nlohmann::json();
}

/// One reader of read.mjs on a file.
inline nlohmann::json read_by(const std::string& reader, const std::string& file, const std::string& directions = {}) {
  return printed_by("node " SHFORGE_SOURCE_DIR "/tests/formats/read.mjs " + reader + " " + file + " " + directions);
}

}  // namespace sh::prt::test
