#include "prt/mesh/sides.hpp"

#include "prt/mesh/weld.hpp"

namespace sh::prt {

namespace {

// Each vertex of the front gets a vertex of the back at its first use.
class Backs {
 public:
  explicit Backs(Mesh& mesh) : mesh_(mesh), back_(mesh.positions.size(), kNoVertex) {}

  std::uint32_t of(std::uint32_t front) {
    if (back_[front] == kNoVertex) {
      back_[front] = static_cast<std::uint32_t>(mesh_.positions.size());
      repeat(mesh_.positions, front);
      mesh_.normals.emplace_back(-mesh_.normals[front]);
      repeat(mesh_.albedo, front);
      repeat(mesh_.emission, front);
      repeat(mesh_.mirror, front);
    }
    return back_[front];
  }

 private:
  static void repeat(std::vector<Eigen::Vector3f>& values, std::uint32_t front) {
    if (!values.empty()) {
      const Eigen::Vector3f value = values[front];
      values.push_back(value);
    }
  }

  Mesh& mesh_;
  std::vector<std::uint32_t> back_;  // (vertices of the front)
};

}  // namespace

void add_backs(Mesh& mesh, const std::vector<std::uint8_t>& is_two_sided) {
  Backs backs(mesh);
  const std::size_t faces = mesh.faces.size();
  for (std::size_t f = 0; f < faces; ++f) {
    if (is_two_sided[f] != 0) {
      const Face front = mesh.faces[f];
      mesh.faces.push_back({backs.of(front[0]), backs.of(front[2]), backs.of(front[1])});
    }
  }
  set_geometric_normals(mesh);
}

}  // namespace sh::prt
