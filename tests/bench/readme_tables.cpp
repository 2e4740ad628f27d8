// `readme_tables FOLDER PAGE...`: runs the command above each table of the pages, a program of FOLDER, and puts its output in
// the table's place. A page is replaced completely or not at all.
#include "tests/readme_tables.hpp"

#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "numeric/output/atomic_file.hpp"

namespace {

// What a command prints. A benchmark ends with 1 if a target is missed, and its table says so.
std::string printed_by(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(command + ": cannot run it");
  std::string text;
  std::array<char, 4096> some{};
  for (std::size_t n = 0; (n = std::fread(some.data(), 1, some.size(), pipe)) > 0;) text.append(some.data(), n);
  const int status = pclose(pipe);
  if (status != 0 && status != 256) throw std::runtime_error(command + ": failed");
  if (!text.starts_with('|')) throw std::runtime_error(command + ": expected a table");
  return text;
}

void rewrite(const std::string& folder, const std::string& page) {
  std::string text;
  for (const auto& [command, part] : sh::test::parts_of_page(page)) {
    text += command.empty() ? part : printed_by("'" + folder + "/'" + command);
  }
  sh::output::write_file(page, text);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw std::invalid_argument("expected the folder of the programs and pages");
    for (int i = 2; i < argc; ++i) rewrite(argv[1], argv[i]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "readme_tables: %s\n", error.what());
    return 2;
  }
}
