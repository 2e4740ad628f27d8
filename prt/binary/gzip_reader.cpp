#include "prt/binary/gzip_reader.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>

#include "prt/binary/input_file.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kPart = std::size_t{1} << 20U;  // of the file, read at once
constexpr int kGzipOnly = 16 + MAX_WBITS;

}  // namespace

struct GzipReader::State {
  z_stream stream = {};
  std::string input;
  std::uint64_t next = 0;  // byte of the file
  bool at_end = false;
};

GzipReader::GzipReader(const InputFile& file, std::uint64_t first_byte)
    : file_(file), state_(std::make_unique<State>()) {
  state_->next = first_byte;
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
