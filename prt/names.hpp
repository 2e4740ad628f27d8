// Enumerations with a word for each value, in order.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace sh::prt {

/// The value whose entry in `words` (an array of std::string_view) is `word`; empty if there is none.
template <class Enumeration, class Words>
constexpr std::optional<Enumeration> value_called(std::string_view word, const Words& words) {
  for (std::size_t i = 0; i < std::size(words); ++i) {
    if (words[i] == word) return static_cast<Enumeration>(i);
  }
  return std::nullopt;
}

template <class Enumeration, class Words>
constexpr std::string_view word_of(Enumeration value, const Words& words) {
  return words[static_cast<std::size_t>(value)];
}

}  // namespace sh::prt
