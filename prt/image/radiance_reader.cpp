// Radiance RGBE pictures (.hdr): text header, then scanlines, run-length encoded or plain.
// The project does not use stb_image: version 2.27 loops forever on a truncated run-length encoded file and returns
// uninitialized memory for a truncated plain file.
// References: Greg Ward, "Real Pixels", Graphics Gems II (1991), p. 80; Radiance file formats, filefmts.pdf.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "numeric/output/printable.hpp"
#include "prt/image/image.hpp"

namespace sh::prt {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// The bytes of the file with a read position; every step past the end is an error.
class Reader {
 public:
  Reader(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  std::string_view line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) fail("is truncated in its header");
    std::string_view text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }
  std::uint8_t byte() {
    if (at_ >= bytes_.size()) fail(fmt::format("is truncated in row {}", row));
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }
  void back(std::size_t count) { at_ -= count; }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(
        fmt::format("{}: {}; expected a complete Radiance .hdr picture", file_, output::printable(what)));
  }

  int row = 0;

 private:
  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_ = 0;
};

struct Header {
  int width = 0;
  int height = 0;
  double exposure = 1.0;
};

Header read_header(const std::string& file, Reader& reader) {
  Header header;
  reader.line();  // #?RADIANCE or #?RGBE
  bool rgbe = false;
  for (std::string_view line = reader.line(); !line.empty(); line = reader.line()) {
    if (line.starts_with("FORMAT=")) {
      rgbe = line == "FORMAT=32-bit_rle_rgbe";
      if (!rgbe) reader.fail(fmt::format("has {}; expected FORMAT=32-bit_rle_rgbe", line));
    } else if (line.starts_with("EXPOSURE=")) {
      const std::string text(line.substr(9));
      const double factor = std::strtod(text.c_str(), nullptr);
      if (!std::isfinite(factor) || factor <= 0.0) {
        reader.fail(fmt::format("has the exposure `{}`, which is no positive number", text));
      }
      header.exposure *= factor;  // several multiply
    }
  }
  if (!rgbe) reader.fail("has no line FORMAT=32-bit_rle_rgbe in its header");
  const std::string size(reader.line());
  int used = 0;
  if (std::sscanf(size.c_str(), "-Y %9d +X %9d%n", &header.height, &header.width, &used) != 2 ||
      static_cast<std::size_t>(used) != size.size()) {
    reader.fail(fmt::format("has the size line `{}`; expected `-Y HEIGHT +X WIDTH` (top row first)", size));
  }
  require_sane_size(file, header.width, header.height);
  return header;
}

/// One channel of a run-length encoded scanline: runs of 129..255 = 128 + count, dumps of 1..128.
void read_channel(Reader& reader, std::vector<Rgbe>& scanline, std::size_t channel) {
  for (std::size_t i = 0; i < scanline.size();) {
    const std::uint8_t code = reader.byte();
    const bool run = code > 128;
    const std::size_t count = run ? code - 128U : code;
    if (count == 0 || count > scanline.size() - i) {
      reader.fail(fmt::format("has a wrong run length in row {}", reader.row));
    }
    std::uint8_t value = run ? reader.byte() : std::uint8_t{0};
    for (std::size_t k = 0; k < count; ++k) {
      if (!run) value = reader.byte();
      scanline[i++][channel] = value;
    }
  }
}

/// Plain pixels. (1, 1, 1, n) repeats the previous pixel n << (8 * k) times, where k is the number of such pixels just
/// before.
void read_plain(Reader& reader, std::vector<Rgbe>& scanline) {
  int shift = 0;
  for (std::size_t i = 0; i < scanline.size();) {
    const Rgbe pixel = reader.pixel();
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      scanline[i++] = pixel;
      shift = 0;
      continue;
    }
    const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << static_cast<unsigned>(shift) : scanline.size() + 1;
    if (i == 0 || count > scanline.size() - i) reader.fail(fmt::format("has a wrong repetition in row {}", reader.row));
    for (std::size_t k = 0; k < count; ++k, ++i) scanline[i] = scanline[i - 1];
    shift += 8;
  }
}

void read_scanline(Reader& reader, std::vector<Rgbe>& scanline) {
  const Rgbe start = reader.pixel();
  const bool encoded =
      scanline.size() >= 8 && scanline.size() < 32768 && start[0] == 2 && start[1] == 2 && start[2] < 128;
  if (!encoded) {
    reader.back(4);
    read_plain(reader, scanline);
    return;
  }
  if (static_cast<std::size_t>(start[2]) * 256U + start[3] != scanline.size()) {
    reader.fail(fmt::format("has a wrong length of row {}", reader.row));
  }
  for (std::size_t channel = 0; channel < 4; ++channel) read_channel(reader, scanline, channel);
}

/// [Ward91] value = (mantissa + 1/2) / 256 * 2^(e - 128). This reader omits the half, like most programs: black stays
/// black, and mantissa 128 at e = 129 is exactly 1.
Eigen::Vector3f to_linear(const Rgbe& pixel, double exposure) {
  if (pixel[3] == 0) return Eigen::Vector3f::Zero();
  const double factor = std::ldexp(1.0, static_cast<int>(pixel[3]) - (128 + 8)) / exposure;
  return (Eigen::Vector3d(pixel[0], pixel[1], pixel[2]) * factor).cast<float>();
}

}  // namespace

Image read_radiance(const std::string& file, std::string_view bytes) {
  Reader reader(file, bytes);
  const Header header = read_header(file, reader);
  Image image{header.width, header.height, {}, 0};
  std::vector<Rgbe> scanline(header.width);
  for (reader.row = 0; reader.row < header.height; ++reader.row) {
    read_scanline(reader, scanline);
    for (const Rgbe& pixel : scanline) image.pixels.push_back(to_linear(pixel, header.exposure));
  }
  return image;
}

}  // namespace sh::prt
