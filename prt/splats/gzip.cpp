#include "prt/splats/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>

#include "prt/chunks.hpp"
#include "prt/splats/input_file.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kPart = std::size_t{1} << 20U;    // of one task
constexpr std::size_t kWindow = std::size_t{1} << 15U;  // that deflate looks back
constexpr int kRaw = -MAX_WBITS;
constexpr int kGzipOnly = 16 + MAX_WBITS;

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

void append_little_endian(std::uint64_t value, std::string& bytes) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xffU));
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
  append_little_endian(crc, pieces.emplace_back());
  append_little_endian(size, pieces.back());
  return pieces;
}

struct GzipReader::State {
  z_stream stream = {};
  std::string input;
  std::uint64_t next = 0;  // byte of the file
  bool at_end = false;
};

GzipReader::GzipReader(const InputFile& file) : file_(file), state_(std::make_unique<State>()) {
  if (inflateInit2(&state_->stream, kGzipOnly) != Z_OK) throw std::bad_alloc();
}

GzipReader::~GzipReader() { inflateEnd(&state_->stream); }

void GzipReader::refill() {
  const std::uint64_t left = file_.size() - state_->next;
  if (left == 0) file_.fail("truncated: the gzip stream does not end within the file");
  state_->input.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left, kPart)));
  file_.read(state_->next, state_->input.data(), state_->input.size());
  state_->next += state_->input.size();
  state_->stream.next_in = reinterpret_cast<Bytef*>(state_->input.data());
  state_->stream.avail_in = static_cast<uInt>(state_->input.size());
}

void GzipReader::end() {
  state_->at_end = true;
  const bool is_whole = state_->stream.avail_in == 0 && state_->next == file_.size();
  if (!is_whole) file_.fail("expected nothing after the end of the gzip stream, got further bytes");
}

std::string GzipReader::read(std::size_t count) {
  std::string out;
  while (out.size() < count && !state_->at_end) {
    if (state_->stream.avail_in == 0) refill();
    const std::size_t old = out.size();
    out.resize(old + std::min(count - old, 4 * kPart));  // grows as data arrives, whatever a header promises
    state_->stream.next_out = reinterpret_cast<Bytef*>(&out[old]);
    state_->stream.avail_out = static_cast<uInt>(out.size() - old);
    const int result = inflate(&state_->stream, Z_NO_FLUSH);
    out.resize(out.size() - state_->stream.avail_out);
    if (result == Z_STREAM_END) end();
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) file_.fail("a damaged gzip stream");
  }
  return out;
}

}  // namespace sh::prt
