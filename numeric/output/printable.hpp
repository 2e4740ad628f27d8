// Text of any origin inside a message of one line.
#pragma once

#include <string>
#include <string_view>

#include "numeric/output/formatted.hpp"

namespace sh::output {

/// The text with its control characters as \xNN, so that it neither breaks the line nor steers a terminal.
inline std::string printable(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_control = byte < 0x20 || byte == 0x7f;
    result += is_control ? formatted("\\x%02x", static_cast<unsigned>(byte)) : std::string(1, c);
  }
  return result;
}

}  // namespace sh::output
