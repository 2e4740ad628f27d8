#include "prt/transfer/rows.hpp"

#include <fmt/core.h>

#include <cstring>
#include <stdexcept>

#include "prt/transfer/widen.hpp"

namespace sh::prt {

Rows::Rows(const std::vector<float>& complete, const Encoded& stored, const TransferShape& shape)
    : length_(shape.length()) {
  if (stored.empty()) {
    complete_ = complete.data();
    count_ = length_ == 0 ? 0 : complete.size() / length_;
    return;
  }
  stored_ = &stored;
  element_ = shape.storage.element;
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

const std::uint16_t* Rows::halves(std::size_t first) const {
  if (stored_ == nullptr || element_ != Element::kHalf || !places_.empty()) return nullptr;
  return reinterpret_cast<const std::uint16_t*>(stored_->data.data()) + first * columns_;
}

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

const float* Rows::some(std::size_t first, std::size_t count, std::vector<float>& room) const {
  if (stored_ == nullptr) return complete_ + first * length_;
  const std::byte* from = stored_->data.data() + first * columns_ * bytes_of(element_);
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
