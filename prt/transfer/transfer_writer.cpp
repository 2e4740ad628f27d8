#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/output/atomic_file.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"

namespace sh::prt {

namespace {

struct Data {
  const void* first;
  std::size_t rows;
};

constexpr std::size_t kHeaderUnit = 16;

std::array<Data, layout::kSections.size()> sections_of(const Transfer& transfer) {
  const Mesh& mesh = transfer.mesh;
  const std::size_t vertices = mesh.positions.size();
  if (mesh.normals.size() != vertices || mesh.geometric_normals.size() != vertices || mesh.albedo.size() != vertices ||
      transfer.coefficients.size() != vertices * transfer.row_length()) {
    throw std::invalid_argument("transfer: its arrays differ in length, expected one entry a vertex in each");
  }
  return {{{mesh.positions.data(), vertices},
           {mesh.normals.data(), vertices},
           {mesh.geometric_normals.data(), vertices},
           {mesh.albedo.data(), vertices},
           {mesh.faces.data(), mesh.faces.size()},
           {mesh.remap.data(), mesh.remap.size()},
           {transfer.coefficients.data(), vertices}}};
}

std::size_t bytes_of(const layout::Section& section) { return section.rows * section.columns * sizeof(float); }

}  // namespace

void write_transfer(const std::string& path, const Transfer& transfer) {
  const auto data = sections_of(transfer);
  std::string header = transfer_header(transfer);
  header.resize((header.size() + kHeaderUnit - 1) / kHeaderUnit * kHeaderUnit, ' ');
  layout::Prologue prologue;
  prologue.sections = layout::kSections.size();
  prologue.header_size = header.size();
  prologue.header_checksum = checksum(header.data(), header.size());
  std::array<layout::Section, layout::kSections.size()> table;
  std::uint64_t offset = sizeof prologue + sizeof table + header.size();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const layout::Kind& kind = layout::kSections[i];
    std::copy(kind.name.begin(), kind.name.end(), table[i].name.begin());
    table[i].type = kind.type;
    table[i].columns = kind.columns != 0 ? kind.columns : static_cast<std::uint32_t>(transfer.row_length());
    table[i].rows = data[i].rows;
    table[i].offset = offset;
    table[i].checksum = checksum(data[i].first, bytes_of(table[i]));
    offset += bytes_of(table[i]);
  }
  prologue.file_size = offset;
  std::vector<unsigned char> front(offsetof(layout::Prologue, checksum) + sizeof table);
  const auto* prologue_bytes = reinterpret_cast<const unsigned char*>(&prologue);
  const auto* table_bytes = reinterpret_cast<const unsigned char*>(table.data());
  std::copy_n(table_bytes, sizeof table,
              std::copy_n(prologue_bytes, offsetof(layout::Prologue, checksum), front.begin()));
  prologue.checksum = checksum(front.data(), front.size());

  output::AtomicFile file(path);
  file.write(&prologue, sizeof prologue);
  file.write(table.data(), sizeof table);
  file.write(header.data(), header.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    file.write(data[i].first, bytes_of(table[i]));
  }
  file.commit();
}

}  // namespace sh::prt
