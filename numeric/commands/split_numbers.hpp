// Lists of numbers in one option, as texts.
#pragma once

#include <array>
#include <stdexcept>
#include <string>

namespace sh::numeric {

// The Count parts of "a,b,c". Throws std::invalid_argument: "OPTION: 'TEXT' must be SHAPE separated by commas", shape
// such as "three numbers x,y,z".
template <std::size_t Count>
std::array<std::string, Count> split_numbers(const std::string& option, const std::string& text,
                                             const std::string& shape) {
  std::array<std::string, Count> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto comma = text.find(',', begin);
    if ((comma == std::string::npos) != (i + 1 == Count)) {
      throw std::invalid_argument(option + ": '" + text + "' must be " + shape + " separated by commas");
    }
    parts[i] = text.substr(begin, comma - begin);
    begin = comma + 1;
  }
  return parts;
}

}  // namespace sh::numeric
