// The one refusal of a degree out of range.
#pragma once

#include <stdexcept>
#include <string>

namespace sh::symbolic {

/// Throws std::invalid_argument with one line that names `what`, the range 0..largest and its reason, unless the degree
/// lies in it.
inline void require_degree(const std::string& what, int degree, int largest, const std::string& reason) {
  if (degree >= 0 && degree <= largest) return;
  throw std::invalid_argument(what + ": expected a degree of 0 to " + std::to_string(largest) + " (" + reason +
                              "), got " + std::to_string(degree));
}

}  // namespace sh::symbolic
