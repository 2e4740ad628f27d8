#include "prt/medium/density_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "prt/binary/gzip_reader.hpp"
#include "prt/binary/input_file.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kLongestHeader = std::size_t{1} << 16U;

/// A type of numbers: its names in NRRD, its size, and how it is read from bytes in the machine's order.
struct NumberType {
  std::vector<std::string_view> names;
  std::size_t size;
  float (*read)(const char* bytes);
};

template <class T>
float read_as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<float>(value);
}

template <class T>
NumberType number_type(std::vector<std::string_view> names) {
  return {std::move(names), sizeof(T), read_as<T>};
}

const std::vector<NumberType>& number_types() {
  static const std::vector<NumberType> kTypes = {
      number_type<float>({"float"}),
      number_type<double>({"double"}),
      number_type<std::uint8_t>({"uchar", "unsigned char", "uint8", "uint8_t"}),
      number_type<std::int8_t>({"signed char", "int8", "int8_t"}),
      number_type<std::uint16_t>({"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}),
      number_type<std::int16_t>({"short", "short int", "signed short", "signed short int", "int16", "int16_t"}),
      number_type<std::uint32_t>({"uint", "unsigned int", "uint32", "uint32_t"}),
      number_type<std::int32_t>({"int", "signed int", "int32", "int32_t"}),
      number_type<std::uint64_t>({"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}),
      number_type<std::int64_t>(
          {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"})};
  return kTypes;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return text;
}

/// What the text before the data of an NRRD file says.
struct NrrdHeader {
  std::size_t end = 0;  // byte of the file where the data begin
  const NumberType* type = nullptr;
  bool is_gzip = false;
  bool is_swapped = false;
  Counts counts = {0, 0, 0};
};

class NrrdHeaderReader {
 public:
  explicit NrrdHeaderReader(const InputFile& file) : file_(file), text_(file.start(kLongestHeader)) {}

  NrrdHeader read() {
    if (!text_.starts_with("NRRD000")) file_.fail("not an NRRD file: it does not begin with `NRRD000`");
    next_line();
    while (true) {
      const std::string_view line = next_line();
      if (line.empty()) break;
      if (line.front() != '#') take(line);
    }
    finish();
    return header_;
  }

 private:
  std::string_view next_line() {
    const std::size_t end = text_.find('\n', header_.end);
    if (end == std::string::npos) {
      file_.fail(fmt::format("expected an empty line after an NRRD header of at most {} bytes", kLongestHeader));
    }
    const std::string_view line = trimmed(std::string_view(text_).substr(header_.end, end - header_.end));
    header_.end = end + 1;
    return line;
  }

  [[noreturn]] void expected(std::string_view what, std::string_view got) const {
    file_.fail(fmt::format("expected an NRRD file with {}, got `{}`", what, shown(got)));
  }

  void take(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) expected("lines `field: value`", line);
    if (line.substr(colon).starts_with(":=")) return;  // a key of the user
    const std::string_view field = line.substr(0, colon);
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (field == "type") take_type(value);
    if (field == "dimension" && value != "3") expected("dimension: 3", line);
    if (field == "sizes") take_sizes(value);
    if (field == "encoding") take_encoding(value);
    if (field == "endian") take_endian(value);
    if (field == "data file" || field == "datafile") expected("its data in the same file", line);
    if ((field == "line skip" || field == "lineskip" || field == "byte skip" || field == "byteskip") && value != "0") {
      expected("data right after its header", line);
    }
  }

  void take_type(std::string_view value) {
    const auto found = std::find_if(number_types().begin(), number_types().end(), [&](const NumberType& type) {
      return std::find(type.names.begin(), type.names.end(), value) != type.names.end();
    });
    if (found == number_types().end()) expected("a type of numbers such as float or uint8", value);
    header_.type = &*found;
  }

  void take_sizes(std::string_view value) {
    const char* next = value.data();
    const char* end = next + value.size();
    for (int& count : header_.counts) {
      while (next != end && *next == ' ') ++next;
      const auto [after, error] = std::from_chars(next, end, count);
      if (error != std::errc() || (after != end && *after != ' ')) expected(flaw_of(Counts{0, 0, 0}), value);
      next = after;
    }
    if (next != end || !flaw_of(header_.counts).empty()) expected(flaw_of(Counts{0, 0, 0}), value);
  }

  void take_encoding(std::string_view value) {
    header_.is_gzip = value == "gzip" || value == "gz";
    if (!header_.is_gzip && value != "raw") expected("the encoding raw or gzip", value);
    has_encoding_ = true;
  }

  void take_endian(std::string_view value) {
    if (value != "little" && value != "big") expected("the endian little or big", value);
    header_.is_swapped = (value == "little") != (std::endian::native == std::endian::little);
    has_endian_ = true;
  }

  void finish() const {
    if (header_.type == nullptr) file_.fail("expected an NRRD file with a field `type`");
    if (header_.counts[0] == 0) file_.fail("expected an NRRD file with a field `sizes`");
    if (!has_encoding_) file_.fail("expected an NRRD file with a field `encoding`");
    if (!has_endian_ && header_.type->size > 1) file_.fail("expected an NRRD file with a field `endian`");
  }

  const InputFile& file_;
  std::string text_;
  NrrdHeader header_;
  bool has_encoding_ = false;
  bool has_endian_ = false;
};

/// The numbers, piece by piece; `next(bytes)` gives the following bytes, fewer at the end.
template <class Next>
std::vector<float> read_values(const InputFile& file, const NrrdHeader& header, Next next) {
  constexpr std::size_t kPiece = std::size_t{1} << 20U;
  const std::size_t count = voxel_count(header.counts);
  std::vector<float> values;
  while (values.size() < count) {
    const std::size_t some = std::min(kPiece, count - values.size());
    std::string bytes = next(some * header.type->size);
    if (bytes.size() != some * header.type->size) {
      file.fail(fmt::format("truncated: expected {} numbers, got {}", count,
                            values.size() + bytes.size() / header.type->size));
    }
    for (std::size_t i = 0; i < some; ++i) {
      char* number = &bytes[i * header.type->size];
      if (header.is_swapped) std::reverse(number, number + header.type->size);
      values.push_back(header.type->read(number));
    }
  }
  if (!next(1U).empty()) file.fail(fmt::format("expected {} numbers, got further bytes after them", count));
  return values;
}

std::vector<float> read_values(const InputFile& file, const NrrdHeader& header) {
  if (header.is_gzip) {
    GzipReader reader(file, header.end);
    return read_values(file, header, [&](std::size_t bytes) { return reader.read(bytes); });
  }
  return read_values(file, header, [&, from = std::uint64_t{header.end}](std::size_t bytes) mutable {
    std::string data(std::size_t(std::min<std::uint64_t>(bytes, file.size() - from)), '\0');
    if (!data.empty()) file.read(from, data.data(), data.size());
    from += data.size();
    return data;
  });
}

std::string text_of(const Counts& counts) { return fmt::format("{} x {} x {}", counts[0], counts[1], counts[2]); }

}  // namespace

DensityValues read_density(const std::string& path, const std::optional<Counts>& counts) {
  const InputFile file(path);
  NrrdHeader header{.type = &number_types().front(), .counts = counts.value_or(Counts{0, 0, 0})};
  if (path.ends_with(".nrrd")) {
    header = NrrdHeaderReader(file).read();
  } else if (!counts) {
    file.fail("expected `counts` beside the name of a file of raw numbers");
  }
  if (counts && header.counts != *counts) {
    file.fail(fmt::format("expected {} numbers as `counts` says, got {}", text_of(*counts), text_of(header.counts)));
  }
  DensityValues read{header.counts, read_values(file, header)};
  Density density{.counts = read.counts};
  density.values.swap(read.values);
  if (const std::string flaw = flaw_of(density); !flaw.empty()) file.fail(flaw);
  read.values.swap(density.values);
  return read;
}

}  // namespace sh::prt
