// Printer: drivers that run kernels over many records on SIMD lanes, the files of generated/batch/.
//
// A driver is derived from the signature of a family's kernels: consecutive scalars x, y, z are one record of 3 values,
// an array is a record, the results together are the output record; a result that is updated in place is a sum over all
// records. The files that depend on no family (layouts, lanes, choice of the instruction set) are copies of
// codegen/runtime/.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "codegen/measure/measure.hpp"

namespace sh::codegen::print {

/// What is written of a family: its kernels in order of degree.
struct WrittenFamily {
  std::string name;
  std::optional<BatchDriver> batch;
  std::vector<FinishedKernel> kernels;
};

/// Relative path -> text of every file under generated/batch/: a driver for each of the families that asks for one, the
/// tables of lanes, the copies.
std::map<std::string, std::string> batch_files(const std::vector<WrittenFamily>& families);

}  // namespace sh::codegen::print
