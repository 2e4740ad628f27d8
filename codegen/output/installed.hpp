// Where the tool finds its data once it is installed, source tree or not.
#pragma once

#include <filesystem>

namespace sh::codegen {

/// PREFIX/path where the running tool is PREFIX/bin/shgen and that file or folder exists; `otherwise` elsewhere.
std::filesystem::path installed_or(const std::filesystem::path& path, const std::filesystem::path& otherwise);

}  // namespace sh::codegen
