// `shgen tune`: measures recipes, and writes or checks the wisdom that chooses among them.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace sh::codegen {

/// The options of `shgen tune`.
struct TuneOptions {
  std::vector<std::string> families;  ///< empty: all
  std::optional<int> degree;          ///< empty: every written degree
  std::string file;                   ///< the wisdom file to update; empty: the committed one
  bool check = false;                 ///< measure kernels with several recipes, compare with the choice, write nothing
};

/// Prints a line for every recipe on `out`. Without `check` it returns true. With `check` it returns true if every
/// chosen recipe is at most 10 % slower than the fastest. Throws std::invalid_argument for an unknown family or for a
/// degree that the family does not have.
bool tune(const TuneOptions& options, std::ostream& out, std::ostream& progress);

}  // namespace sh::codegen
