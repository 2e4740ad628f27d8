// The record of the families, generated/families.json: roles, shapes, units, sizes and measured errors of every
// generated kernel, as `shgen write` knows them.
//
// The record that the bindings belong to is compiled in (kernel_bindings.cmake), so that an installed tool needs no
// file. Only roles and sizes come from the generator: values to compare with come from the oracle alone.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numeric/kernels/signature.hpp"

namespace sh::numeric {

/// The largest error that the generator measured, or that a kernel may have, in epsilon x the family's size.
struct RoundingAndTotal {
  double rounding = 0;  // against the kernel's own formula: the kernel answers for it
  double total = 0;     // against the exact function: users read it; it includes the input's distance from the domain
  std::optional<double> bound = {};  // of the rounding error, proved for all inputs; none: nothing is proved
};

struct KernelRecord {
  std::string name;    // basis_accurate_l4
  std::string family;  // basis_accurate
  int degree = 0;
  Signature signature;
  RoundingAndTotal in_float;
  RoundingAndTotal in_double;
};

/// A bound that the project promises, with its reason: it holds besides the limit that the recorded error gives.
struct Promise {
  std::string kernels;             // the beginning of their names
  std::string scalar;              // "float", "double"
  std::optional<double> rounding;  // in epsilon x size
  std::optional<double> total_absolute;
  std::string reason;
};

struct FamilyRecord {
  std::string family;
  std::string unit;                // of errors, for people
  std::vector<std::string> sizes;  // the same as formulas, one a result (size_formula.hpp)
  bool normalized = false;         // inputs stand for the nearest point of the domain: unit directions, rotations
  std::array<double, 2> lengths = {1, 1};  // of vectors: least and largest to try
  std::vector<KernelRecord> kernels;       // by degree; those of variants too

  /// The parameters at any degree, from those of the nearest degree that is recorded.
  [[nodiscard]] Signature signature(int degree) const;
};

struct FamiliesRecord {
  RoundingAndTotal limit_factor;  // a kernel may err by this times the recorded error
  double least_limit = 0;         // and by this in any case
  std::vector<FamilyRecord> families;
  std::vector<Promise> promises;

  /// By "basis_l4"; nullptr if there is none.
  [[nodiscard]] const KernelRecord* find_kernel(const std::string& name) const;
};

/// Throws std::invalid_argument, one line, for a text that is no such record.
FamiliesRecord parse_record(std::string_view json);

/// The one that belongs to the bound kernels.
const FamiliesRecord& families_record();

/// "basis" for "basis_accurate": the family of which it is a variant, the same function by another recipe.
std::string without_variant(const std::string& family);

}  // namespace sh::numeric
