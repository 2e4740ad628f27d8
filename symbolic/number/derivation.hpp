// Every derivation refuses degrees out of its range in the same words, and runs once in a process.
#pragma once

#include <map>
#include <stdexcept>
#include <string>

namespace sh::symbolic {

/// Throws std::invalid_argument with one line that names `what`, the range 0..largest and its reason, unless the degree
/// lies in the range.
inline void require_degree(const std::string& what, int degree, int largest, const std::string& reason) {
  if (degree >= 0 && degree <= largest) return;
  throw std::invalid_argument(what + ": expected a degree of 0 to " + std::to_string(largest) + " (" + reason +
                              "), got " + std::to_string(degree));
}

/// The value at `key`; derive() makes it at the first call.
template <class Value, class Key, class Derive>
const Value& remembered(std::map<Key, Value>& known, const Key& key, const Derive& derive) {
  const auto position = known.find(key);
  return position != known.end() ? position->second : known.emplace(key, derive()).first->second;
}

}  // namespace sh::symbolic
