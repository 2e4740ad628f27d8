// The check of a family of kernels: its parameters, the inputs tried, the exact values, the unit of its error.
//
// Everything but the exact values comes from the record of the families (family_record.hpp): inputs are made by the
// roles of the parameters (inputs.hpp), and so is the nearest point of the domain. Inputs and outputs are flat, in the
// order of signature.hpp. A family's variants (basis_accurate of basis) share its check.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/kernels/exact/exact.hpp"
#include "numeric/kernels/family_record.hpp"

namespace sh::numeric {

struct FamilyCheck {
  std::string family;
  std::function<Signature(int degree)> signature;
  std::function<std::vector<NamedInput>(int degree)> inputs;
  // out = the exact outputs at `in`.
  RealFunction oracle;
  // out = the point of the domain that the rounded input `in` stands for, such as a direction scaled to length 1.
  // Empty: every input is in the domain.
  RealFunction nearest;
  /// The value that the error of an output is compared with, at an input; in words for reports.
  std::function<double(int degree, const double* in, std::size_t output)> size;
  std::string unit;
};

/// The check that a family's record and its exact values make.
FamilyCheck make_check(const FamilyRecord& record, const ExactFamily& exact);

/// Every family that has exact values, in the order of the record.
const std::vector<FamilyCheck>& all_checks();

/// The check of a kernel's family or of the family whose variant it is ("basis" for "basis_accurate"); nullptr if none.
const FamilyCheck* find_check(const std::string& family);

/// The same. Throws std::invalid_argument, one line, if there is none.
const FamilyCheck& check_of(const std::string& family);

}  // namespace sh::numeric
