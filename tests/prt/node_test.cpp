// The nodes of model files: their faces and axes reach the mesh and the transfer file, so that a viewer finds them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "prt/kinds/kinds.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// The node of a face, or none.
const MeshNode* node_of(const Mesh& mesh, std::uint32_t face) {
  const auto found = std::find_if(mesh.nodes.begin(), mesh.nodes.end(), [face](const MeshNode& node) {
    return std::any_of(node.faces.begin(), node.faces.end(),
                       [face](const auto& run) { return run[0] <= face && face < run[0] + run[1]; });
  });
  return found == mesh.nodes.end() ? nullptr : &*found;
}

class Nodes : public testing::Test {
 protected:
  // A square in x and y of its own axes, and a face without area, moved by (10, 20, 30), y up; a box at x = -5; a ground.
  Scene scene(const nlohmann::json& material, const std::string& more = {}) {
    write_all(folder_.file("a.gltf"), gltf({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 0, 1, 0, 1, 2, 0, 2, 3}, material,
                                           {{"mesh", 0}, {"name", "left wing"}, {"translation", {10, 20, 30}}}));
    write_all(folder_.file("scene.json"),
              R"({"meshes": [{"file": "a.gltf")" + more +
                  R"(}, {"primitive": "box", "transform": {"translate": [-5, 0, 0], "scale": 2}}], "ground": {},
                   "bake": {"directions": 16, "degree": 1}})");
    return load_scene(folder_.file("scene.json"), OnFlaw::kMend);
  }
  TemporaryFolder folder_;
};

TEST_F(Nodes, HaveTheirFacesWhateverTheMeshGoesThrough) {
  for (const bool is_two_sided : {false, true}) {
    for (const char* more : {"", R"(, "max_edge": 0.3)", R"(, "crease": 0, "flip": true)"}) {
      const Mesh mesh = scene({{"name", "paint"}, {"doubleSided", is_two_sided}}, more).mesh;
      ASSERT_EQ(mesh.nodes.size(), 2U);
      EXPECT_EQ(mesh.nodes[0].name, "left wing");
      EXPECT_EQ(mesh.nodes[0].material, "paint");
      EXPECT_EQ(mesh.nodes[1].name, "box");
      EXPECT_EQ(mesh.nodes[1].material, "");
      std::array<std::size_t, 3> counts{};
      for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        const Eigen::Vector3d middle =
            (mesh.point(mesh.faces[f][0]) + mesh.point(mesh.faces[f][1]) + mesh.point(mesh.faces[f][2])) / 3.0;
        const MeshNode* node = node_of(mesh, f);
        const bool is_wing = middle.x() > 9.9 && middle.y() < -29.9 && middle.z() > 19.9;
        const bool is_box = (middle - Eigen::Vector3d(-5, 0, 0)).cwiseAbs().maxCoeff() < 2.1 && !is_wing;
        if (node == nullptr) {
          ++counts[2];
          EXPECT_FALSE(is_wing);
        } else {
          ++counts[node == mesh.nodes.data() ? 0 : 1];
          EXPECT_EQ(node == mesh.nodes.data(), is_wing) << middle.transpose();
          EXPECT_EQ(node != mesh.nodes.data(), is_box) << middle.transpose();
        }
      }
      const std::size_t wing =
          std::string(more).find("max_edge") == std::string::npos ? 2 : counts[0] / (is_two_sided ? 2 : 1);
      EXPECT_EQ(counts[0], is_two_sided ? 2 * wing : wing) << more;
      EXPECT_GT(counts[1], 11U);
      EXPECT_GT(counts[2], 100U);
    }
  }
}

TEST_F(Nodes, TellWhereTheirOwnAxesLie) {
  const Mesh mesh = scene({{"name", "paint"}}).mesh;
  // (1, 0, 0) of the file is (11, 20, 30) with y up.
  EXPECT_LT((mesh.nodes[0].to_world * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(11, -30, 20)).norm(), 1e-6);
  EXPECT_LT((mesh.nodes[0].to_world * Eigen::Vector3d(0, 1, 0) - Eigen::Vector3d(10, -30, 21)).norm(), 1e-6);
  EXPECT_LT((mesh.point(mesh.remap[1]) - Eigen::Vector3d(11, -30, 20)).norm(), 1e-5);
  EXPECT_LT((mesh.nodes[1].to_world * Eigen::Vector3d(0.5, 0, 0) - Eigen::Vector3d(-4, 0, 0)).norm(), 1e-6);
}

TEST_F(Nodes, AreInTheTransferFile) {
  const Transfer transfer = bake(scene({{"name", "paint \"\xC3\xA4\""}}));
  const std::string file = folder_.file("a.transfer");
  write_transfer(file, transfer);
  const Mesh read = read_transfer(file).mesh;
  ASSERT_EQ(read.nodes.size(), transfer.mesh.nodes.size());
  for (std::size_t i = 0; i < read.nodes.size(); ++i) {
    EXPECT_EQ(read.nodes[i].name, transfer.mesh.nodes[i].name);
    EXPECT_EQ(read.nodes[i].material, transfer.mesh.nodes[i].material);
    EXPECT_EQ(read.nodes[i].faces, transfer.mesh.nodes[i].faces);
    EXPECT_EQ(read.nodes[i].to_world.matrix(), transfer.mesh.nodes[i].to_world.matrix());
  }
  Transfer without = transfer;
  without.mesh.nodes.clear();  // as in files that are older
  write_transfer(file, without);
  EXPECT_TRUE(read_transfer(file).mesh.nodes.empty());
}

TEST_F(Nodes, AreRefusedWithFacesThatTheMeshLacks) {
  const Transfer transfer = bake(scene({{"name", "paint"}}));
  const auto faces = static_cast<std::uint32_t>(transfer.mesh.faces.size());
  const std::vector<std::vector<std::array<std::uint32_t, 2>>> bad = {
      {{0, faces + 1}}, {{faces, 1}}, {{0xFFFFFFFFU, 0xFFFFFFFFU}}, {{0, 0}}, {{4, 2}, {5, 2}}, {{4, 2}, {0, 2}}};
  for (const auto& runs : bad) {
    Transfer flawed = transfer;
    flawed.mesh.nodes[0].faces = runs;
    const std::string file = folder_.file("a.transfer");
    write_transfer(file, flawed);
    const std::string said = message_of([&] { read_transfer(file); });
    EXPECT_TRUE(said.find("runs of faces") != std::string::npos ||
                said.find("expected a whole number from 1") != std::string::npos)
        << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace sh::prt::test
