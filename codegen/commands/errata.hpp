// `shgen errata`: decides the errata of the sources and prints them as a table.
//
// Input: options. Output: the table on `out`, a JSON file if the options name one, counts and contradictions on
// `progress`.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "numeric/errata/errata.hpp"

namespace sh::codegen {

/// The options of `shgen errata`.
struct ErrataOptions {
  std::vector<std::string> only;  ///< entries ("B-08") or sources ("B"); empty: all
  std::string verdict;            ///< only entries with this verdict, as errata::to_string writes it; empty: all
  std::string json;               ///< the file to write, complete or not at all; empty: none
};

/// True if the decisions about every chosen entry equal the recorded ones. Throws std::invalid_argument for an unknown
/// entry, source or verdict, and std::runtime_error if it cannot write the JSON file.
bool errata(const std::vector<errata::Source>& sources, const ErrataOptions& options, std::ostream& out,
            std::ostream& progress);

}  // namespace sh::codegen
