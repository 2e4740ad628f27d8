#include "prt/binary/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <new>

#include "prt/binary/bytes.hpp"
#include "prt/chunks.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kPart = std::size_t{1} << 20U;    // of one task
constexpr std::size_t kWindow = std::size_t{1} << 15U;  // that deflate looks back
constexpr int kRaw = -MAX_WBITS;

struct Part {
  std::string_view before;  // up to kWindow bytes
  std::string_view data;
  bool is_last;
  std::string deflated;
  uLong crc = 0;
};

auto bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

void deflate_part(Part& part) {
  z_stream stream = {};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
  if (!part.before.empty()) deflateSetDictionary(&stream, bytes_of(part.before), static_cast<uInt>(part.before.size()));
  constexpr std::size_t kMarker = 16;  // of the flush, more than deflateBound counts
  part.deflated.resize(deflateBound(&stream, part.data.size()) + kMarker);
  stream.next_in = const_cast<Bytef*>(bytes_of(part.data));
  stream.avail_in = static_cast<uInt>(part.data.size());
  stream.next_out = reinterpret_cast<Bytef*>(part.deflated.data());
  stream.avail_out = static_cast<uInt>(part.deflated.size());
  deflate(&stream, part.is_last ? Z_FINISH : Z_SYNC_FLUSH);
  part.deflated.resize(stream.total_out);
  part.crc = crc32(0, bytes_of(part.data), static_cast<uInt>(part.data.size()));
}

std::vector<Part> parts_of(const std::vector<std::string_view>& data) {
  std::vector<Part> parts;
  for (const std::string_view all : data) {
    for (std::size_t from = 0; from < all.size(); from += kPart) {
      const std::size_t window = std::min(from, kWindow);
      parts.push_back({all.substr(from - window, window), all.substr(from, kPart), false, {}});
    }
  }
  if (parts.empty()) parts.emplace_back();
  parts.back().is_last = true;
  return parts;
}

}  // namespace

std::vector<std::string> gzip(const std::vector<std::string_view>& data) {
  std::vector<Part> parts = parts_of(data);
  in_parallel(std::size_t{0}, parts.size(), [&](std::size_t i) { deflate_part(parts[i]); });
  constexpr std::array<char, 10> kHead = {'\x1f', '\x8b', 8, 0, 0, 0, 0, 0, 0, '\xff'};  // deflate, no time, any system
  std::vector<std::string> pieces = {std::string(kHead.begin(), kHead.end())};
  uLong crc = crc32(0, nullptr, 0);
  std::uint64_t size = 0;
  for (Part& part : parts) {
    crc = crc32_combine(crc, part.crc, static_cast<z_off_t>(part.data.size()));
    size += part.data.size();
    pieces.push_back(std::move(part.deflated));
  }
  append_word(pieces.emplace_back(), static_cast<std::uint32_t>(crc));
  append_word(pieces.back(), static_cast<std::uint32_t>(size));  // modulo 2^32
  return pieces;
}

}  // namespace sh::prt
