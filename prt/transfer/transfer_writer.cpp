#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "numeric/output/atomic_file.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"
#include "prt/transfer/transfer_values.hpp"

namespace sh::prt {

namespace {

constexpr std::size_t kHeaderUnit = 16;

// True if the numbers of so many receivers, or their clusters, are as many as the shape says.
bool fit(const std::vector<float>& numbers, const Encoded& stored, const Clusters& clusters, const TransferShape& shape,
         std::size_t receivers) {
  if (!stored.empty()) {
    return numbers.empty() && clusters.empty() && stored.data.size() == receivers * shape.row_bytes() &&
           stored.scale.size() == (shape.storage.element == Element::kByte ? shape.stored_length() : 0);
  }
  if (!shape.storage.is_clustered()) return clusters.empty() && numbers.size() == receivers * shape.length();
  return numbers.empty() && clusters.receivers() == receivers && clusters.length == shape.length() &&
         clusters.vectors == shape.storage.vectors && clusters.weights.size() == receivers * clusters.vectors &&
         clusters.basis.size() == shape.stored_rows(receivers) * shape.length();
}

void check_lengths(const Transfer& transfer) {
  const Mesh& mesh = transfer.mesh;
  const std::size_t vertices = mesh.positions.size();
  const std::size_t receivers = transfer.receivers();
  if (transfer.grid.has_value() != transfer.kind->on_grid || (transfer.grid && vertices > 0)) {
    throw std::invalid_argument(fmt::format("transfer of kind {}: expected {}", transfer.kind->letters,
                                            transfer.kind->on_grid ? "a grid and no mesh" : "no grid"));
  }
  if (mesh.normals.size() != vertices || mesh.geometric_normals.size() != vertices || mesh.albedo.size() != vertices ||
      !fit(transfer.coefficients, transfer.stored, transfer.clusters, transfer.shape, receivers) ||
      (transfer.kind->indirect != nullptr ? !fit(transfer.indirect, transfer.stored_indirect,
                                                 transfer.indirect_clusters, transfer.indirect_shape, receivers)
                                          : !transfer.indirect.empty() || !transfer.stored_indirect.empty()) ||
      (!transfer.emitted.empty() && transfer.emitted.size() != receivers) ||
      transfer.density.size() != (transfer.kind->in_medium ? receivers : 0) ||
      (!mesh.mirror.empty() && mesh.mirror.size() != vertices) ||
      (!mesh.specular.empty() && mesh.specular.size() != vertices) || mesh.exponent.size() != mesh.specular.size() ||
      (!mesh.brdf.empty() && mesh.brdf.size() != vertices) ||
      (!mesh.normal_map.empty() && mesh.normal_map.size() != vertices) ||
      (!mesh.albedo_map.empty() && mesh.albedo_map.size() != vertices) || mesh.tint.size() != mesh.albedo_map.size() ||
      mesh.texture.size() != std::max(mesh.normal_map.size(), mesh.albedo_map.size()) ||
      (!mesh.atlas.empty() && mesh.atlas.size() != vertices) || mesh.chart.size() != mesh.atlas.size()) {
    throw std::invalid_argument("transfer: its arrays differ in length, expected one entry a receiver in each");
  }
}

struct Contents {
  std::vector<layout::Section> table;  // offsets from the end of the header
  std::vector<const void*> data;
};

Contents contents_of(const Transfer& transfer, const Encoded& encoded, const Encoded& indirect) {
  Contents contents;
  std::uint64_t offset = 0;
  const auto* kind = layout::kSections.begin();
  layout::each_section(transfer, encoded, indirect, [&](const auto& items) {
    const layout::Kind& known = *kind++;
    if (layout::presence_of(known, transfer) != layout::Presence::kAlways && items.empty()) return;
    layout::Section section;
    section.name = layout::padded(known.name);
    section.type = known.name == "transfer" ? layout::type_of(transfer.shape.storage.element) : known.type;
    section.columns = static_cast<std::uint32_t>(layout::columns_of(known, transfer));
    section.rows = items.size() * sizeof(items[0]) / (section.columns * layout::size_of(section.type));
    section.offset = offset;
    section.checksum = checksum(items.data(), bytes_of(section));
    offset += bytes_of(section);
    contents.table.push_back(section);
    contents.data.push_back(items.data());
  });
  return contents;
}

}  // namespace

void write_transfer(const std::string& path, const Transfer& transfer) {
  check_lengths(transfer);
  const std::string flaw = flaw_of_values(transfer);  // a reader would refuse the file
  if (!flaw.empty()) throw std::invalid_argument(path + ": cannot write: " + flaw);
  Encoded made;
  Encoded made_indirect;
  const Encoded& encoded = transfer.shape.storage.is_plain() ? made : transfer.encoded_rows(made);
  const Encoded& indirect =
      transfer.kind->indirect == nullptr ? made_indirect : transfer.encoded_matrices(made_indirect);
  auto [table, data] = contents_of(transfer, encoded, indirect);
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
