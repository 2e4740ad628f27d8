// `shgen prove`: runs the catalogue of proofs and reports a line for each identity.
//
// Input: options. Output: lines on `out`, a JSON file when asked for, progress on `progress`.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace sh::codegen {

struct ProveOptions {
  std::optional<int> degree;      ///< to this degree, or as far as a proof supports; its own default if not given
  std::vector<std::string> only;  ///< names of the proofs to run; empty: all
  std::string json;               ///< file to write, complete or not at all; empty: none
};

/// True when every identity is proved. Throws std::invalid_argument for a negative or too large degree or an unknown
/// name, std::runtime_error when the JSON file cannot be written.
bool prove(const ProveOptions& options, std::ostream& out, std::ostream& progress);

}  // namespace sh::codegen
