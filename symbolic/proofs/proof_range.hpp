// A catalogue entry that refuses degrees outside its range.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "symbolic/proofs/proof.hpp"

namespace sh::symbolic {

/// The same entry; its run throws std::invalid_argument with one line, limit and reason, unless 0 <= degree <=
/// max_degree.
inline Proof with_range_check(Proof proof) {
  auto run = [name = proof.name, max = proof.max_degree, limit = proof.limit, unchecked = proof.run](int degree) {
    if (degree < 0 || degree > max) {
      throw std::invalid_argument("proof " + name + ": degree " + std::to_string(degree) + "; it should be 0 to " +
                                  std::to_string(max) + " (" + limit + ")");
    }
    return unchecked(degree);
  };
  proof.run = std::move(run);
  return proof;
}

}  // namespace sh::symbolic
