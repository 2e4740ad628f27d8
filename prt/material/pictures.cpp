#include "prt/material/pictures.hpp"

#include <fmt/core.h>

#include <limits>
#include <stdexcept>

namespace sh::prt {

std::size_t Pictures::first_byte(std::size_t number) const {
  std::size_t first = 0;
  for (std::size_t i = 0; i < number; ++i) first += heads[i].bytes;
  return first;
}

std::size_t Pictures::number_of(const EncodedPicture& picture) {
  for (std::size_t i = 0; i < heads.size(); ++i) {
    if (heads[i].bytes == picture.bytes.size() && at(i) == picture) return i;
  }
  if (heads.size() == std::numeric_limits<std::uint16_t>::max()) {
    throw std::runtime_error(
        fmt::format("{}: a scene has more than {} pictures; expected fewer", picture.name, heads.size()));
  }
  heads.push_back({picture.name, picture.bytes.size()});
  bytes.insert(bytes.end(), picture.bytes.begin(), picture.bytes.end());
  return heads.size() - 1;
}

EncodedPicture Pictures::at(std::size_t number) const {
  const auto begin = static_cast<std::ptrdiff_t>(first_byte(number));
  const auto end = static_cast<std::ptrdiff_t>(first_byte(number + 1));
  return {heads[number].name, {bytes.begin() + begin, bytes.begin() + end}};
}

}  // namespace sh::prt
