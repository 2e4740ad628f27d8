// Linear maps as short circuits: sums of constants times earlier values, shared among the rows of a matrix.
//
// A circuit can be run forwards, or transposed (the matrix transposed, by the same products and the same sums read
// backwards, [Fiduccia73]): values shared in one direction are shared in the other. The search is greedy: the pair of
// values x + r y that saves the most operations becomes a value of its own, until none saves any [Paar97]; ties are
// broken in several fixed ways and the shortest circuit wins.
#pragma once

#include <map>
#include <vector>

#include "codegen/ir/exact_real.hpp"
#include "codegen/recipes/signed_builder.hpp"

namespace sh::codegen {

struct LinearTerm {
  int source = 0;
  ExactReal factor;
};

struct LinearCircuit {
  int inputs = 0;                             ///< values 0 .. inputs-1
  std::vector<std::vector<LinearTerm>> sums;  ///< value inputs+i is a sum of constants times earlier values
  std::vector<int> outputs;                   ///< values; -1 is zero
  /// Multiplications and additions of the forward run.
  [[nodiscard]] int operations() const;
};

/// Rows of a matrix without its zeros: column -> entry.
using LinearMap = std::vector<std::map<int, ExactReal>>;

/// attempts: ways of breaking ties that are tried.
LinearCircuit short_circuit(const LinearMap& rows, int columns, int attempts = 20);

std::vector<Value> run_forwards(SignedBuilder& build, const LinearCircuit& circuit, const std::vector<Value>& columns);
std::vector<Value> run_transposed(SignedBuilder& build, const LinearCircuit& circuit, const std::vector<Value>& rows);

}  // namespace sh::codegen
