// Seconds that the compiler takes for the widest generated header, and the generator for everything it writes.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

namespace fs = std::filesystem;

double seconds_of(const std::string& command) {
  const auto start = std::chrono::steady_clock::now();
  if (std::system(command.c_str()) != 0) throw std::runtime_error("this command failed: " + command);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The longest header of one kernel, which a call of it instantiates.
fs::path widest_header() {
  fs::path widest;
  std::uintmax_t size = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SHFORGE_SOURCE_DIR) / "generated/cpp")) {
    if (entry.file_size() <= size) continue;
    size = entry.file_size();
    widest = entry.path();
  }
  return widest;
}

// "T x, const T* c" of the kernel `name` in its header -> "T(), nullptr": arguments that compile.
std::string null_arguments(const fs::path& header, const std::string& name) {
  std::ifstream stream(header);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  std::size_t at = text.find(" " + name + "(");
  const std::size_t end = text.find(')', at);
  std::string arguments;
  for (at += name.size() + 2; at < end; at = text.find(',', at) + 1) {
    const std::string one = text.substr(at, std::min(text.find(',', at), end) - at);
    arguments += std::string(arguments.empty() ? "" : ", ") + (one.find('*') == std::string::npos ? "v" : "a");
    if (text.find(',', at) > end) break;
  }
  return arguments;
}

}  // namespace

void build(Table& table) {
  table.section("Building, s");
  const fs::path folder = fs::temp_directory_path() / "shforge-bench";
  fs::create_directories(folder);
  const fs::path header = widest_header();
  const std::string name = header.stem();
  std::ofstream(folder / "widest.cpp") << "#include \"" << header.string() << "\"\nvoid use(float* a, float v);\n"
                                       << "void use(float* a, float v) { (void)v; (void)sh::" << name << "("
                                       << null_arguments(header, name) << "); }\n";
  table.figure("compile " + header.filename().string() + ", g++ -O2 or as configured", SHFORGE_COMPILER,
               seconds_of(std::string(SHFORGE_COMPILER) + " -std=c++17 -O2 -c '" + (folder / "widest.cpp").string() +
                          "' -o '" + (folder / "widest.o").string() + "'"),
               10);
  table.figure(
      "shgen write", "everything",
      seconds_of(std::string(SHFORGE_SHGEN) + " write --out '" + (folder / "generated").string() + "' >/dev/null 2>&1"),
      120);
  fs::remove_all(folder);
}

}  // namespace sh::bench
