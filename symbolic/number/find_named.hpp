// A list of items with names: the item of a given name, or a refusal that lists the names.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace sh::symbolic {

/// The item with `.name == name`. Throws std::invalid_argument, "unknown KIND 'NAME': expected one of: ...".
template <class Items>
const auto& find_named(const Items& items, std::string_view name, const std::string& kind) {
  std::string known;
  for (const auto& item : items) {
    if (item.name == name) return item;
    known += (known.empty() ? "" : ", ") + std::string(item.name);
  }
  throw std::invalid_argument("unknown " + kind + " '" + std::string(name) + "': expected one of: " + known);
}

}  // namespace sh::symbolic
