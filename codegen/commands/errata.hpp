// `shgen errata`: decides the errata of the sources and prints them as a table.
//
// Input: options. Output: the table on `out`, a JSON file when asked for, counts and contradictions on `progress`.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "numeric/errata/errata.hpp"

namespace sh::codegen {

struct ErrataOptions {
  std::vector<std::string> only;  ///< entries ("B-08") or sources ("B"); empty: all
  std::string verdict;  ///< only entries of this verdict, as errata::to_string writes it; empty: all
  std::string json;     ///< file to write, complete or not at all; empty: none
};

/// True when every chosen entry's decisions are the recorded ones. Throws std::invalid_argument for an
/// unknown entry, source or verdict, std::runtime_error when the JSON file cannot be written.
bool errata(const std::vector<errata::Source>& sources, const ErrataOptions& options, std::ostream& out,
            std::ostream& progress);

}  // namespace sh::codegen
