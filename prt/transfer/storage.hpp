// How a transfer file holds its vectors: which of their numbers, and in which type. In memory they are always whole and
// in single precision; what a file leaves out comes back as zeros, or as copies where one channel stands for three.
//   single  IEEE binary32
//   half    IEEE binary16, rounded to nearest: a number t is off by at most 2^-11 |t|, or 2^-25 where that is more
//   byte    signed 8 bits q times a scale per column s = largest |t| of the column / 127: off by at most s / 2. One
//           scale serves all vertices, so that a product with a light can take it into the light.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sh::prt {

enum class Element : std::uint32_t { kSingle = 0, kHalf = 1, kByte = 2 };

/// The words for them in headers and messages, in their order.
inline constexpr std::array<std::string_view, 3> kElementNames = {"single", "half", "byte"};

struct Storage {
  Element element = Element::kSingle;
  bool one_channel = false;         // stands for all of them, which are alike
  std::vector<std::uint32_t> kept;  // indices l(l+1)+m, ascending; empty: all. No light may need the others
  /// Every number as it is in memory.
  [[nodiscard]] bool is_plain() const { return element == Element::kSingle && !one_channel && kept.empty(); }
};

/// What a row in memory is: channels times coefficients.
struct RowShape {
  std::size_t channels;
  std::size_t count;
};

/// What a file has of a row of that shape.
std::size_t stored_columns(const Storage& storage, const RowShape& shape);

constexpr std::size_t bytes_of(Element element) {
  return element == Element::kSingle ? 4 : element == Element::kHalf ? 2 : 1;
}

struct Encoded {
  std::vector<std::byte> data;  // (rows, stored columns) of the element
  std::vector<float> scale;     // (stored columns); bytes only
};

/// rows (rows, channels, count) -> file. Throws std::invalid_argument for a number that the element cannot hold (half:
/// from 65,520 on), for indices that do not rise or are too large, and for rows of another shape.
Encoded encode(const std::vector<float>& rows, const RowShape& shape, const Storage& storage);

/// file -> (rows, channels, count).
std::vector<float> decode(const Encoded& encoded, const RowShape& shape, const Storage& storage);

/// The largest error that encoding makes of a number of a column whose numbers are at most `largest`; infinite where it
/// cannot hold them.
double encoding_error(Element element, double largest);

}  // namespace sh::prt
