// Writes a set of rendered files to a folder, or compares it with one, byte for byte; where an installed tool finds its
// data.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sh::codegen {

using RenderedFiles = std::map<std::string, std::string>;  ///< relative path -> content

/// Handwritten files of generated/, which are neither written nor compared.
const std::set<std::string>& handwritten_files();

/// Makes the folder where there is none. Throws std::runtime_error naming it when that is impossible.
void make_folder(const std::filesystem::path& folder);
/// Throws std::runtime_error when there is no such folder.
void require_existing(const std::filesystem::path& folder);

/// Writes what differs; each file appears complete or not at all. Returns the paths written. Throws std::runtime_error
/// naming the file that could not be written.
std::vector<std::string> write_tree(const std::filesystem::path& folder, const RenderedFiles& files);

/// One line for each file that differs or is missing; empty when equal. Throws std::runtime_error when the folder does
/// not exist.
std::vector<std::string> compare_files(const std::filesystem::path& folder, const RenderedFiles& files);

/// The same, and one line for each file that should not be there.
std::vector<std::string> compare_tree(const std::filesystem::path& folder, const RenderedFiles& files);

/// PREFIX/path where the running tool is PREFIX/bin/shgen and that file or folder exists; `otherwise` elsewhere.
std::filesystem::path installed_or(const std::filesystem::path& path, const std::filesystem::path& otherwise);

}  // namespace sh::codegen
