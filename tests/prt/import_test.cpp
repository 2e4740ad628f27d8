// Mesh files: axes, transforms, colors, and messages that name every kind of bad file.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "prt/mesh/import_mesh.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const Eigen::Vector3f kGrey = Eigen::Vector3f::Constant(0.5F);

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

// One triangle with a material, whose node moves and scales it.
std::string triangle(const std::vector<float>& positions, const std::vector<std::uint16_t>& indices) {
  return gltf(positions, indices,
              {{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0.25, 0.5, 0.75, 1.0}}}}},
              {{"mesh", 0}, {"translation", {10, 20, 30}}, {"scale", {2, 2, 2}}});
}

class Import : public testing::Test {
 protected:
  ImportedMesh import(const std::string& name, const std::string& text) {
    write_all(folder_.file(name), text);
    return import_mesh(folder_.file(name));
  }
  // The message of a scene with this one mesh, without the folder's name.
  std::string refusal(const std::string& name, const std::string& text, OnFlaw on_flaw = OnFlaw::kMend) {
    write_all(folder_.file(name), text);
    write_all(folder_.file("scene.json"), R"({"meshes": [{"file": ")" + name + R"("}]})");
    std::string said = message_of([&] { load_scene(folder_.file("scene.json"), on_flaw); });
    const std::string folder = folder_.file("");
    if (said.find(folder) == 0) said.erase(0, folder.size());
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  }

  TemporaryFolder folder_;
};

TEST_F(Import, ReadsPositionsFacesAndPolygons) {
  const ImportedMesh mesh = import("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(mesh.soup.faces.size(), 2U);
  EXPECT_EQ(mesh.file_vertices, mesh.soup.positions.size());
  EXPECT_TRUE(mesh.soup.normals.empty());
}

TEST_F(Import, AppliesNodeTransformsAndLinearBaseColor) {
  const ImportedMesh mesh = import("a.gltf", triangle({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}));
  ASSERT_EQ(mesh.soup.positions.size(), 3U);
  EXPECT_EQ(mesh.soup.positions[1], Eigen::Vector3d(12, 20, 30));
  EXPECT_EQ(mesh.soup.albedo[0], Eigen::Vector3f(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(mesh.up, UpAxis::kY);
}

TEST_F(Import, DecodesTheDiffuseColorOfOlderFormatsFromSrgb) {
  write_all(folder_.file("a.mtl"), "newmtl paint\nKd 1.0 0.5 0.0\n");
  const ImportedMesh mesh = import("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
  EXPECT_LT((mesh.soup.albedo[0] - Eigen::Vector3f(1.0F, 0.21404F, 0.0F)).norm(), 1e-4F);
}

TEST_F(Import, GivesMeshesWithoutMaterialTheDefaultAlbedo) {
  EXPECT_EQ(import("a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").soup.albedo[0], kGrey);
  EXPECT_EQ(import("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").soup.albedo[0], kGrey);
}

TEST_F(Import, KnowsTheCustomOfEachFormatsAxes) {
  EXPECT_EQ(import("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").up, UpAxis::kY);
  EXPECT_EQ(import("a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").up, UpAxis::kZ);
}

TEST_F(Import, StandsYUpGltfUpright) {
  write_all(folder_.file("a.gltf"), triangle({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}));
  write_all(folder_.file("scene.json"), R"({"meshes": [{"file": "a.gltf"}]})");
  const Scene scene = load_scene(folder_.file("scene.json"), OnFlaw::kRefuse);
  // The file's (10, 20 + 2, 30) is 22 high and 30 towards the viewer, -y.
  ASSERT_EQ(scene.mesh.positions.size(), 3U);
  EXPECT_EQ(scene.mesh.point(scene.mesh.remap[2]), Eigen::Vector3d(10, -30, 22));
  EXPECT_LT((scene.mesh.normals[0] - Eigen::Vector3f(0, -1, 0)).norm(), 1e-6F);
}

TEST_F(Import, RefusesAMissingFile) {
  write_all(folder_.file("scene.json"), R"({"meshes": [{"file": "none.obj"}]})");
  EXPECT_EQ(message_of([&] { load_scene(folder_.file("scene.json"), OnFlaw::kMend); }),
            folder_.file("none.obj") + ": no such mesh file");
}

TEST_F(Import, RefusesEmptyUnknownAndDamagedFiles) {
  EXPECT_EQ(refusal("a.obj", ""), "a.obj: the file is empty, expected a mesh");
  EXPECT_EQ(refusal("a.txt", "hello").find("a.txt: cannot read the mesh: "), 0U);
  EXPECT_EQ(refusal("a.gltf", "{}").find("a.gltf: cannot read the mesh: "), 0U);
  EXPECT_EQ(refusal("a.ply", "not a ply").find("a.ply: cannot read the mesh: "), 0U);
}

TEST_F(Import, RefusesAMeshWithoutFaces) {
  const std::string said = "the mesh has no faces, expected at least one triangle";
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "a.obj: " + said);
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "a.obj: " + said);
  EXPECT_EQ(refusal("a.stl", "solid a\nendsolid a\n").find("a.stl: "), 0U);
}

TEST_F(Import, RefusesVerticesThatAreNotFinite) {
  const std::string said = ": vertex 1 has a coordinate that is not finite";
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "a.obj" + said);
  EXPECT_EQ(refusal("a.ply", kPly + "0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n"), "a.ply" + said);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal("a.gltf", triangle({0, 0, 0, nan, 0, 0, 0, 1, 0}, {0, 1, 2})), "a.gltf" + said);
}

TEST_F(Import, RefusesFacesOutOfRange) {
  EXPECT_EQ(refusal("a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
            "a.ply: face 0 names vertex 7, but there are 3 vertices");
  EXPECT_EQ(refusal("a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n"),
            "a.ply: face 0 names vertex 4294967294, but there are 3 vertices");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").find("a.obj: "), 0U);
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n").find("a.off: a face names a missing vertex"),
            0U);
  for (const std::vector<std::uint16_t>& indices : {{0, 1, 9}, std::vector<std::uint16_t>{0, 1, 2, 0, 1, 9}}) {
    EXPECT_EQ(
        refusal("a.gltf", triangle({0, 0, 0, 1, 0, 0, 0, 1, 0}, indices)).find("a.gltf: a face names a missing vertex"),
        0U);
  }
}

TEST_F(Import, RefusesRawFilesWhoseObjectsTheImporterLoses) {
  const std::string one = "1 1 1 0 0 0 0 1 0 1 0 0\n";
  const std::string objects = "one\n" + one + "\n\ntwo\n" + one;
  EXPECT_EQ(refusal("a.raw", objects).find("a.raw: cannot read the mesh: the importer lost some of its objects"), 0U);
  EXPECT_EQ(refusal("b.raw", one), "");
}

TEST_F(Import, WarnsOfColorsThatItDoesNotRead) {
  const auto warning = [&](const std::string& name, const std::string& text) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(refusal(name, text), "");
    return testing::internal::GetCapturedStderr();
  };
  write_all(folder_.file("a.mtl"), "newmtl paint\nKd 1 1 1\nmap_Ks wood.png\nnewmtl plain\nKd 1 0 0\n");
  const std::string obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl ";
  EXPECT_EQ(warning("a.obj", obj + "paint\nf 1 2 3\n"),
            "warning: " + folder_.file("a.obj") + ": 1 of its materials have textures (not read)\n");
  EXPECT_EQ(warning("b.obj", obj + "plain\nf 1 2 3\n"), "");
  EXPECT_NE(refusal("a.obj", obj + "paint\nf 1 2 3\n", OnFlaw::kRefuse).find("have textures (not read); refused"),
            std::string::npos);
  std::string colored = kPly;
  colored.insert(colored.find("end_header"), "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  EXPECT_EQ(warning("c.ply", colored + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"),
            "warning: " + folder_.file("c.ply") + ": its faces have colors (not read)\n");
  EXPECT_EQ(warning("d.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "");
}

TEST_F(Import, DropsFacesWithoutAreaAndCountsThem) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n";
  testing::internal::CaptureStderr();
  EXPECT_EQ(refusal("a.obj", text), "");
  const std::string warned = testing::internal::GetCapturedStderr();
  EXPECT_EQ(warned, "warning: " + folder_.file("a.obj") + ": 1 of 2 faces have no area (dropped)\n");
  EXPECT_EQ(refusal("a.obj", text, OnFlaw::kRefuse).find("a.obj: 1 of 2 faces have no area"), 0U);
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "a.obj: none of the 1 faces has an area");
}

}  // namespace
}  // namespace sh::prt::test
