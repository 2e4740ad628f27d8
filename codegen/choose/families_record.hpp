// generated/families.json: the record of the families. Programs read it to run or check the kernels without this
// generator.
//
// It holds the roles, shapes, units, sizes and measured errors of every written kernel, and the limits that follow from
// these errors.
#pragma once

#include <string>
#include <vector>

#include "codegen/families/family.hpp"
#include "codegen/passes/finished_kernel.hpp"

namespace sh::codegen {

/// A family and its written kernels.
struct RecordedFamily {
  const Family* family = nullptr;
  std::vector<FinishedKernel> kernels;  ///< the written kernels, by degree
};

/// The content of generated/families.json.
std::string print_families_record(const std::vector<RecordedFamily>& families);

}  // namespace sh::codegen
