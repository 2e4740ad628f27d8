// Printer: drivers that run kernels over many records on SIMD lanes, the files of generated/batch/.
//
// A driver is derived from the signature of a family's kernels: consecutive scalars x, y, z are one record of 3 values,
// an array is a record, the results together are the output record; a result that is updated in place is a sum over all
// records. What does not depend on the families (layouts, lanes, choice of the instruction set) is fixed text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/passes/finished_kernel.hpp"

namespace sh::codegen::print {

/// Kernels of the written families by family name, in order of degree.
using WrittenFamilies = std::map<std::string, std::vector<FinishedKernel>>;

/// Relative path -> text of every file under generated/batch/: a driver for each family listed in batch.cpp that is
/// written.
std::map<std::string, std::string> batch_files(const WrittenFamilies& families);

/// Fixed texts: the registers that kernels compute with, layouts and copies, the loop over chunks of records.
extern const char* const kBatchLanes;
extern const char* const kBatchLayout;
extern const char* const kBatchDrive;
/// Fixed part of the public header, and of the file that chooses the instruction set.
extern const char* const kBatchHeader;
extern const char* const kBatchChoice;

}  // namespace sh::codegen::print
