#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/output/atomic_file.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"

namespace sh::prt {

namespace {

// The contents of a section; an optional section with 0 rows is left out.
struct Data {
  const void* first;
  std::size_t rows;
};

// The coefficients in the encoding of the file.
struct Coefficients {
  explicit Coefficients(const Transfer& transfer)
      : columns(static_cast<std::uint32_t>(transfer.shape.stored_length())), first(transfer.coefficients.data()) {
    if (!transfer.shape.storage.is_plain()) {
      encoded = encode(transfer.coefficients, transfer.shape);
      first = encoded.data.data();
    }
  }
  std::uint32_t columns;
  const void* first;
  Encoded encoded;
};

constexpr std::size_t kHeaderUnit = 16;

void check_lengths(const Transfer& transfer) {
  const Mesh& mesh = transfer.mesh;
  const std::size_t vertices = mesh.positions.size();
  if (mesh.normals.size() != vertices || mesh.geometric_normals.size() != vertices || mesh.albedo.size() != vertices ||
      transfer.coefficients.size() != vertices * transfer.shape.length() ||
      (!transfer.emitted.empty() && transfer.emitted.size() != vertices) ||
      (!mesh.mirror.empty() && mesh.mirror.size() != vertices)) {
    throw std::invalid_argument("transfer: its arrays differ in length, expected one entry a vertex in each");
  }
}

std::array<Data, layout::kSections.size()> sections_of(const Transfer& transfer, const Coefficients& coefficients) {
  const Mesh& mesh = transfer.mesh;
  const std::size_t vertices = mesh.positions.size();
  return {{{mesh.positions.data(), vertices},
           {mesh.normals.data(), vertices},
           {mesh.geometric_normals.data(), vertices},
           {mesh.albedo.data(), vertices},
           {mesh.faces.data(), mesh.faces.size()},
           {mesh.remap.data(), mesh.remap.size()},
           {coefficients.first, vertices},
           {transfer.emitted.data(), transfer.emitted.size()},
           {coefficients.encoded.scale.data(), coefficients.encoded.scale.empty() ? 0U : 1U},
           {mesh.mirror.data(), mesh.mirror.size()}}};
}

struct Contents {
  std::vector<layout::Section> table;  // offsets from the end of the header
  std::vector<const void*> data;
};

Contents contents_of(const Transfer& transfer, const Coefficients& coefficients) {
  const auto data = sections_of(transfer, coefficients);
  Contents contents;
  std::uint64_t offset = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const layout::Kind& kind = layout::kSections[i];
    if (kind.presence == layout::Presence::kOptional && data[i].rows == 0) continue;
    layout::Section section;
    section.name = layout::padded(kind.name);
    section.type = kind.name == "transfer" ? layout::type_of(transfer.shape.storage.element) : kind.type;
    section.columns = kind.columns != 0 ? kind.columns : coefficients.columns;
    section.rows = data[i].rows;
    section.offset = offset;
    section.checksum = checksum(data[i].first, bytes_of(section));
    offset += bytes_of(section);
    contents.table.push_back(section);
    contents.data.push_back(data[i].first);
  }
  return contents;
}

}  // namespace

void write_transfer(const std::string& path, const Transfer& transfer) {
  check_lengths(transfer);
  const Coefficients coefficients(transfer);
  auto [table, data] = contents_of(transfer, coefficients);
  std::string header = transfer_header(transfer);
  header.resize((header.size() + kHeaderUnit - 1) / kHeaderUnit * kHeaderUnit, ' ');
  const std::size_t table_size = table.size() * sizeof(layout::Section);
  layout::Prologue prologue;
  prologue.sections = static_cast<std::uint32_t>(table.size());
  prologue.header_size = header.size();
  prologue.header_checksum = checksum(header.data(), header.size());
  for (layout::Section& section : table) {
    section.offset += sizeof prologue + table_size + header.size();
    prologue.file_size = section.offset + bytes_of(section);
  }
  prologue.checksum = layout::front_checksum(prologue, table);

  output::AtomicFile file(path);
  file.write(&prologue, sizeof prologue);
  file.write(table.data(), table_size);
  file.write(header.data(), header.size());
  for (std::size_t i = 0; i < table.size(); ++i) file.write(data[i], bytes_of(table[i]));
  file.commit();
}

}  // namespace sh::prt
