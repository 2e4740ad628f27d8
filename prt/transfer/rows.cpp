#include "prt/transfer/rows.hpp"

#include <fmt/core.h>

#include <cstring>
#include <stdexcept>

#include "prt/transfer/widen.hpp"

namespace sh::prt {

namespace {

// to (columns) = items of this type, `step` of them apart.
template <class Item>
void copy_row(const std::byte* from, std::size_t step, std::size_t columns, std::byte* to) {
  for (std::size_t j = 0; j < columns; ++j) {
    std::memcpy(to + j * sizeof(Item), from + j * step * sizeof(Item), sizeof(Item));
  }
}

}  // namespace

Rows::Rows(const std::vector<float>& complete, const Encoded& stored, const TransferShape& shape)
    : length_(shape.length()) {
  if (stored.empty()) {
    complete_ = complete.data();
    count_ = length_ == 0 ? 0 : complete.size() / length_;
    return;
  }
  stored_ = &stored;
  element_ = shape.storage.element;
  blocks_ = stored.in_blocks;
  places_ = stored_columns(shape);
  columns_ = places_.size();
  copies_ = shape.storage.one_channel ? shape.channels : 1;
  apart_ = shape.count();
  if (element_ == Element::kByte && stored.scale.size() != columns_) {
    throw std::invalid_argument(fmt::format("{} scales: expected {}, one a column", stored.scale.size(), columns_));
  }
  constexpr std::size_t kRowsOfScales = 16;  // so that rows of any length are widened in whole registers
  for (std::size_t row = 0; element_ == Element::kByte && row < kRowsOfScales; ++row) {
    scales_.insert(scales_.end(), stored.scale.begin(), stored.scale.end());
  }
  count_ = stored.data.size() / (columns_ * bytes_of(element_));
  if (columns_ == length_) places_.clear();
}

std::size_t Rows::bytes() const { return stored_ != nullptr ? stored_->data.size() : count_ * length_ * sizeof(float); }

std::vector<float> Rows::all() const {
  std::vector<float> numbers;
  numbers.reserve(count_ * length_);
  each(0, count_, [&](std::size_t /*first*/, std::size_t count, const float* some) {
    numbers.insert(numbers.end(), some, some + count * length_);
  });
  return numbers;
}

void Rows::widen(const std::byte* from, std::size_t rows, float* to) const {
  const std::size_t count = rows * columns_;
  if (element_ == Element::kSingle) {
    std::memcpy(to, from, count * sizeof(float));
  } else if (element_ == Element::kHalf) {
    widen_halves(reinterpret_cast<const std::uint16_t*>(from), count, to);
  } else {
    widen_bytes(reinterpret_cast<const std::int8_t*>(from), count, scales_, to);
  }
}

const std::byte* Rows::narrow(std::size_t first, std::size_t count, std::vector<std::byte>& room) const {
  const std::size_t size = bytes_of(element_);
  const std::byte* data = stored_->data.data();
  if (first >= in_blocks()) return data + first * columns_ * size;
  room.resize(count * columns_ * size);
  const auto row = size == 1 ? copy_row<std::int8_t> : size == 2 ? copy_row<std::int16_t> : copy_row<float>;
  for (std::size_t v = first; v < first + count; ++v) {
    const bool in_block = v < in_blocks();
    const std::size_t lane = in_block ? v % kReceiversOfBlock : 0;
    row(data + ((v - lane) * columns_ + lane) * size, in_block ? kReceiversOfBlock : 1, columns_,
        room.data() + (v - first) * columns_ * size);
  }
  return room.data();
}

const float* Rows::some(std::size_t first, std::size_t count, std::vector<float>& room) const {
  if (stored_ == nullptr) return complete_ + first * length_;
  std::vector<std::byte> of_blocks;
  const std::byte* from = narrow(first, count, of_blocks);
  room.resize(count * (length_ + (places_.empty() ? 0 : columns_)));
  if (places_.empty()) {
    widen(from, count, room.data());
    return room.data();
  }
  const float* narrow = room.data() + count * length_;  // behind the complete rows
  widen(from, count, room.data() + count * length_);
  std::fill_n(room.data(), count * length_, 0.0F);
  for (float* row = room.data(); row != room.data() + count * length_; row += length_, narrow += columns_) {
    for (std::size_t copy = 0; copy < copies_; ++copy) {
      for (std::size_t j = 0; j < columns_; ++j) row[places_[j] + copy * apart_] = narrow[j];
    }
  }
  return room.data();
}

}  // namespace sh::prt
