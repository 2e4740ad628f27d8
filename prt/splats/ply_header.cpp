#include "prt/splats/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <utility>

#include "prt/binary/input_file.hpp"
#include "prt/splats/splats.hpp"

namespace sh::prt {
namespace {

constexpr std::size_t kLongestHeader = std::size_t{1} << 20U;

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array kTypes = {
    TypeName{"char", PlyType::kInt8},     TypeName{"int8", PlyType::kInt8},     TypeName{"uchar", PlyType::kUint8},
    TypeName{"uint8", PlyType::kUint8},   TypeName{"short", PlyType::kInt16},   TypeName{"int16", PlyType::kInt16},
    TypeName{"ushort", PlyType::kUint16}, TypeName{"uint16", PlyType::kUint16}, TypeName{"int", PlyType::kInt32},
    TypeName{"int32", PlyType::kInt32},   TypeName{"uint", PlyType::kUint32},   TypeName{"uint32", PlyType::kUint32},
    TypeName{"float", PlyType::kFloat},   TypeName{"float32", PlyType::kFloat}, TypeName{"double", PlyType::kDouble},
    TypeName{"float64", PlyType::kDouble}};

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<PlyType> type_called(const std::string& name) {
  const auto* found = std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& t) { return t.name == name; });
  return found == kTypes.end() ? std::nullopt : std::optional(found->type);
}

std::optional<std::uint64_t> count_of(const std::string& word) {
  std::uint64_t count = 0;
  const auto end = std::from_chars(word.data(), word.data() + word.size(), count);
  const bool is_whole = end.ec == std::errc() && end.ptr == word.data() + word.size();
  return is_whole ? std::optional(count) : std::nullopt;
}

/// Reads line by line; an error names the line.
class HeaderParser {
 public:
  explicit HeaderParser(const InputFile& file) : file_(file) {}

  PlyHeader parse() {
    split_lines();
    if (trimmed(header_.lines[0]) != "ply") file_.fail("not a PLY file: expected `ply` in the first line");
    for (line_ = 1; line_ + 1 < header_.lines.size(); ++line_) take(words_of(header_.lines[line_]));
    if (!has_format_) file_.fail("PLY header: expected a line `format`, such as `format binary_little_endian 1.0`");
    if (header_.vertex_line == 0) file_.fail("PLY header: expected a line `element vertex N`");
    return std::move(header_);
  }

 private:
  static std::string trimmed(std::string line) {
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r' || line.back() == ' ')) line.pop_back();
    return line;
  }

  void split_lines() {
    const std::string start = file_.start(kLongestHeader);
    if (!start.starts_with("ply")) file_.fail("not a PLY file: expected `ply` in the first line");
    for (std::size_t from = 0; from < start.size();) {
      const std::size_t end = start.find('\n', from);
      if (end == std::string::npos) break;
      header_.lines.push_back(start.substr(from, end + 1 - from));
      from = end + 1;
      if (trimmed(header_.lines.back()) == "end_header") {
        header_.records = from;
        return;
      }
    }
    file_.fail(fmt::format("PLY header: expected `end_header` within the first {} bytes", kLongestHeader));
  }

  [[noreturn]] void refuse(const std::string& what) const {
    file_.fail(fmt::format("line {} of the PLY header: {}", line_ + 1, what));
  }

  void take(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return;
    if (words[0] == "format") return take_format(words);
    if (words[0] == "element") return take_element(words);
    if (words[0] == "property") return take_property(words);
    refuse(fmt::format("expected comment, format, element or property, got `{}`", shown(words[0])));
  }

  void take_format(const std::vector<std::string>& words) {
    constexpr std::array<std::string_view, 3> kNames = {"ascii", "binary_little_endian", "binary_big_endian"};
    const auto* found = words.size() == 3 ? std::find(kNames.begin(), kNames.end(), words[1]) : kNames.end();
    if (found == kNames.end() || words[2] != "1.0") {
      refuse("expected `format binary_little_endian 1.0`, binary_big_endian or ascii");
    }
    header_.encoding = static_cast<PlyEncoding>(found - kNames.begin());
    has_format_ = true;
  }

  void take_element(const std::vector<std::string>& words) {
    const auto count = words.size() == 3 ? count_of(words[2]) : std::nullopt;
    if (!count) refuse("expected `element NAME COUNT`, with a whole number");
    if (words[1] == "vertex") {
      if (header_.vertex_line != 0) refuse("expected one element `vertex`, got a second");
      if (!header_.other_elements.empty()) refuse("expected the vertices before all other elements");
      header_.vertex_line = line_;
      header_.count = *count;
      return;
    }
    if (header_.vertex_line == 0)
      refuse(fmt::format("expected the vertices first, got the element `{}`", shown(words[1])));
    header_.other_elements += (header_.other_elements.empty() ? "" : ", ") + words[1];
    other_count_ = *count;
  }

  void take_property(const std::vector<std::string>& words) {
    if (header_.vertex_line == 0) refuse("expected an element before its properties");
    const bool is_other = !header_.other_elements.empty();
    if (words.size() == 5 && words[1] == "list") {
      if (!is_other) refuse(fmt::format("expected a number for each vertex, got the list `{}`", shown(words[4])));
      header_.has_lists = true;
      return;
    }
    const auto type = words.size() == 3 ? type_called(words[1]) : std::nullopt;
    if (!type) refuse("expected `property TYPE NAME`, with a type such as float");
    if (is_other) {
      add_other(size_of(*type));
      return;
    }
    if (header_.find(words[2]) != nullptr) refuse(fmt::format("the property `{}` stands there twice", shown(words[2])));
    header_.properties.push_back({words[2], *type, header_.record_size});
    header_.record_size += size_of(*type);
  }

  // Counts that no file can hold become the largest size, which no file has.
  void add_other(std::size_t size) {
    const std::uint64_t most = file_.size() + 1;
    const bool is_beyond = other_count_ > most / size;
    header_.other_bytes = std::min(most, header_.other_bytes + (is_beyond ? most : other_count_ * size));
  }

  const InputFile& file_;
  PlyHeader header_;
  std::size_t line_ = 0;
  bool has_format_ = false;
  std::uint64_t other_count_ = 0;
};

// The bytes that the header announces are those that are there.
void require_size(const PlyHeader& header, const InputFile& file) {
  const std::uint64_t there = file.size() - header.records;
  const std::uint64_t fit = header.record_size == 0 ? 0 : there / header.record_size;
  if (header.count > fit) {
    file.fail(fmt::format("truncated: the header announces {} splats of {} bytes, the file has {} of them",
                          header.count, header.record_size, fit));
  }
  const std::uint64_t announced = header.body_size() + header.other_bytes;
  if (there < announced || (there > announced && !header.has_lists)) {
    file.fail(fmt::format("the header announces {} bytes of data ({} splats of {} bytes{}), the file has {}", announced,
                          header.count, header.record_size,
                          header.other_elements.empty() ? "" : " and " + header.other_elements, there));
  }
}

bool is_missing(const PlyHeader& header, const std::string& name) { return header.find(name) == nullptr; }

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

const PlyProperty* PlyHeader::find(std::string_view name) const {
  const auto found = std::find_if(properties.begin(), properties.end(), [&](const auto& p) { return p.name == name; });
  return found == properties.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(const InputFile& file) {
  PlyHeader header = HeaderParser(file).parse();
  if (header.encoding != PlyEncoding::kText) require_size(header, file);
  if (header.encoding != PlyEncoding::kLittleEndian && !header.other_elements.empty()) {
    file.fail(fmt::format("expected binary_little_endian, as the file has other elements than splats ({})",
                          header.other_elements));
  }
  return header;
}

std::vector<std::string> splat_properties(int degree) {
  std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"};
  for (std::size_t i = 0; i < 3 * (splat_bands_squared(degree) - 1); ++i) names.push_back(fmt::format("f_rest_{}", i));
  for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"}) {
    names.emplace_back(name);
  }
  return names;
}

int splat_degree(const PlyHeader& header, const InputFile& file) {
  if (header.find("packed_position") != nullptr) {
    file.fail("a compressed PLY file (packed_position): expected an uncompressed one, with x, y, z and f_dc_0");
  }
  const auto rest = static_cast<std::size_t>(std::count_if(
      header.properties.begin(), header.properties.end(), [](const auto& p) { return p.name.starts_with("f_rest_"); }));
  int degree = 0;
  while (degree < kHighestSplatDegree && 3 * (splat_bands_squared(degree) - 1) < rest) ++degree;
  const auto names = splat_properties(degree);
  for (const std::string& name : names) {
    const bool is_optional = name.size() == 2 && name[0] == 'n';
    if (is_missing(header, name)) {
      if (is_optional) continue;
      file.fail(fmt::format("expected the property `{}` of a Gaussian splat, which is missing{}", name,
                            name.starts_with("f_rest_")
                                ? fmt::format("; {} properties f_rest_ are there, expected 0, 9, 24, 45 or 72", rest)
                                : ""));
    }
    const PlyType type = header.find(name)->type;
    if (type != PlyType::kFloat && type != PlyType::kDouble) {
      file.fail(fmt::format("expected the property `{}` of type float or double", name));
    }
  }
  if (rest != 3 * (splat_bands_squared(degree) - 1)) {
    file.fail(fmt::format("{} properties f_rest_ are there, expected 0, 9, 24, 45 or 72", rest));
  }
  return degree;
}

std::string ply_header_text(const std::vector<PlyProperty>& properties, std::uint64_t count, const PlyHeader* like) {
  constexpr std::array<std::string_view, 8> kNames = {"char", "uchar", "short", "ushort",
                                                      "int",  "uint",  "float", "double"};
  std::string list;
  for (const PlyProperty& p : properties) {
    list += fmt::format("property {} {}\n", kNames[static_cast<std::size_t>(p.type)], p.name);
  }
  const std::string element = fmt::format("element vertex {}\n", count);
  if (like == nullptr) return "ply\nformat binary_little_endian 1.0\n" + element + list + "end_header\n";
  const bool is_same = properties.size() == like->properties.size();  // other degrees have other numbers of them
  std::string text;
  bool is_vertex = false;
  for (std::size_t i = 0; i < like->lines.size(); ++i) {
    const std::vector<std::string> words = words_of(like->lines[i]);
    const std::string first = words.empty() ? "" : words[0];
    if (is_vertex && !is_same && (first == "element" || first == "end_header")) text += std::exchange(list, "");
    if (first == "element" || first == "end_header") is_vertex = i == like->vertex_line;
    if (first == "format" && like->encoding != PlyEncoding::kLittleEndian) {
      text += "format binary_little_endian 1.0\n";
    } else if (i == like->vertex_line) {
      text += count == like->count ? like->lines[i] : element;
    } else if (is_same || !(is_vertex && first == "property")) {
      text += like->lines[i];
    }
  }
  return text;
}

}  // namespace sh::prt
