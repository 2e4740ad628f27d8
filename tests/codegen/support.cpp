#include "tests/codegen/support.hpp"

#include <sys/wait.h>

#include <algorithm>
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

void SmallKernel::output(NodeId node) {
  kernel.outputs.push_back({node, "value " + std::to_string(kernel.outputs.size())});
  kernel.results.front().shape.front() = static_cast<int>(kernel.outputs.size());
}

Kernel kernel_of(const std::string& family, const std::string& recipe, int degree) {
  const Family& f = find_family(family);
  return kernel_stages(f, find_recipe(f, degree, recipe), degree).back().kernel;
}

Cost cost_of(const std::string& family, const std::string& recipe, int degree) {
  return cost(kernel_of(family, recipe, degree));
}

Cost cost_of(const std::string& family, int degree) {
  return cost_of(family, fastest_recipe(find_family(family), degree).name, degree);
}

FinishedKernel fastest(const std::string& family, int degree) {
  return preferred_kernel(find_family(family), degree, Prefer::kSpeed);
}

std::vector<int> some_degrees(const Family& family) {
  std::vector<int> written;
  for (int degree = 0; degree <= family.largest_written; ++degree) {
    if (!recipes_for(family, degree).empty()) written.push_back(degree);
  }
  std::vector<int> chosen{written.front(), written[written.size() / 2], written.back()};
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

const std::vector<FinishedKernel>& emitted_kernels() {
  static const std::vector<FinishedKernel> kKernels = [] {
    std::vector<FinishedKernel> kernels;
    for (const Family& family : families()) {
      for (const int degree : some_degrees(family)) kernels.push_back(preferred_kernel(family, degree, Prefer::kSpeed));
    }
    return kernels;
  }();
  return kKernels;
}

CommandResult run_command(const std::string& command) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const fs::path err = folder.path() / "err";
  const int status = std::system(("{ " + command + "\n} >" + quoted(out) + " 2>" + quoted(err)).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

CommandResult shgen(const std::string& arguments) {
  return run_command(quoted(SHFORGE_BIN_DIR "/shgen") + " " + arguments);
}

CommandResult expect_refused(const std::string& arguments, const std::string& part) {
  CommandResult result = shgen(arguments);
  EXPECT_EQ(result.exit_code, 2) << arguments;
  EXPECT_EQ(lines(result.err), 1) << arguments << ": " << result.err;
  EXPECT_EQ(result.err.find("shgen: "), 0U) << arguments << ": " << result.err;
  EXPECT_TRUE(contains(result.err, part)) << arguments << ": " << result.err;
  return result;
}

std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

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
