// Writing a file completely or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace sh::codegen {

/// Writes to a temporary beside the file and renames it, so that an interrupted run leaves the old file or the new one.
/// The folder must exist. Throws std::runtime_error, naming the file, when it cannot be written; nothing is left then.
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace sh::codegen
