// Shared by the generator's tests: small kernels, kernels of families, running a command, temporary folders.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "codegen/choose/catalogue.hpp"
#include "tests/temporary_folder.hpp"

namespace sh::codegen::test {

/// A kernel of inputs x, y, z without outputs.
Kernel empty_kernel();

/// Tests of small kernels: inputs x, y, z; a test adds nodes with `build` and outputs with `output`.
class SmallKernel : public testing::Test {
 protected:
  static constexpr NodeId kX = 0;
  static constexpr NodeId kY = 1;
  static constexpr NodeId kZ = 2;

  void output(NodeId node);

  Kernel kernel = empty_kernel();
  Builder build{kernel};
};

/// The finished nodes of one recipe of a family.
Kernel kernel_of(const std::string& family, const std::string& recipe, int degree);
/// The operations of one recipe, and of the recipe that `shgen write` takes.
Cost cost_of(const std::string& family, const std::string& recipe, int degree);
Cost cost_of(const std::string& family, int degree);
/// The kernel that `shgen write` takes, with its errors.
FinishedKernel fastest(const std::string& family, int degree);

/// The lowest, a middle and the highest degree that `shgen list` names for the family; fewer if it has fewer.
std::vector<int> some_degrees(const Family& family);

/// The output of `shgen emit FAMILY --degree N` for every family at some_degrees. Each process computes it once,
/// because it takes long.
const std::vector<FinishedKernel>& emitted_kernels();

/// Expects that the file of each kernel compiles alone in the language. Defined in language_test.cpp.
void expect_files_compile_alone(const std::string& language, const std::vector<FinishedKernel>& kernels);

struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a shell command line.
CommandResult run_command(const std::string& command);
/// Runs `shgen` with the arguments.
CommandResult shgen(const std::string& arguments);
/// Expects that the tool refuses the arguments: exit code 2 and one line on standard error, which contains `part`.
CommandResult expect_refused(const std::string& arguments, const std::string& part);

std::ptrdiff_t lines(const std::string& text);
bool contains(const std::string& text, const std::string& part);

/// `text` in single quotes for the shell.
std::string quoted(const std::string& text);

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& content);

using sh::test::TemporaryFolder;

}  // namespace sh::codegen::test
