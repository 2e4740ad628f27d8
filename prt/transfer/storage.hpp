// Encodes the rows of numbers for a file. Complete rows are in single precision: numbers that a file leaves out are zeros
// in them, or copies if one channel stands for three.
//   single  IEEE binary32
//   half    IEEE binary16, rounded to nearest: a number t is off by at most 2^-11 |t|, or 2^-25 if that is more
//   byte    signed 8 bits q times a scale per column s = largest |t| of the column / 127: off by at most s / 2. One
//           scale serves all vertices, so that a product with a light can take it into the light.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "prt/transfer/shape.hpp"

namespace sh::prt {

struct Encoded {
  std::vector<std::byte> data;  // (receivers, shape.stored_length()) of the element
  std::vector<float> scale;     // (shape.stored_length()); bytes only
  /// Memory only: every 16 receivers, as long as there are as many, have number k one after the other, for each k.
  bool in_blocks = false;
  [[nodiscard]] bool empty() const { return data.empty(); }
};

/// Receivers of a block.
inline constexpr std::size_t kReceiversOfBlock = 16;

/// The places of the stored columns in a complete row, ascending; those of the first channel where it stands for all.
/// Throws std::invalid_argument for kept columns that do not rise or are too large.
std::vector<std::size_t> stored_columns(const TransferShape& shape);

/// numbers (receivers, shape.length()) -> file. Throws std::invalid_argument for a number that the element cannot hold
/// (half: from 65,520 on), like stored_columns, and for numbers of another shape.
Encoded encode(const std::vector<float>& numbers, const TransferShape& shape);

/// From rows to blocks, in place, and back.
void to_blocks(Encoded& encoded, const TransferShape& shape);
Encoded in_rows(const Encoded& blocks, const TransferShape& shape);

/// file -> (receivers, shape.length()).
std::vector<float> decode(const Encoded& encoded, const TransferShape& shape);

/// The same numbers without the columns that are not in `kept`, which have to be among those of `shape`.
Encoded with_columns(const Encoded& encoded, const TransferShape& shape, const std::vector<std::uint32_t>& kept);

/// The largest absolute value of each column of rows, (length); numbers (rows, length).
Eigen::ArrayXf largest_numbers(const std::vector<float>& numbers, std::size_t length);

/// The largest error that encoding makes of a number of a column whose numbers are at most `largest`; infinite where it
/// cannot hold them.
double encoding_error(Element element, double largest);

}  // namespace sh::prt
