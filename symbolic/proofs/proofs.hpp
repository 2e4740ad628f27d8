// The catalogue of everything that is proved: one list for `shgen prove`, for tests, and for readers.
#pragma once

#include <vector>

#include "symbolic/proofs/proof.hpp"

namespace sh::symbolic {

/// Every proof of every area, in reading order: basis, rotations, conventions, zonal functions, Gaunt tensors.
std::vector<Proof> all_proofs();

/// Throws std::invalid_argument, with the limit and the reason, unless 0 <= degree <= kMaxBasisDegree. Each proof goes
/// as far as its own max_degree.
void require_proof_degree(int degree);

}  // namespace sh::symbolic
