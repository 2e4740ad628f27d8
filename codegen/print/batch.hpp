// Printer: drivers that run kernels over many records on SIMD lanes. They are the files of generated/batch/.
//
// The signature of a family's kernels determines its driver. Consecutive scalars x, y, z are one record of 3 values, an
// array is a record, and all results are the output record. A result that a kernel updates in place is a sum over all
// records. The files that depend on no family (layouts, lanes, choice of the instruction set) are copies of
// codegen/runtime/.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "codegen/measure/measure.hpp"

namespace sh::codegen::print {

/// The written kernels of a family, in order of degree.
struct WrittenFamily {
  std::string name;
  std::optional<BatchDriver> batch;
  std::vector<FinishedKernel> kernels;
};

/// Relative path -> text of every file under generated/batch/: the drivers, the tables of lanes, the copies.
std::map<std::string, std::string> batch_files(const std::vector<WrittenFamily>& families);

}  // namespace sh::codegen::print
