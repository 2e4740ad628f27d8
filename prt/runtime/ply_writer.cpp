// Writes a mesh with its exit radiance as a PLY file.
// Reference: Greg Turk, "The PLY Polygon File Format" (1994).
#include <fmt/format.h>

#include <bit>

#include "numeric/output/atomic_file.hpp"
#include "prt/runtime/relight.hpp"

namespace sh::prt {
namespace {

static_assert(std::endian::native == std::endian::little, "the bodies of PLY files are written as they are in memory");

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

std::string header(const Mesh& mesh) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment red, green, blue: linear Rec. 709 exit radiance, W m^-2 sr^-1; axes: z up, right-handed\n"
      "element vertex {0}\n"
      "property {2} x\nproperty {2} y\nproperty {2} z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property float red\nproperty float green\nproperty float blue\n"
      "element face {1}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.faces.size(), mesh.frame.is_world() ? "float" : "double");
}

}  // namespace

void write_ply(const std::string& file, const Mesh& mesh, const std::vector<Eigen::Vector3f>& radiance) {
  std::string bytes = header(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.frame.is_world()) {
      append(bytes, mesh.positions[i].data(), 3);
    } else {  // in the world, with the digits that single precision has in the frame
      append(bytes, mesh.point(i).data(), 3);
    }
    for (const auto* vectors : {&mesh.normals, &radiance}) append(bytes, (*vectors)[i].data(), 3);
  }
  for (const Face& face : mesh.faces) {
    bytes.push_back(3);
    append(bytes, face.data(), 3);
  }
  output::AtomicFile out(file);
  out.write(bytes.data(), bytes.size());
  out.commit();
}

}  // namespace sh::prt
