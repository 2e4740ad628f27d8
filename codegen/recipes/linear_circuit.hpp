// Writes linear maps as short circuits: sums of constants times earlier values, which the rows of a matrix share.
//
// A circuit runs forwards or transposed. The transposed run applies the transposed matrix with the same products and
// the same sums in reverse order [Fiduccia73]; values that are shared in one direction are shared in the other. The
// search is greedy: the pair of values x + r y that saves the most operations becomes a new value, until no pair saves
// an operation [Paar97]. The search breaks ties in several fixed ways and takes the shortest circuit.
#pragma once

#include <map>
#include <vector>

#include "codegen/ir/exact_real.hpp"
#include "codegen/recipes/signed_builder.hpp"

namespace sh::codegen {

/// factor * value `source`.
struct LinearTerm {
  int source = 0;
  ExactReal factor;
};

/// A linear map as a sequence of sums.
struct LinearCircuit {
  int inputs = 0;                             ///< values 0 .. inputs-1
  std::vector<std::vector<LinearTerm>> sums;  ///< value inputs+i is a sum of constants times earlier values
  std::vector<int> outputs;                   ///< the values that are outputs; -1: zero
  /// The number of multiplications and additions of the forward run.
  [[nodiscard]] int operations() const;
};

/// Rows of a matrix without its zeros: column -> entry.
using LinearMap = std::vector<std::map<int, ExactReal>>;

/// attempts: the number of ways of breaking ties.
LinearCircuit short_circuit(const LinearMap& rows, int columns, int attempts = 20);

/// Appends the circuit, or its transpose, and returns the results.
std::vector<Value> run_forwards(SignedBuilder& build, const LinearCircuit& circuit, const std::vector<Value>& columns);
std::vector<Value> run_transposed(SignedBuilder& build, const LinearCircuit& circuit, const std::vector<Value>& rows);

}  // namespace sh::codegen
