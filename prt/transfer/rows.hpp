// Rows of numbers for reading. They are complete in memory, or as a file stores them (storage.hpp): half precision, 8
// bits, some columns, one channel for three. A reader gets complete rows, a few at a time: what is stored is widened into
// room that stays in the nearest caches, so that a file takes no more memory than its own bytes, and memory moves no more.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prt/transfer/storage.hpp"

namespace sh::prt {

class Rows {
 public:
  /// complete (receivers, length), unless `stored` has the rows. Both must outlive the result. Throws
  /// std::invalid_argument for scales of another count than the columns, and for columns that `shape` does not have.
  Rows(const std::vector<float>& complete, const Encoded& stored, const TransferShape& shape);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// The numbers of a complete row.
  [[nodiscard]] std::size_t length() const { return length_; }
  /// What memory holds of all rows.
  [[nodiscard]] std::size_t bytes() const;
  /// The complete rows `first` to first + count - 1, (count, length): in `room` if they are stored otherwise.
  [[nodiscard]] const float* some(std::size_t first, std::size_t count, std::vector<float>& room) const;
  /// How many receivers are in whole blocks (storage.hpp): the first ones, or none.
  [[nodiscard]] std::size_t in_blocks() const { return blocks_ ? count_ / kReceiversOfBlock * kReceiversOfBlock : 0; }
  /// The block that begins with receiver `first`, as it is stored, and the scales of 8 bits.
  [[nodiscard]] const std::byte* block(std::size_t first) const {
    return stored_->data.data() + first * columns_ * bytes_of(element_);
  }
  [[nodiscard]] const std::vector<float>& scale() const { return stored_->scale; }
  /// All rows, (count, length).
  [[nodiscard]] std::vector<float> all() const;

  /// Calls work(first row, count, numbers) for the rows of a range in their order, some of them at a time.
  template <class Work>
  void each(std::size_t first, std::size_t count, const Work& work) const {
    const std::size_t most = stored_ == nullptr ? count : at_once();
    std::vector<float> room;
    for (std::size_t done = 0; done < count; done += most) {
      const std::size_t now = std::min(most, count - done);
      work(first + done, now, some(first + done, now, room));
    }
  }

 private:
  // Rows that are widened at a time, 8 KB of them; kernels like whole blocks of 16.
  [[nodiscard]] std::size_t at_once() const {
    constexpr std::size_t kNumbers = 2048;
    constexpr std::size_t kBlock = 16;
    const std::size_t rows = std::max<std::size_t>(1, kNumbers / length_);
    return rows < kBlock ? rows : rows / kBlock * kBlock;
  }
  void widen(const std::byte* from, std::size_t rows, float* to) const;
  // Rows as a file has them: where they are, or copied to `room`.
  const std::byte* narrow(std::size_t first, std::size_t count, std::vector<std::byte>& room) const;

  const float* complete_ = nullptr;
  const Encoded* stored_ = nullptr;
  std::size_t length_;
  std::size_t count_ = 0;
  Element element_ = Element::kSingle;
  bool blocks_ = false;
  std::size_t columns_ = 0;    // stored
  std::vector<float> scales_;  // of 8 bits: those of the columns, again and again for some rows
  std::size_t copies_ = 1;     // of a column, `apart_` numbers apart
  std::size_t apart_ = 0;
  std::vector<std::size_t> places_;  // of the columns in a complete row; empty: one after the other
};

}  // namespace sh::prt
