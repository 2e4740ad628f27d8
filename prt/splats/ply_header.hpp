// The header of a PLY file of splats. Reference: Greg Turk, "The PLY Polygon File Format" (1994).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sh::prt {

class InputFile;

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

enum class PlyType : std::uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat;
  std::size_t offset = 0;  // within a record
};

/// The records are those of the element `vertex`.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kLittleEndian;
  std::vector<std::string> lines;  // as in the file, with their ends; the last is end_header
  std::size_t vertex_line = 0;     // number of the line `element vertex N`
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t record_size = 0;
  std::uint64_t records = 0;      // offset of the first record in the file
  std::string other_elements;     // names; their bytes follow the records, and are kept as they are
  std::uint64_t other_bytes = 0;  // of them, at least: lists may have any length
  bool has_lists = false;         // in them

  [[nodiscard]] const PlyProperty* find(std::string_view name) const;
  /// Bytes from the first record to the end of the last.
  [[nodiscard]] std::uint64_t body_size() const { return count * record_size; }
};

/// Throws std::runtime_error with one line for what is not a PLY file, or has an element before the vertices,
/// properties twice, lists in the vertices, or numbers of records and bytes that do not agree.
PlyHeader read_ply_header(const InputFile& file);

/// The degree of the splats. Throws std::runtime_error with one line that names the first property that is missing or
/// is no floating-point number.
int splat_degree(const PlyHeader& header, const InputFile& file);

/// x, y, z, nx, ..., rot_3 as the training writes them.
std::vector<std::string> splat_properties(int degree);

/// Text of a header with these properties. `like`, if any, gives all other lines.
std::string ply_header_text(const std::vector<PlyProperty>& properties, std::uint64_t count, const PlyHeader* like);

}  // namespace sh::prt
