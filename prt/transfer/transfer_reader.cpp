#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "prt/transfer/checksum.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"
#include "prt/transfer/transfer_names.hpp"

namespace sh::prt {

namespace {

using Table = std::array<layout::Section, layout::kSections.size()>;

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    std::error_code error;
    size_ = file_ ? std::filesystem::file_size(path, error) : 0;
    if (!file_ || error) {
      fail(fmt::format("cannot read: {}", error ? error.message() : std::strerror(errno)));
    }
  }

  Transfer read() {
    read_prologue();
    read_table();
    const std::string header = read_header();
    Transfer transfer;
    try {
      take_header(nlohmann::json::parse(header), transfer);
    } catch (const nlohmann::json::exception&) {
      fail("its JSON header lacks an entry or has one of the wrong type");
    }
    check_shape(transfer);
    read_sections(transfer);
    check_values(transfer);
    return transfer;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", path_, what));
  }

  void fetch(void* to, std::size_t bytes) {
    file_.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
    if (static_cast<std::size_t>(file_.gcount()) != bytes) {
      fail("truncated transfer file");
    }
  }

  void read_prologue() {
    if (size_ < sizeof prologue_) {
      fail(fmt::format("not a transfer file: {} bytes, expected at least {}", size_, sizeof prologue_));
    }
    fetch(&prologue_, sizeof prologue_);
    if (prologue_.magic != layout::kMagic) {
      fail("not a transfer file: it does not begin with `shprt`");
    }
    if (prologue_.version != layout::kVersion) {
      fail(fmt::format("transfer file of version {}, expected {}", prologue_.version, layout::kVersion));
    }
    if (prologue_.file_size != size_) {
      fail(fmt::format("truncated or overlong transfer file: {} bytes, expected {}", size_, prologue_.file_size));
    }
    if (prologue_.sections != table_.size()) {
      fail(fmt::format("damaged transfer file: {} sections, expected {}", prologue_.sections, table_.size()));
    }
  }

  void read_table() {
    fetch(table_.data(), sizeof table_);
    std::vector<unsigned char> front(offsetof(layout::Prologue, checksum) + sizeof table_);
    std::memcpy(front.data(), &prologue_, offsetof(layout::Prologue, checksum));
    std::memcpy(front.data() + offsetof(layout::Prologue, checksum), table_.data(), sizeof table_);
    if (checksum(front.data(), front.size()) != prologue_.checksum) {
      fail("damaged transfer file: the checksum of its section table differs");
    }
  }

  std::string read_header() {
    if (prologue_.header_size > size_) {
      fail("damaged transfer file: its JSON header is longer than the file");
    }
    std::string header(prologue_.header_size, ' ');
    fetch(header.data(), header.size());
    if (checksum(header.data(), header.size()) != prologue_.header_checksum) {
      fail("damaged transfer file: the checksum of its JSON header differs");
    }
    return header;
  }

  void take_header(const nlohmann::json& header, Transfer& transfer) const {
    transfer.scene = header.at("scene").get<std::string>();
    const auto kind = header.at("kind").get<std::string>();
    const auto* name = std::find_if(kTransferNames.begin(), kTransferNames.end(),
                                    [&](const TransferName& known) { return known.file == kind; });
    if (name == kTransferNames.end() || header.at("rows").get<std::uint64_t>() != 1) {
      fail(fmt::format("transfer of kind {} with {} rows, expected DU, DS or DI with one", kind,
                       header.at("rows").dump()));
    }
    transfer.kind = name->kind;
    if (header.value("channels", std::uint64_t{1}) != transfer.channels()) {  // absent: one
      fail(fmt::format("transfer of kind {} with {} channels, expected {}", kind, header.at("channels").dump(),
                       transfer.channels()));
    }
    if (transfer.kind == TransferKind::kInterreflected) {
      take_bounces(header.at("bounces"), transfer.bounces);
    }
    transfer.degree = header.at("degree").get<int>();
    if (transfer.degree < 0 || transfer.degree > kMaxDegree) {
      fail(fmt::format("transfer of degree {}, expected 0 to {}", transfer.degree, kMaxDegree));
    }
    transfer.directions = header.at("directions").get<std::uint32_t>();
    transfer.instruction_set = header.at("instruction_set").get<std::string>();
  }

  static void take_bounces(const nlohmann::json& header, BounceReport& report) {
    report.solver = header.at("solver").get<std::string>();
    report.applications = header.at("applications").get<int>();
    report.certified = header.at("certified").get<bool>();
    report.bound = report.certified ? header.at("bound").get<double>() : std::numeric_limits<double>::infinity();
    report.residual = header.at("residual").get<double>();
    report.largest = header.at("largest").get<double>();
    report.spectral_bound = header.at("spectral_bound").get<double>();
  }

  // The sections follow one another, none is longer than the file, and their lengths agree.
  void check_shape(const Transfer& transfer) const {
    std::uint64_t offset = sizeof prologue_ + sizeof table_ + prologue_.header_size;
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const layout::Kind& kind = layout::kSections[i];
      const layout::Section& section = table_[i];
      std::array<char, 8> name{};
      std::copy(kind.name.begin(), kind.name.end(), name.begin());
      const std::uint64_t columns = kind.columns != 0 ? kind.columns : transfer.row_length();
      const bool is_per_vertex = kind.name != "face" && kind.name != "remap";
      if (section.name != name || section.type != kind.type || section.columns != columns || section.offset != offset ||
          section.rows > (size_ - offset) / (columns * sizeof(float)) ||
          (is_per_vertex && section.rows != table_[0].rows)) {
        fail(fmt::format("damaged transfer file: section {} does not fit", kind.name));
      }
      offset += section.rows * columns * sizeof(float);
    }
    if (offset != size_) {
      fail("damaged transfer file: bytes after its last section");
    }
  }

  template <class T>
  void fetch_section(std::size_t index, std::size_t items_a_row, std::vector<T>& items) {
    items.resize(table_[index].rows * items_a_row);
    fetch(items.data(), items.size() * sizeof(T));
    if (checksum(items.data(), items.size() * sizeof(T)) != table_[index].checksum) {
      fail(fmt::format("damaged transfer file: the checksum of section {} differs", layout::kSections[index].name));
    }
  }

  void read_sections(Transfer& transfer) {
    fetch_section(0, 1, transfer.mesh.positions);
    fetch_section(1, 1, transfer.mesh.normals);
    fetch_section(2, 1, transfer.mesh.geometric_normals);
    fetch_section(3, 1, transfer.mesh.albedo);
    fetch_section(4, 1, transfer.mesh.faces);
    fetch_section(5, 1, transfer.mesh.remap);
    fetch_section(6, transfer.row_length(), transfer.coefficients);
  }

  void check_values(const Transfer& transfer) const {
    const std::size_t vertices = transfer.mesh.positions.size();
    const auto is_vertex = [&](std::uint32_t v) { return v < vertices; };
    if (!std::all_of(transfer.mesh.faces.begin(), transfer.mesh.faces.end(),
                     [&](const Face& face) { return std::all_of(face.begin(), face.end(), is_vertex); }) ||
        !std::all_of(transfer.mesh.remap.begin(), transfer.mesh.remap.end(),
                     [&](std::uint32_t v) { return v == kNoVertex || is_vertex(v); })) {
      fail("damaged transfer file: it names a vertex that is not there");
    }
    if (!std::all_of(transfer.coefficients.begin(), transfer.coefficients.end(),
                     [](float value) { return std::isfinite(value); })) {
      fail("damaged transfer file: a transfer coefficient is not finite");
    }
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  layout::Prologue prologue_;
  Table table_;
};

}  // namespace

Transfer read_transfer(const std::string& path) { return Reader(path).read(); }

}  // namespace sh::prt
