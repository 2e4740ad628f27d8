// Text from numbers in the way of printf.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace sh::output {

/// The text that std::printf would write, of any length.
template <class... Argument>
std::string formatted(const char* format, Argument... argument) {
  const int size = std::snprintf(nullptr, 0, format, argument...);
  std::string text(static_cast<std::size_t>(size > 0 ? size : 0) + 1, '\0');
  std::snprintf(text.data(), text.size(), format, argument...);
  text.pop_back();
  return text;
}

}  // namespace sh::output
