// `shgen tune`: measures recipes and writes or checks the wisdom that chooses among them.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace sh::codegen {

struct TuneOptions {
  std::vector<std::string> families;  ///< empty: all
  std::optional<int> degree;          ///< this one only
  std::string file;                   ///< the wisdom to update; empty: the committed one
  bool check = false;                 ///< measure what has several recipes and compare with the choice; write nothing
};

/// Prints a line for every recipe on `out`. True when done; with `check`, true when every chosen recipe is at most 10 %
/// slower than the fastest. Throws std::invalid_argument for an unknown family or a degree that it does not have.
bool tune(const TuneOptions& options, std::ostream& out, std::ostream& progress);

}  // namespace sh::codegen
