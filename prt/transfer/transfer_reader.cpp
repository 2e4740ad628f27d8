#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "numeric/output/parse_json.hpp"
#include "prt/large_pages.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_json.hpp"
#include "prt/transfer/transfer_layout.hpp"
#include "prt/transfer/transfer_values.hpp"

namespace sh::prt {

namespace {

class Reader {
 public:
  Reader(const std::string& path, TransferKinds kinds) : path_(path), kinds_(kinds), file_(path, std::ios::binary) {
    std::error_code error;
    size_ = file_ ? std::filesystem::file_size(path, error) : 0;
    if (!file_ || error) fail(fmt::format("cannot read: {}", error ? error.message() : std::strerror(errno)));
  }

  const TransferKind* kind() {
    read_prologue();
    read_table();
    const nlohmann::json header = parsed_header();
    const auto letters = header.find("kind");
    return letters != header.end() && letters->is_string()
               ? find_kind(&TransferKind::letters, letters->get<std::string>(), kinds_)
               : nullptr;
  }

  TransferHead head() {
    read_prologue();
    read_table();
    TransferHead head;
    head.header = read_header();
    guarded([&] {
      const nlohmann::json header = parsed(head.header);
      take_header(header, prologue_.version, kinds_, head.transfer);
      check_shape(head.transfer);
      head.receivers = receivers(head.transfer);
      if (!head.transfer.grid)
        check_counts(header, {head.receivers, rows_of_section("face"), rows_of_section("remap")});
    });
    return head;
  }

  Transfer read() {
    read_prologue();
    read_table();
    Transfer transfer;
    guarded([&] {
      const nlohmann::json header = parsed_header();
      take_header(header, prologue_.version, kinds_, transfer);
      check_shape(transfer);
      read_sections(transfer);
      if (!transfer.grid) {
        check_counts(header, {transfer.mesh.positions.size(), transfer.mesh.faces.size(), transfer.mesh.remap.size()});
      }
    });
    check_values(transfer);
    return transfer;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", path_, what));
  }

  // Names what is wrong with a header, and what does not fit together.
  template <class Work>
  void guarded(const Work& work) const {
    try {
      work();
    } catch (const nlohmann::json::exception&) {
      fail("its JSON header lacks an entry or has one of the wrong type");
    } catch (const std::invalid_argument& flaw) {
      fail(flaw.what());
    }
  }

  void fetch(void* to, std::size_t bytes) {
    file_.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
    if (static_cast<std::size_t>(file_.gcount()) != bytes) fail("truncated transfer file");
  }

  void read_prologue() {
    if (size_ < sizeof prologue_) {
      fail(fmt::format("not a transfer file: {} bytes, expected at least {}", size_, sizeof prologue_));
    }
    fetch(&prologue_, sizeof prologue_);
    if (prologue_.magic != layout::kMagic) fail("not a transfer file: it does not begin with `shprt`");
    if (prologue_.version < layout::kOldestVersion || prologue_.version > layout::kVersion) {
      fail(fmt::format("transfer file of version {}, expected {} to {}", prologue_.version, layout::kOldestVersion,
                       layout::kVersion));
    }
    if (prologue_.file_size != size_) {
      fail(fmt::format("truncated or overlong transfer file: {} bytes, expected {}", size_, prologue_.file_size));
    }
    if (prologue_.sections > layout::kSections.size()) {
      fail(fmt::format("transfer file of {} sections, expected at most {}", prologue_.sections,
                       layout::kSections.size()));
    }
  }

  void read_table() {
    table_.resize(prologue_.sections);
    fetch(table_.data(), table_.size() * sizeof(layout::Section));
    if (layout::front_checksum(prologue_, table_) != prologue_.checksum) {
      fail("damaged transfer file: the checksum of its section table differs");
    }
  }

  std::string read_header() {
    if (prologue_.header_size > size_) fail("damaged transfer file: its JSON header is longer than the file");
    std::string header(prologue_.header_size, ' ');
    fetch(header.data(), header.size());
    if (checksum(header.data(), header.size()) != prologue_.header_checksum) {
      fail("damaged transfer file: the checksum of its JSON header differs");
    }
    return header;
  }

  nlohmann::json parsed_header() { return parsed(read_header()); }

  [[nodiscard]] nlohmann::json parsed(const std::string& header) const {
    try {
      return output::parse_json<nlohmann::json>(header);
    } catch (const std::runtime_error& error) {
      fail(fmt::format("its JSON header is {}", error.what()));
    }
  }

  // Those of the grid, or the vertices, which the first section has.
  [[nodiscard]] std::uint64_t receivers(const Transfer& transfer) const {
    return transfer.grid ? transfer.grid->points() : table_[0].rows;
  }

  // Checks that the sections are known, in order, without gaps, and as long as the file.
  void check_shape(const Transfer& transfer) const {
    std::uint64_t offset = sizeof prologue_ + table_.size() * sizeof(layout::Section) + prologue_.header_size;
    const auto* next = layout::kSections.begin();
    for (const layout::Section& section : table_) {
      const auto* kind = std::find_if(next, layout::kSections.end(), [&](const layout::Kind& known) {
        return layout::padded(known.name) == section.name;
      });
      if (kind == layout::kSections.end()) {
        fail(fmt::format("transfer file with a section `{}`, which is unknown or out of place",
                         layout::readable(section.name)));
      }
      check_left_out(next, kind, transfer);
      check_section(*kind, section, offset, transfer);
      offset += bytes_of(section);
      next = kind + 1;
    }
    check_left_out(next, layout::kSections.end(), transfer);
    if (offset != size_) fail("damaged transfer file: bytes after its last section");
  }

  void check_left_out(const layout::Kind* first, const layout::Kind* last, const Transfer& transfer) const {
    const auto* missing = std::find_if(first, last, [&](const layout::Kind& kind) {
      return layout::presence_of(kind, transfer) == layout::Presence::kAlways;
    });
    if (missing != last) fail(fmt::format("damaged transfer file: section {} is missing", missing->name));
  }

  void check_section(const layout::Kind& kind, const layout::Section& section, std::uint64_t offset,
                     const Transfer& transfer) const {
    if (layout::presence_of(kind, transfer) == layout::Presence::kNever) {
      fail(fmt::format("transfer file of kind {} with a section {}, which it does not have", transfer.kind->letters,
                       kind.name));
    }
    const std::uint64_t columns = layout::columns_of(kind, transfer);
    const std::uint32_t type = kind.name == "transfer" ? layout::type_of(transfer.shape.storage.element) : kind.type;
    if (section.type != type || section.columns != columns || section.offset != offset ||
        section.rows > (size_ - offset) / (columns * layout::size_of(section.type)) ||
        section.rows != layout::rows_of(kind, transfer, receivers(transfer), section.rows)) {
      fail(fmt::format("damaged transfer file: section {} does not fit", kind.name));
    }
  }

  // Null if the file has no such section.
  [[nodiscard]] const layout::Section* find_section(std::string_view name) const {
    const auto found = std::find_if(table_.begin(), table_.end(),
                                    [&](const layout::Section& s) { return s.name == layout::padded(name); });
    return found == table_.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::uint64_t rows_of_section(std::string_view name) const {
    const layout::Section* section = find_section(name);
    return section == nullptr ? 0 : section->rows;
  }

  // Reads a section into its items, which stay empty if the file has no such section.
  template <class T>
  void fetch_section(const layout::Kind& kind, std::vector<T>& items) {
    const layout::Section* section = find_section(kind.name);
    if (section == nullptr) return;
    renew_on_large_pages(items, bytes_of(*section) / sizeof(T));
    fetch(items.data(), items.size() * sizeof(T));
    if (checksum(items.data(), items.size() * sizeof(T)) != section->checksum) {
      fail(fmt::format("damaged transfer file: the checksum of section {} differs", kind.name));
    }
  }

  void read_sections(Transfer& transfer) {
    const auto* kind = layout::kSections.begin();
    layout::each_section(transfer, transfer.stored, transfer.stored_indirect,
                         [&](auto& items) { fetch_section(*kind++, items); });
    check_scale(transfer, transfer.stored);
    take_clusters(transfer.shape, transfer.stored, transfer.clusters);
    take_clusters(transfer.indirect_shape, transfer.stored_indirect, transfer.indirect_clusters);
    // Blocks meet one light much faster than rows do (prt/runtime/relight.cpp), which other kinds read one by one.
    if (!transfer.stored.empty() && !transfer.kind->is_glossy() && !transfer.grid) {
      to_blocks(transfer.stored, transfer.shape);
    }
  }

  // The rows of clusters are few; they serve all vertices.
  static void take_clusters(const TransferShape& shape, Encoded& rows, Clusters& clusters) {
    if (!shape.storage.is_clustered()) return;
    clusters.length = shape.length();
    clusters.vectors = shape.storage.vectors;
    clusters.basis = decode(rows, shape);
    rows = {};
  }

  void check_scale(const Transfer& transfer, const Encoded& encoded) const {
    if (encoded.scale.empty() == (transfer.shape.storage.element == Element::kByte)) {
      fail("damaged transfer file: a scale belongs to 8-bit coefficients and to no others");
    }
    if (!std::all_of(encoded.scale.begin(), encoded.scale.end(),
                     [](float scale) { return scale >= 0.0F && std::isfinite(scale); })) {
      fail("damaged transfer file: a scale is negative or not finite");
    }
  }

  // Counts of the header, which repeat those of the sections: of vertices, faces and file_vertices.
  void check_counts(const nlohmann::json& header, const std::array<std::uint64_t, 3>& counts) const {
    constexpr std::array kNames = {"vertices", "faces", "file_vertices"};
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (header.at(kNames[i]) != counts[i]) {
        fail(fmt::format("damaged transfer file: its JSON header says that `{}` is {}, its sections {}", kNames[i],
                         header.at(kNames[i]).dump(), counts[i]));
      }
    }
  }

  void check_values(const Transfer& transfer) const {
    const std::string flaw = flaw_of_values(transfer);
    if (!flaw.empty()) fail("damaged transfer file: " + flaw);
  }

  std::string path_;
  TransferKinds kinds_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  layout::Prologue prologue_;
  std::vector<layout::Section> table_;
};

}  // namespace

bool is_transfer_file(const std::string& path) {
  std::array<char, layout::kMagic.size()> first{};
  std::ifstream(path, std::ios::binary).read(first.data(), first.size());
  return first == layout::kMagic;
}

const TransferKind* kind_of_file(const std::string& path) {
  if (!is_transfer_file(path)) return nullptr;
  try {
    return Reader(path, file_kinds()).kind();
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

TransferHead read_transfer_head(const std::string& path, TransferKinds kinds) { return Reader(path, kinds).head(); }

Transfer read_transfer(const std::string& path, TransferKinds kinds) { return Reader(path, kinds).read(); }

}  // namespace sh::prt
