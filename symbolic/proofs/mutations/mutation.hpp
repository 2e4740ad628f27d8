// Single changes of the formulas and tables, which the proofs have to refute.
//
// A list (tests/data/mutations.txt) has one mutation a line: the formula, the entry, and the kind of the change, such as
//     gaunt 1 2 3 sign
// "= REASON" after it names an equivalent: the kernels stay right, so no proof can refute it. # begins a comment.
#pragma once

#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "symbolic/proofs/formulas.hpp"
#include "symbolic/proofs/proofs.hpp"

namespace sh::symbolic {

struct Mutation {
  std::string formula;             ///< a name of mutation_names()
  std::vector<std::string> entry;  ///< degrees, orders, names
  std::string kind;                ///< "sign", "factor", "drop", "exchange", "transpose", "inverse", ...
  std::string equivalent;          ///< the reason why it changes no result; empty: a proof refutes it

  /// "gaunt 1 2 3 sign"
  [[nodiscard]] std::string to_string() const;
};

/// The list in a file. Throws std::invalid_argument, one line with file and line number, for a line that is no mutation.
std::vector<Mutation> read_mutations(std::istream& input, const std::string& file);

/// The formulas that mutations change.
std::vector<std::string> mutation_names();

/// Our formulas with one change. Throws std::invalid_argument, one line, for an unknown formula or entry.
std::shared_ptr<const Formulas> mutated(const Mutation& mutation);

/// What the proofs to a degree say about a mutation.
struct MutationResult {
  std::vector<std::string> proofs;       ///< the names of those that do not hold
  std::vector<std::string> spot_checks;  ///< the same for spot checks

  [[nodiscard]] bool survives() const { return proofs.empty(); }
};
/// Throws std::invalid_argument, one line, for a kind that does not apply to the formula.
MutationResult judge(const Mutation& mutation, int degree);

}  // namespace sh::symbolic
