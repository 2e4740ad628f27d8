// Printer: what a batched driver runs: its kernels over blocks of records, and what it computes once a call.
#pragma once

#include <string>
#include <vector>

#include "codegen/print/batch_driver.hpp"

namespace sh::codegen::print {

/// generated/batch/<driver>.cpp: the driver's kernels by degree, compiled once for each instruction set.
std::string kernels_file(const Driver& driver);

/// once.hpp and once.cpp: functions from a shared input, or of a sum, that are the same on every instruction set.
std::string once_header(const std::vector<Driver>& drivers);
std::string once_file(const std::vector<Driver>& drivers);

}  // namespace sh::codegen::print
