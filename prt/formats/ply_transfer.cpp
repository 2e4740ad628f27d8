// PLY: a mesh with its transfer as properties of the vertices.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "prt/formats/writers.hpp"
#include "prt/runtime/ply.hpp"

namespace sh::prt::formats {
namespace {

// sh_transfer_0, ...: in the project's convention, (channels, rows, columns).
PlyColumns transfer_columns(const Transfer& transfer) {
  PlyColumns columns;
  for (std::size_t i = 0; i < transfer.shape.length(); ++i) columns.names.push_back(fmt::format("sh_transfer_{}", i));
  columns.write = [&transfer, room = std::make_shared<std::vector<float>>()](std::size_t vertex, float* values) {
    std::copy_n(transfer.row(vertex, *room), transfer.shape.length(), values);
  };
  return columns;
}

std::vector<std::string> comments(const Transfer& transfer) {
  const TransferShape& shape = transfer.shape;
  return {"axes: z up, right-handed; red, green, blue: linear Rec. 709 albedo",
          fmt::format("sh_transfer: kind {}, {} channels of {} x {} numbers, light of degree {}, meets the light by {}",
                      transfer.kind->letters, shape.channels, shape.rows(), shape.columns(), shape.degree,
                      word_of(shape.meets, kMeetsNames)),
          "real orthonormal spherical harmonics without Condon-Shortley phase, index l(l+1)+m, polar axis z",
          shape.holds_albedo ? "the numbers hold the albedo" : "the numbers do not hold the albedo"};
}

}  // namespace

std::string write_transfer_ply(const Transfer& transfer) {
  if (transfer.kind->stores_matrices()) {
    throw std::runtime_error(
        fmt::format("properties of vertices hold no matrices of light between surfaces (kind {}); "
                    "expected another kind, or the format npz",
                    transfer.kind->letters));
  }
  std::vector<PlyColumns> columns = {ply_columns({"red", "green", "blue"}, transfer.mesh.albedo)};
  if (!transfer.emitted.empty()) {
    columns.push_back(ply_columns({"emitted_red", "emitted_green", "emitted_blue"}, transfer.emitted));
  }
  if (!transfer.mesh.specular.empty() && transfer.kind->is_glossy()) {
    columns.push_back(ply_columns({"specular_red", "specular_green", "specular_blue"}, transfer.mesh.specular));
    columns.push_back({{"exponent"}, [&](std::size_t v, float* value) { *value = transfer.mesh.exponent[v]; }});
  }
  columns.push_back(transfer_columns(transfer));
  return ply_bytes(transfer.mesh, comments(transfer), columns);
}

}  // namespace sh::prt::formats
