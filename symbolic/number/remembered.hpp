// A cache of derived objects: what is exact is derived once in a process.
#pragma once

#include <map>

namespace sh::symbolic {

/// The value at `key`; derive() makes it at the first call.
template <class Value, class Key, class Derive>
const Value& remembered(std::map<Key, Value>& known, const Key& key, const Derive& derive) {
  const auto position = known.find(key);
  return position != known.end() ? position->second : known.emplace(key, derive()).first->second;
}

}  // namespace sh::symbolic
