// Writes a set of rendered files to a folder, or compares the set with a folder byte for byte. Also finds the data of
// an installed tool.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sh::codegen {

using RenderedFiles = std::map<std::string, std::string>;  ///< relative path -> content

/// The handwritten files of generated/. The functions below neither write nor compare them.
const std::set<std::string>& handwritten_files();

/// Makes the folder if it does not exist. Throws std::runtime_error, which names the folder, if that is impossible.
void make_folder(const std::filesystem::path& folder);
/// Throws std::runtime_error if the folder does not exist.
void require_existing(const std::filesystem::path& folder);

/// Writes the files that differ and returns their paths. Each file appears complete or not at all. Throws
/// std::runtime_error, which names the file that it could not write.
std::vector<std::string> write_tree(const std::filesystem::path& folder, const RenderedFiles& files);

/// One line for each file that differs or is missing; empty if all files are equal. Throws std::runtime_error if the
/// folder does not exist.
std::vector<std::string> compare_files(const std::filesystem::path& folder, const RenderedFiles& files);

/// The same, and one line for each extra file in the folder.
std::vector<std::string> compare_tree(const std::filesystem::path& folder, const RenderedFiles& files);

/// PREFIX/path if the running tool is PREFIX/bin/shgen and that file or folder exists; otherwise `otherwise`.
std::filesystem::path installed_or(const std::filesystem::path& path, const std::filesystem::path& otherwise);

}  // namespace sh::codegen
