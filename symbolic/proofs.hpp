// The catalogue of everything that is proved: one list for `shgen prove`, for tests, and for readers.
#pragma once

#include <string>
#include <vector>

#include "symbolic/proof.hpp"

namespace sh::symbolic {

/// Every proof of every area, in reading order: basis, rotations, conventions, zonal functions, Gaunt tensors.
std::vector<Proof> all_proofs();

/// Largest degree that any proof accepts.
int max_proof_degree();

/// The degree at which a proof runs: its default, or `requested` (>= 0) as far as it supports it. With a negative
/// `requested` the default. Throws std::invalid_argument when `requested` exceeds what every proof supports.
int proof_degree(const Proof& proof, int requested);

}  // namespace sh::symbolic
