// generated/MANIFEST: one line a kernel with its recipe, cost, measured error and files.
#pragma once

#include <string>
#include <vector>

#include "codegen/finished_kernel.hpp"

namespace sh::codegen {

struct ManifestEntry {
  FinishedKernel finished;
  std::vector<std::string> files;  ///< relative to generated/
};

std::string print_manifest(const std::vector<ManifestEntry>& entries);

}  // namespace sh::codegen
