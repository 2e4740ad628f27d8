// `shgen prove`: runs the catalogue of proofs and prints a line for each identity.
//
// Input: options. Output: lines on `out`, a JSON file if the options name one, progress on `progress`.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace sh::codegen {

/// The options of `shgen prove`.
struct ProveOptions {
  std::optional<int> degree;      ///< the highest degree, limited by the range of each proof; empty: its default
  std::vector<std::string> only;  ///< names of the proofs to run; empty: all
  std::string json;               ///< the file to write, complete or not at all; empty: none
};

/// True if every identity is proved. Throws std::invalid_argument for a negative or too large degree or an unknown
/// name, and std::runtime_error if it cannot write the JSON file.
bool prove(const ProveOptions& options, std::ostream& out, std::ostream& progress);

}  // namespace sh::codegen
