// generated/MANIFEST: one line a recipe of every kernel with its cost, measured error, tuned time and files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/choose/wisdom.hpp"
#include "codegen/passes/finished_kernel.hpp"

namespace sh::codegen {

struct ManifestEntry {
  FinishedKernel finished;
  std::vector<std::string> files;  ///< relative to generated/; none when another recipe was chosen
  std::optional<Timing> timing;    ///< where the recipe was tuned
};

std::string print_manifest(const std::vector<ManifestEntry>& entries);

}  // namespace sh::codegen
