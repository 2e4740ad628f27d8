// generated/MANIFEST: one line for each recipe of every kernel, with its cost, measured error, tuned time and files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/choose/wisdom.hpp"
#include "codegen/passes/finished_kernel.hpp"

namespace sh::codegen {

/// One line of the manifest.
struct ManifestEntry {
  FinishedKernel finished;
  std::vector<std::string> files;  ///< relative to generated/; empty if another recipe was chosen
  std::optional<Timing> timing;    ///< empty if the recipe was not tuned
};

/// The content of generated/MANIFEST.
std::string print_manifest(const std::vector<ManifestEntry>& entries);

}  // namespace sh::codegen
