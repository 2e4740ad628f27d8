#include "prt/splats/spz_data.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "prt/binary/gzip.hpp"
#include "prt/binary/gzip_reader.hpp"
#include "prt/binary/input_file.hpp"
#include "prt/chunks.hpp"
#include "prt/splats/splats.hpp"

namespace sh::prt {
namespace {

constexpr std::string_view kMagic = "NGSP";
constexpr int kZstdVersion = 4;
constexpr std::size_t kGzipHeader = 16;
constexpr std::size_t kZstdHeader = 32;
constexpr std::size_t kStreamEntry = 16;  // compressed and full size
constexpr int kZstdLevel = 12;

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

SpzHeader header_of(std::string_view bytes, const InputFile& file) {
  if (bytes.size() < kGzipHeader || bytes.substr(0, 4) != kMagic) {
    file.fail("not an SPZ file: expected `NGSP` in its first bytes");
  }
  SpzHeader header;
  const auto version = number_at<std::uint32_t>(bytes, 4);
  if (version < 2 || version > kZstdVersion) {
    file.fail(fmt::format("SPZ of version {}: expected version 2, 3 or 4", version));
  }
  header.version = static_cast<int>(version);
  header.count = number_at<std::uint32_t>(bytes, 8);
  header.degree = number_at<std::uint8_t>(bytes, 12);
  header.fractional_bits = number_at<std::uint8_t>(bytes, 13);
  header.flags = number_at<std::uint8_t>(bytes, 14);
  if (header.degree > kHighestSplatDegree) {
    file.fail(fmt::format("SPZ of degree {}: expected 0 to {}", header.degree, kHighestSplatDegree));
  }
  constexpr int kMostBits = 23;
  if (header.fractional_bits > kMostBits) {
    file.fail(
        fmt::format("SPZ with positions of {} fractional bits: expected 0 to {}", header.fractional_bits, kMostBits));
  }
  return header;
}

[[noreturn]] void fail_short(const InputFile& file, const SpzHeader& header, std::size_t part, std::uint64_t expected,
                             std::uint64_t got) {
  file.fail(fmt::format("truncated: the header announces {} splats of degree {}, whose part {} has {} bytes; got {}",
                        header.count, header.degree, part, expected, got));
}

SpzData read_gzip(const InputFile& file) {
  GzipReader reader(file);
  SpzData data;
  data.header = header_of(reader.read(kGzipHeader), file);
  if (data.header.version >= kZstdVersion) file.fail("SPZ of version 4 in a gzip stream: expected version 2 or 3");
  for (std::size_t part = 0; part < kSpzParts; ++part) {
    const std::uint64_t size = std::uint64_t{data.header.count} * spz_size(static_cast<SpzPart>(part), data.header);
    data.parts[part] = reader.read(size);
    if (data.parts[part].size() < size) fail_short(file, data.header, part, size, data.parts[part].size());
  }
  constexpr std::size_t kMostExtensions = std::size_t{1} << 24U;
  data.extension_bytes = reader.read(kMostExtensions).size();  // and the checksum at the end of the stream
  if (data.extension_bytes > 0 && (data.header.flags & kSpzExtensions) == 0) {
    file.fail(fmt::format("the header announces {} splats of degree {}, the file has more bytes", data.header.count,
                          data.header.degree));
  }
  return data;
}

/// Grows as data arrives, whatever the header promises.
std::string unpack_zstd(const InputFile& file, std::uint64_t offset, std::uint64_t packed, std::uint64_t size) {
  std::string from(static_cast<std::size_t>(packed), '\0');
  file.read(offset, from.data(), from.size());
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
  if (!stream) throw std::bad_alloc();
  std::string to;
  ZSTD_inBuffer in = {from.data(), from.size(), 0};
  std::size_t left = 1;
  while (left != 0) {
    constexpr std::size_t kStep = std::size_t{1} << 22U;
    const std::size_t old = to.size();
    to.resize(old + kStep);
    ZSTD_outBuffer out = {&to[old], kStep, 0};
    left = ZSTD_decompressStream(stream.get(), &out, &in);
    to.resize(old + out.pos);
    if (ZSTD_isError(left) != 0 || (out.pos == 0 && in.pos == in.size && left != 0)) {
      file.fail("a damaged zstd stream");
    }
    if (to.size() > size) file.fail("a zstd stream of an SPZ file has more bytes than its header announces");
  }
  return to;
}

SpzData read_zstd(const InputFile& file) {
  const std::string start = file.start(kZstdHeader);
  SpzData data;
  data.header = header_of(start, file);
  if (start.size() < kZstdHeader) file.fail("truncated: expected an SPZ header of 32 bytes");
  if (data.header.version != kZstdVersion) {
    file.fail(fmt::format("SPZ of version {} without gzip: expected version 4", data.header.version));
  }
  constexpr std::uint64_t kMostSplatsPerByte = 1024 / 9;  // positions, 9 bytes a splat, pack less than 1024 times
  if (data.header.count > kMostSplatsPerByte * file.size()) {
    file.fail(
        fmt::format("the header announces {} splats, more than {} bytes can hold", data.header.count, file.size()));
  }
  const std::size_t streams = number_at<std::uint8_t>(start, 15);
  const std::uint64_t table = number_at<std::uint32_t>(start, 16);
  data.extension_bytes = table < kZstdHeader ? 0 : table - kZstdHeader;
  std::string entries(streams * kStreamEntry, '\0');
  if (table < kZstdHeader || table + entries.size() > file.size()) file.fail("truncated: expected a table of streams");
  file.read(table, entries.data(), entries.size());
  std::size_t used = 0;
  for (std::size_t part = 0; part < kSpzParts; ++part) {
    used += data.header.count > 0 && spz_size(static_cast<SpzPart>(part), data.header) > 0 ? 1 : 0;
  }
  if (streams != used) file.fail(fmt::format("SPZ with {} streams: expected {}, one for each part", streams, used));
  std::uint64_t offset = table + entries.size();
  std::size_t stream = 0;
  for (std::size_t part = 0; part < kSpzParts; ++part) {
    const std::uint64_t size = std::uint64_t{data.header.count} * spz_size(static_cast<SpzPart>(part), data.header);
    if (size == 0) continue;
    const auto packed = number_at<std::uint64_t>(entries, stream * kStreamEntry);
    const auto full = number_at<std::uint64_t>(entries, stream * kStreamEntry + 8);
    if (full != size) fail_short(file, data.header, part, size, full);
    if (packed > file.size() - offset) file.fail("truncated: a zstd stream ends after the file");
    data.parts[part] = unpack_zstd(file, offset, packed, size);
    if (data.parts[part].size() != size) fail_short(file, data.header, part, size, data.parts[part].size());
    offset += packed;
    ++stream;
  }
  if (offset != file.size()) file.fail("expected nothing after the zstd streams, got further bytes");
  return data;
}

std::string header_bytes(const SpzHeader& header) {
  std::string bytes(kMagic);
  append(bytes, static_cast<std::uint32_t>(header.version));
  append(bytes, header.count);
  for (const int value : {header.degree, header.fractional_bits, header.flags & kSpzAntialiased, 0}) {
    bytes.push_back(static_cast<char>(value));
  }
  return bytes;
}

std::string zstd(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

std::vector<std::string> zstd_file(const SpzData& data) {
  std::vector<std::string> pieces(1);
  std::vector<std::size_t> used;
  for (std::size_t part = 0; part < kSpzParts; ++part) {
    if (!data.parts[part].empty()) used.push_back(part);
  }
  pieces.resize(1 + used.size());
  in_parallel(std::size_t{0}, used.size(), [&](std::size_t i) { pieces[i + 1] = zstd(data.parts[used[i]]); });
  std::string& front = pieces[0];
  front = header_bytes(data.header);
  front.back() = static_cast<char>(used.size());
  append(front, static_cast<std::uint32_t>(kZstdHeader));
  front.resize(kZstdHeader, '\0');
  for (std::size_t i = 0; i < used.size(); ++i) {
    append(front, static_cast<std::uint64_t>(pieces[i + 1].size()));
    append(front, static_cast<std::uint64_t>(data.parts[used[i]].size()));
  }
  return pieces;
}

}  // namespace

std::size_t spz_size(SpzPart part, const SpzHeader& header) {
  switch (part) {
    case SpzPart::kPosition:
      return 9;
    case SpzPart::kOpacity:
      return 1;
    case SpzPart::kColor:
    case SpzPart::kScale:
      return 3;
    case SpzPart::kRotation:
      return header.version == 2 ? 3 : 4;
    case SpzPart::kHarmonics:
      return 3 * (splat_bands_squared(header.degree) - 1);
  }
  return 0;
}

SpzData read_spz(const InputFile& file) {
  const std::string start = file.start(4);
  return start == kMagic ? read_zstd(file) : read_gzip(file);
}

std::vector<std::string> spz_file(const SpzData& data) {
  if (data.header.version == kZstdVersion) return zstd_file(data);
  const std::string header = header_bytes(data.header);
  std::vector<std::string_view> views = {header};
  views.insert(views.end(), data.parts.begin(), data.parts.end());
  return gzip(views);
}

}  // namespace sh::prt
