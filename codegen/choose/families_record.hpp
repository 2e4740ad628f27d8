// generated/families.json: the record of the families, for whoever runs or checks the kernels without this generator.
//
// Roles, shapes, units, sizes and measured errors of every kernel that is written, and the limits that they give.
#pragma once

#include <string>
#include <vector>

#include "codegen/families/family.hpp"
#include "codegen/passes/finished_kernel.hpp"

namespace sh::codegen {

struct RecordedFamily {
  const Family* family = nullptr;
  std::vector<FinishedKernel> kernels;  ///< those that are written, by degree
};

std::string print_families_record(const std::vector<RecordedFamily>& families);

}  // namespace sh::codegen
