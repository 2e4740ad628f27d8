#include "prt/transfer/storage.hpp"

#include <fmt/core.h>
#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>

#include "prt/arrays.hpp"
#include "prt/chunks.hpp"
#include "prt/names.hpp"
#include "prt/transfer/rows.hpp"

namespace sh::prt {

namespace {

constexpr float kSteps = 127.0F;
constexpr double kHalfOverflow = 65520.0;  // rounds to infinity

// The scale of a column: a normal number, 127 times which does not overflow; zero for a column of zeros.
float scale_for(float largest) {
  const float scale = largest > 0.0F ? std::max(largest / kSteps, std::numeric_limits<float>::min()) : 0.0F;
  return std::isfinite(kSteps * scale) ? scale : std::nextafter(scale, 0.0F);
}

std::int8_t quantized(float value, float scale) {
  const double steps = scale > 0.0F ? static_cast<double>(value) / static_cast<double>(scale) : 0.0;
  return static_cast<std::int8_t>(std::lround(std::clamp(steps, -127.0, 127.0)));
}

template <class T>
void copy_to(std::byte* to, T bits) {
  std::memcpy(to, &bits, sizeof bits);
}

// Writes one number to `to`; half and single are copied unchanged.
void put(std::byte* to, Element element, float value, float scale) {
  if (element == Element::kSingle) return copy_to(to, value);
  if (element == Element::kHalf) return copy_to(to, static_cast<Eigen::half>(value).x);
  copy_to(to, quantized(value, scale));
}

// to (columns, rows) = from (rows, columns), of items of this type.
template <class Item>
void transpose(const std::byte* from, std::size_t rows, std::size_t columns, std::byte* to) {
  for (std::size_t j = 0; j < columns; ++j) {
    for (std::size_t i = 0; i < rows; ++i) {
      std::memcpy(to + (j * rows + i) * sizeof(Item), from + (i * columns + j) * sizeof(Item), sizeof(Item));
    }
  }
}

// Every whole block of `data` transposed: its rows become columns, or the other way round.
void transpose_blocks(std::vector<std::byte>& data, const TransferShape& shape, bool back) {
  const std::size_t columns = shape.stored_length();
  const std::size_t size = bytes_of(shape.storage.element);
  const std::size_t bytes = kReceiversOfBlock * columns * size;
  const auto transposed = size == 1 ? transpose<std::int8_t> : size == 2 ? transpose<std::int16_t> : transpose<float>;
  const std::size_t blocks = bytes == 0 ? 0 : data.size() / bytes;
  const tbb::blocked_range<std::size_t> all(0, blocks, 64);
  in_parallel(all, [&](const auto& range) {
    std::vector<std::byte> block(bytes);
    for (std::size_t b = range.begin(); b < range.end(); ++b) {
      std::byte* at = data.data() + b * bytes;
      std::copy_n(at, bytes, block.begin());
      transposed(block.data(), back ? columns : kReceiversOfBlock, back ? kReceiversOfBlock : columns, at);
    }
  });
}

}  // namespace

std::vector<std::size_t> stored_columns(const TransferShape& shape) {
  const Storage& storage = shape.storage;
  if (!std::is_sorted(storage.kept.begin(), storage.kept.end(), std::less_equal<>()) ||
      (!storage.kept.empty() && storage.kept.back() >= shape.columns())) {
    throw std::invalid_argument(fmt::format("kept coefficients: expected rising indices below {}", shape.columns()));
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < shape.length() / (storage.one_channel ? shape.channels : 1); ++i) {
    if (storage.kept.empty() || std::binary_search(storage.kept.begin(), storage.kept.end(), i % shape.columns())) {
      places.push_back(i);
    }
  }
  return places;
}

Encoded encode(const std::vector<float>& numbers, const TransferShape& shape) {
  const std::size_t length = shape.length();
  const Element element = shape.storage.element;
  if (length == 0 || numbers.size() % length != 0) {
    throw std::invalid_argument(fmt::format("{} numbers: expected rows of {}", numbers.size(), length));
  }
  const std::vector<std::size_t> columns = stored_columns(shape);
  const std::size_t size = bytes_of(element);
  Encoded encoded;
  const Eigen::ArrayXf all_largest = largest_numbers(numbers, length);
  for (const std::size_t column : columns) {
    const float largest = all_largest[Eigen::Index(column)];
    if (!std::isfinite(encoding_error(element, static_cast<double>(largest)))) {
      throw std::invalid_argument(fmt::format("a transfer coefficient of {} does not fit into type {}", largest,
                                              word_of(element, kElementNames)));
    }
    if (element == Element::kByte) encoded.scale.push_back(scale_for(largest));
  }
  encoded.data.resize(numbers.size() / length * columns.size() * size);
  std::byte* to = encoded.data.data();
  for (std::size_t row = 0; row < numbers.size(); row += length) {
    for (std::size_t j = 0; j < columns.size(); ++j, to += size) {
      put(to, element, numbers[row + columns[j]], encoded.scale.empty() ? 1.0F : encoded.scale[j]);
    }
  }
  return encoded;
}

void to_blocks(Encoded& encoded, const TransferShape& shape) {
  transpose_blocks(encoded.data, shape, false);
  encoded.in_blocks = true;
}

Encoded in_rows(const Encoded& blocks, const TransferShape& shape) {
  Encoded rows = blocks;
  transpose_blocks(rows.data, shape, true);
  rows.in_blocks = false;
  return rows;
}

std::vector<float> decode(const Encoded& encoded, const TransferShape& shape) {
  const std::vector<float> none;
  return Rows(none, encoded, shape).all();
}

Encoded with_columns(const Encoded& encoded, const TransferShape& shape, const std::vector<std::uint32_t>& kept) {
  const std::vector<std::size_t> columns = stored_columns(shape);
  const std::size_t of_row = shape.columns();
  if (of_row == 0) return encoded;
  std::vector<std::size_t> chosen;  // among the columns
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (std::binary_search(kept.begin(), kept.end(), columns[j] % of_row)) chosen.push_back(j);
  }
  const std::size_t size = bytes_of(shape.storage.element);
  Encoded some;
  some.data.reserve(encoded.data.size() / columns.size() * chosen.size());
  for (const std::byte* row = encoded.data.data(); row != encoded.data.data() + encoded.data.size();
       row += columns.size() * size) {
    for (const std::size_t j : chosen) some.data.insert(some.data.end(), row + j * size, row + (j + 1) * size);
  }
  for (std::size_t i = 0; !encoded.scale.empty() && i < chosen.size(); ++i)
    some.scale.push_back(encoded.scale[chosen[i]]);
  return some;
}

Eigen::ArrayXf largest_numbers(const std::vector<float>& numbers, std::size_t length) {
  Eigen::ArrayXf largest = Eigen::ArrayXf::Zero(Eigen::Index(length));
  for (std::size_t first = 0; first < numbers.size(); first += length) {
    largest = largest.max(as_array(&numbers[first], length).abs());
  }
  return largest;
}

double encoding_error(Element element, double largest) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(largest <= static_cast<double>(std::numeric_limits<float>::max()))) return kInfinity;
  if (element == Element::kHalf) {
    if (!(largest < kHalfOverflow)) return kInfinity;
    return std::max(std::ldexp(largest, -11), std::ldexp(1.0, -25));
  }
  if (element == Element::kByte) {
    constexpr double kRounding = 1.0001;  // of the scale and of its product with q
    const auto least = static_cast<double>(std::numeric_limits<float>::min());
    return largest > 0.0 ? std::max(largest / static_cast<double>(kSteps), least) / 2.0 * kRounding : 0.0;
  }
  return 0.0;
}

}  // namespace sh::prt
