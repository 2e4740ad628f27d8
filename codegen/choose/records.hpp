// The two records of the written kernels.
//
// generated/MANIFEST, for people: one line for each recipe of every kernel, with its cost, measured error, tuned time
// and files. generated/families.json, for programs that run or check the kernels without this generator: the roles,
// shapes, units, sizes and measured errors of every written kernel, and the limits that follow from these errors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codegen/choose/wisdom.hpp"
#include "codegen/measure/measure.hpp"

namespace sh::codegen {

/// One line of the manifest.
struct ManifestEntry {
  FinishedKernel finished;
  std::vector<std::string> files;              ///< relative to generated/; empty if another recipe was chosen
  std::vector<std::optional<Timing>> timings;  ///< by machine; empty where the recipe was not tuned
};

/// The columns of the line.
using ManifestRow = std::vector<std::string>;
ManifestRow manifest_row(const ManifestEntry& entry);

/// A written kernel as families.json tells of it, a JSON object.
std::string kernel_record(const FinishedKernel& finished);

/// A family and the records of its written kernels, by degree.
struct RecordedFamily {
  const Family* family = nullptr;
  std::string nearest;  // nearest_point() of its kernels
  std::vector<std::string> kernels;
};

/// The content of generated/MANIFEST.
std::string print_manifest(const std::vector<ManifestRow>& rows);

/// The content of generated/families.json.
std::string print_families_record(const std::vector<RecordedFamily>& families);

}  // namespace sh::codegen
