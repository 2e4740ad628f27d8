#include "tests/codegen/support.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sh::codegen::test {

namespace fs = std::filesystem;

Kernel empty_kernel() {
  Kernel kernel;
  kernel.name = "probe";
  kernel.parameters = {{"x", {}}, {"y", {}}, {"z", {}}};
  kernel.results = {{"out", {0}}};
  Builder build(kernel);
  build.input(0, "x");
  build.input(1, "y");
  build.input(2, "z");
  return kernel;
}

void add_output(Kernel& kernel, NodeId node) {
  kernel.outputs.push_back({node, "value " + std::to_string(kernel.outputs.size())});
  kernel.results.front().shape.front() = static_cast<int>(kernel.outputs.size());
}

CommandResult run_command(const std::string& command) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const fs::path err = folder.path() / "err";
  const int status = std::system(("{ " + command + "\n} >" + quoted(out) + " 2>" + quoted(err)).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_file(const fs::path& path, const std::string& content) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << content;
}

}  // namespace sh::codegen::test
