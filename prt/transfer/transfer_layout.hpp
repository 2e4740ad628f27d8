// The layout of a transfer file, shared by its writer and its reader. prt/FILES.md states it byte by byte.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "prt/transfer/checksum.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt::layout {

static_assert(std::endian::native == std::endian::little, "transfer files are little-endian and read as they lie");

inline constexpr std::array<char, 8> kMagic = {'s', 'h', 'p', 'r', 't', '\r', '\n', '\x1a'};
inline constexpr std::uint32_t kVersion = 2;
inline constexpr std::uint32_t kOldestVersion = 1;  // its headers leave the shape to the kind

/// The first bytes of a file; `checksum` is XXH3-64 of the bytes before it followed by the section table.
struct Prologue {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t sections = 0;
  std::uint64_t file_size = 0;
  std::uint64_t header_size = 0;      // of the JSON text after the table, a multiple of 16
  std::uint64_t header_checksum = 0;  // XXH3-64 of that text
  std::uint64_t checksum = 0;
};

/// One entry of the table after the prologue. Its data are at `offset`; sections follow each other without gaps.
struct Section {
  std::array<char, 8> name{};  // padded with zeros
  std::uint32_t type = 0;      // of its elements
  std::uint32_t columns = 0;
  std::uint64_t rows = 0;
  std::uint64_t offset = 0;
  std::uint64_t checksum = 0;  // XXH3-64 of the data
};

inline constexpr std::uint32_t kFloat = 0;  // IEEE binary32
inline constexpr std::uint32_t kIndex = 1;  // unsigned, 32 bits
inline constexpr std::uint32_t kHalf = 2;   // IEEE binary16
inline constexpr std::uint32_t kByte = 3;   // signed, 8 bits
inline constexpr std::uint32_t kSmall = 4;  // unsigned, 16 bits

static_assert(sizeof(Prologue) == 48 && sizeof(Section) == 40);

/// The bytes of an element of one of the types above.
constexpr std::uint64_t size_of(std::uint32_t type) {
  return type == kByte ? 1 : type == kHalf || type == kSmall ? 2 : 4;
}

/// The type of the section `transfer`.
constexpr std::uint32_t type_of(Element element) {
  return element == Element::kByte ? kByte : element == Element::kHalf ? kHalf : kFloat;
}

constexpr std::uint64_t bytes_of(const Section& section) {
  return section.rows * section.columns * size_of(section.type);
}

/// The rows of a section; stored: one a receiver, or those of the clusters.
enum class Rows { kReceivers, kStored, kOne, kOther };
enum class Presence { kAlways, kOptional, kNever };

/// A section of a file. Sections stand in the order of kSections; presence_of() tells which a transfer has.
struct Kind {
  std::string_view name;
  std::uint32_t type;     // for `transfer`, the header may name another type
  std::uint32_t columns;  // 0: as many as a row has, or weights
  Rows rows;
  Presence presence;
};
inline constexpr std::array<Kind, 29> kSections = {
    {{"position", kFloat, 3, Rows::kReceivers, Presence::kAlways},
     {"normal", kFloat, 3, Rows::kReceivers, Presence::kAlways},
     {"geonorm", kFloat, 3, Rows::kReceivers, Presence::kAlways},
     {"albedo", kFloat, 3, Rows::kReceivers, Presence::kAlways},
     {"face", kIndex, 3, Rows::kOther, Presence::kAlways},
     {"remap", kIndex, 1, Rows::kOther, Presence::kAlways},
     {"transfer", kFloat, 0, Rows::kStored, Presence::kAlways},
     {"emitted", kFloat, 3, Rows::kReceivers, Presence::kOptional},
     {"scale", kFloat, 0, Rows::kOne, Presence::kOptional},
     {"mirror", kFloat, 3, Rows::kReceivers, Presence::kOptional},
     {"specular", kFloat, 3, Rows::kReceivers, Presence::kOptional},
     {"exponent", kFloat, 1, Rows::kReceivers, Presence::kOptional},
     {"brdf", kSmall, 1, Rows::kReceivers, Presence::kOptional},
     {"brdfrow", kFloat, even_count(kMaxDegree), Rows::kOther, Presence::kOptional},
     {"texture", kFloat, 2, Rows::kReceivers, Presence::kOptional},
     {"normmap", kSmall, 1, Rows::kReceivers, Presence::kOptional},
     {"normtex", kHalf, 3, Rows::kOther, Presence::kOptional},
     {"albmap", kSmall, 1, Rows::kReceivers, Presence::kOptional},
     {"tint", kFloat, 3, Rows::kReceivers, Presence::kOptional},
     {"albpic", kByte, 1, Rows::kOther, Presence::kOptional},
     {"chart", kFloat, 2, Rows::kReceivers, Presence::kOptional},
     {"atlas", kSmall, 1, Rows::kReceivers, Presence::kOptional},
     {"texel", kIndex, 1, Rows::kOther, Presence::kOptional},
     {"indirect", kHalf, 0, Rows::kStored, Presence::kAlways},
     {"cluster", kSmall, 1, Rows::kReceivers, Presence::kAlways},
     {"weight", kByte, 0, Rows::kReceivers, Presence::kAlways},
     {"icluster", kSmall, 1, Rows::kReceivers, Presence::kAlways},
     {"iweight", kByte, 0, Rows::kReceivers, Presence::kAlways},
     {"density", kFloat, 1, Rows::kReceivers, Presence::kAlways}}};

/// The sections of a mesh, which a transfer to the points of a grid does not have.
constexpr bool is_of_mesh(const Kind& kind) {
  constexpr std::array<std::string_view, 9> kOthers = {"transfer", "emitted",  "scale",   "indirect", "cluster",
                                                       "weight",   "icluster", "iweight", "density"};
  return std::find(kOthers.begin(), kOthers.end(), kind.name) == kOthers.end();
}
constexpr bool is_weight(const Kind& kind) { return kind.name.ends_with("weight"); }
constexpr bool is_of_clusters(const Kind& kind) { return is_weight(kind) || kind.name.ends_with("cluster"); }
constexpr bool is_of_indirect(const Kind& kind) { return kind.name.starts_with('i'); }

/// The shape of the numbers that a section belongs to.
inline const TransferShape& shape_of(const Kind& kind, const Transfer& transfer) {
  return is_of_indirect(kind) ? transfer.indirect_shape : transfer.shape;
}

/// The columns of a section of this transfer, whose shapes are known.
inline std::uint64_t columns_of(const Kind& kind, const Transfer& transfer) {
  if (kind.columns != 0) return kind.columns;
  const TransferShape& shape = shape_of(kind, transfer);
  return is_weight(kind) ? shape.storage.vectors : shape.stored_length();
}

/// Whether a file of this transfer, whose shapes are known, has a section. It has none without columns.
inline Presence presence_of(const Kind& kind, const Transfer& transfer) {
  const bool has_part = !is_of_indirect(kind) || transfer.kind->indirect != nullptr;
  const bool has_clusters = !is_of_clusters(kind) || shape_of(kind, transfer).storage.is_clustered();
  const bool has_mesh = !is_of_mesh(kind) || !transfer.kind->on_grid;
  if (kind.name == "density") return transfer.kind->in_medium ? kind.presence : Presence::kNever;
  return has_part && has_clusters && has_mesh && columns_of(kind, transfer) > 0 ? kind.presence : Presence::kNever;
}

/// The rows of a section of this transfer with so many receivers; those of Rows::kOther are as many as `otherwise`.
inline std::uint64_t rows_of(const Kind& kind, const Transfer& transfer, std::uint64_t receivers,
                             std::uint64_t otherwise) {
  if (kind.rows == Rows::kStored) return shape_of(kind, transfer).stored_rows(receivers);
  return kind.rows == Rows::kReceivers ? receivers : kind.rows == Rows::kOne ? 1 : otherwise;
}

/// Calls visit(items) for the contents of every section, in the order of kSections. `encoded` holds the rows of the
/// coefficients if their storage is not plain, `indirect` those of the matrices.
template <class AnyTransfer, class AnyEncoded, class Visit>
void each_section(AnyTransfer& transfer, AnyEncoded& encoded, AnyEncoded& indirect, const Visit& visit) {
  visit(transfer.mesh.positions);
  visit(transfer.mesh.normals);
  visit(transfer.mesh.geometric_normals);
  visit(transfer.mesh.albedo);
  visit(transfer.mesh.faces);
  visit(transfer.mesh.remap);
  transfer.shape.storage.is_plain() ? visit(transfer.coefficients) : visit(encoded.data);
  visit(transfer.emitted);
  visit(encoded.scale);
  visit(transfer.mesh.mirror);
  visit(transfer.mesh.specular);
  visit(transfer.mesh.exponent);
  visit(transfer.mesh.brdf);
  visit(transfer.mesh.brdfs.rows);
  visit(transfer.mesh.texture);
  visit(transfer.mesh.normal_map);
  visit(transfer.mesh.normal_maps.texels);
  visit(transfer.mesh.albedo_map);
  visit(transfer.mesh.tint);
  visit(transfer.mesh.albedo_maps.bytes);
  visit(transfer.mesh.chart);
  visit(transfer.mesh.atlas);
  visit(transfer.mesh.atlases.pixels);
  visit(indirect.data);
  visit(transfer.clusters.cluster);
  visit(transfer.clusters.weights);
  visit(transfer.indirect_clusters.cluster);
  visit(transfer.indirect_clusters.weights);
  visit(transfer.density);
}

/// A name in the form of the table.
constexpr std::array<char, 8> padded(std::string_view name) {
  std::array<char, 8> out{};
  std::copy(name.begin(), name.end(), out.begin());
  return out;
}

/// The printable characters of a name, for messages.
inline std::string readable(const std::array<char, 8>& name) {
  std::string text;
  std::copy_if(name.begin(), name.end(), std::back_inserter(text), [](char c) { return c > ' ' && c <= '~'; });
  return text;
}

/// The checksum of the prologue up to its checksum, followed by the table.
inline std::uint64_t front_checksum(const Prologue& prologue, const std::vector<Section>& table) {
  constexpr std::size_t kBefore = offsetof(Prologue, checksum);
  std::vector<unsigned char> front(kBefore + table.size() * sizeof(Section));
  std::memcpy(front.data(), &prologue, kBefore);
  if (!table.empty()) std::memcpy(front.data() + kBefore, table.data(), front.size() - kBefore);
  return sh::prt::checksum(front.data(), front.size());
}

}  // namespace sh::prt::layout
