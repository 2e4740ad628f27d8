// See ply.hpp and relight.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "numeric/output/atomic_file.hpp"
#include "prt/runtime/ply.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {
namespace {

static_assert(std::endian::native == std::endian::little, "the bodies of PLY files are written as they are in memory");

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

std::string header(const Mesh& mesh, const std::vector<std::string>& comments, const std::vector<PlyColumns>& columns) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) text += fmt::format("comment {}\n", comment);
  text += fmt::format(
      "element vertex {0}\n"
      "property {1} x\nproperty {1} y\nproperty {1} z\n"
      "property float nx\nproperty float ny\nproperty float nz\n",
      mesh.positions.size(), mesh.frame.is_world() ? "float" : "double");
  for (const PlyColumns& column : columns) {
    for (const std::string& name : column.names) text += fmt::format("property float {}\n", name);
  }
  return text +
         fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", mesh.faces.size());
}

}  // namespace

PlyColumns ply_columns(std::vector<std::string> names, const std::vector<Eigen::Vector3f>& vectors) {
  return {std::move(names),
          [&vectors](std::size_t vertex, float* values) { std::copy_n(vectors[vertex].data(), 3, values); }};
}

std::string ply_bytes(const Mesh& mesh, const std::vector<std::string>& comments,
                      const std::vector<PlyColumns>& columns) {
  std::string bytes = header(mesh, comments, columns);
  std::vector<float> values;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.frame.is_world()) {
      append(bytes, mesh.positions[i].data(), 3);
    } else {  // in the world, with the digits that single precision has in the frame
      append(bytes, mesh.point(i).data(), 3);
    }
    append(bytes, mesh.normals[i].data(), 3);
    for (const PlyColumns& column : columns) {
      values.resize(column.names.size());
      column.write(i, values.data());
      append(bytes, values.data(), values.size());
    }
  }
  for (const Face& face : mesh.faces) {
    bytes.push_back(3);
    append(bytes, face.data(), 3);
  }
  return bytes;
}

void write_ply(const std::string& file, const Mesh& mesh, const std::vector<Eigen::Vector3f>& radiance) {
  output::write_file(
      file, ply_bytes(mesh, {"red, green, blue: linear Rec. 709 exit radiance, W m^-2 sr^-1; axes: z up, right-handed"},
                      {ply_columns({"red", "green", "blue"}, radiance)}));
}

}  // namespace sh::prt
