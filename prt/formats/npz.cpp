// NumPy: every array of a transfer file in one .npz, numpy.load reads it [NumPy, NEP 1: a simple file format for arrays].
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zip.h>

#include <list>
#include <stdexcept>

#include "prt/binary/bytes.hpp"
#include "prt/formats/writers.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt::formats {
namespace {

using Shape = std::vector<std::size_t>;

// An array file: magic, version 1.0, a header that makes the data begin at a multiple of 64, the data.
std::string npy(const std::string& type, const Shape& shape, std::string_view data) {
  const std::string tuple = shape.empty() ? "()" : fmt::format("({},)", fmt::join(shape, ", "));
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, tuple);
  constexpr std::size_t kPrologue = 10;
  header.append(63 - (kPrologue + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  const auto length = static_cast<std::uint16_t>(header.size());
  append(bytes, &length, 1);
  return bytes.append(header).append(data);
}

template <class T>
std::string numbers(const std::string& type, const Shape& shape, const std::vector<T>& values) {
  return npy(type, shape, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::string vectors(const std::vector<Eigen::Vector3f>& values) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  return numbers("<f4", {values.size(), 3}, values);
}

// A string of ASCII, as one value of UTF-32.
std::string text(const std::string& ascii) {
  const std::u32string wide(ascii.begin(), ascii.end());
  return npy(fmt::format("<U{}", wide.size()), {}, {reinterpret_cast<const char*>(wide.data()), wide.size() * 4});
}

std::string rows(const TransferShape& shape, std::size_t vertices, const Rows& rows, const Clusters& clusters) {
  return numbers("<f4", {vertices, shape.channels, shape.rows(), shape.columns()},
                 clusters.empty() ? rows.all() : clusters.rows());
}

// A zip archive in memory. Files are stored, not compressed, and have the oldest date of the format.
class Archive {
 public:
  Archive() : source_(zip_source_buffer_create(nullptr, 0, 0, nullptr)) {
    if (source_ == nullptr) throw std::bad_alloc();
    zip_source_keep(source_);
    archive_ = zip_open_from_source(source_, ZIP_TRUNCATE, nullptr);
    if (archive_ == nullptr) fail();
  }
  ~Archive() {
    if (archive_ != nullptr) zip_discard(archive_);
    zip_source_free(source_);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  void add(const std::string& name, std::string bytes) {
    const std::string& data = files_.emplace_back(std::move(bytes));
    zip_source_t* source = zip_source_buffer(archive_, data.data(), data.size(), 0);
    const zip_int64_t index = source == nullptr ? -1 : zip_file_add(archive_, (name + ".npy").c_str(), source, 0);
    constexpr zip_uint16_t kFirstDay = 1U << 5U | 1U;  // 1980-01-01
    if (index < 0 || zip_set_file_compression(archive_, static_cast<zip_uint64_t>(index), ZIP_CM_STORE, 0) < 0 ||
        zip_file_set_dostime(archive_, static_cast<zip_uint64_t>(index), 0, kFirstDay, 0) < 0) {
      fail();
    }
  }

  std::string finish() {
    if (zip_close(archive_) < 0) fail();
    archive_ = nullptr;
    zip_stat_t stat;
    std::string bytes;
    if (zip_source_stat(source_, &stat) < 0 || zip_source_open(source_) < 0) fail();
    bytes.resize(stat.size);
    const zip_int64_t read = zip_source_read(source_, bytes.data(), bytes.size());
    zip_source_close(source_);
    if (read < 0 || static_cast<std::size_t>(read) != bytes.size()) fail();
    return bytes;
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("cannot make a zip archive"); }

  std::list<std::string> files_;  // until the archive is closed
  zip_source_t* source_;
  zip_t* archive_ = nullptr;
};

void add_mesh(Archive& archive, const Transfer& transfer) {
  const Mesh& mesh = transfer.mesh;
  std::vector<double> positions;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3d point = mesh.point(v);
    positions.insert(positions.end(), point.data(), point.data() + 3);
  }
  archive.add("positions", numbers("<f8", {mesh.positions.size(), 3}, positions));
  archive.add("normals", vectors(mesh.normals));
  archive.add("albedo", vectors(mesh.albedo));
  archive.add("faces", numbers("<u4", {mesh.faces.size(), 3}, mesh.faces));
  if (!mesh.specular.empty()) {
    archive.add("specular", vectors(mesh.specular));
    archive.add("exponent", numbers("<f4", {mesh.exponent.size()}, mesh.exponent));
  }
}

}  // namespace

std::string write_npz(const Transfer& transfer) {
  const std::size_t vertices = transfer.mesh.positions.size();
  Archive archive;
  archive.add("header", text(nlohmann::ordered_json::parse(transfer_header(transfer)).dump(-1, ' ', true)));
  add_mesh(archive, transfer);
  if (transfer.shape.length() > 0) {
    archive.add("transfer", rows(transfer.shape, vertices, transfer.rows(), transfer.clusters));
  }
  if (transfer.kind->stores_matrices()) {
    archive.add("indirect", rows(transfer.indirect_shape, vertices, transfer.matrices(), transfer.indirect_clusters));
  }
  if (!transfer.emitted.empty()) archive.add("emitted", vectors(transfer.emitted));
  return archive.finish();
}

}  // namespace sh::prt::formats
