#include "codegen/output/installed.hpp"

namespace sh::codegen {

namespace fs = std::filesystem;

fs::path installed_or(const fs::path& path, const fs::path& otherwise) {
  std::error_code unknown;
  const fs::path tool = fs::read_symlink("/proc/self/exe", unknown);  // Linux; empty elsewhere
  const fs::path found = tool.parent_path().parent_path() / path;
  return !unknown && fs::exists(found) ? found : otherwise;
}

}  // namespace sh::codegen
