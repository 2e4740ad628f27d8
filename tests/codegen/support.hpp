// Shared by the generator's tests: small kernels, running a command, temporary folders.
#pragma once

#include <filesystem>
#include <string>

#include "codegen/ir/ir.hpp"
#include "tests/temporary_folder.hpp"

namespace sh::codegen::test {

/// A kernel of inputs x, y, z without outputs; add nodes with a Builder, then outputs with add_output.
Kernel empty_kernel();
void add_output(Kernel& kernel, NodeId node);

struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a shell command line.
CommandResult run_command(const std::string& command);

/// `text` in single quotes for the shell.
std::string quoted(const std::string& text);

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& content);

using sh::test::TemporaryFolder;

}  // namespace sh::codegen::test
