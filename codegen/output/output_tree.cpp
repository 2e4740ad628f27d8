#include "codegen/output/output_tree.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/read_file.hpp"

namespace sh::codegen {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> content_of(const fs::path& path) {
  return fs::is_regular_file(path) ? std::optional(output::read_file(path.string())) : std::nullopt;
}

// Describes the line and the column of the first byte that differs.
std::string first_difference(const std::string& is, const std::string& should_be) {
  const auto [a, b] = std::mismatch(is.begin(), is.end(), should_be.begin(), should_be.end());
  return "first in line " + std::to_string(1 + std::count(is.begin(), a, '\n'));
}

}  // namespace

const std::set<std::string>& handwritten_files() {
  static const std::set<std::string> kFiles{"CMakeLists.txt", "README.md", "cmake/per_instruction_set.cmake"};
  return kFiles;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw std::runtime_error(folder.string() +
                             ": expected a folder to write to, got a path at which shgen cannot make one");
}

void require_existing(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw std::runtime_error(folder.string() + ": expected a folder with the generated files, got none");
}

std::vector<std::string> write_tree(const fs::path& folder, const RenderedFiles& files) {
  std::vector<std::string> written;
  for (const auto& [name, content] : files) {
    if (content_of(folder / name) == content) continue;
    std::error_code ignored;  // write_file reports a missing folder
    fs::create_directories((folder / name).parent_path(), ignored);
    output::write_file((folder / name).string(), content);
    written.push_back(name);
  }
  return written;
}

std::vector<std::string> compare_files(const fs::path& folder, const RenderedFiles& files) {
  require_existing(folder);
  std::vector<std::string> differences;
  for (const auto& [name, content] : files) {
    const std::optional<std::string> found = content_of(folder / name);
    if (!found) {
      differences.push_back(name + ": missing");
    } else if (*found != content) {
      differences.push_back(name + ": differs from the output of the generator, " + first_difference(*found, content));
    }
  }
  return differences;
}

std::vector<std::string> compare_tree(const fs::path& folder, const RenderedFiles& files) {
  std::vector<std::string> differences = compare_files(folder, files);
  std::set<std::string> present;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) present.insert(fs::relative(entry.path(), folder).generic_string());
  }
  for (const std::string& name : present) {
    if (files.count(name) == 0 && handwritten_files().count(name) == 0) {
      differences.push_back(name + ": extra, the generator does not write it");
    }
  }
  return differences;
}

fs::path installed_or(const fs::path& path, const fs::path& otherwise) {
  std::error_code unknown;
  const fs::path tool = fs::read_symlink("/proc/self/exe", unknown);  // Linux; empty elsewhere
  const fs::path found = tool.parent_path().parent_path() / path;
  return !unknown && fs::exists(found) ? found : otherwise;
}

}  // namespace sh::codegen
