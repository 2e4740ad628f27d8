// Materials from mesh files and from the scene: colors, emission, mirrors, sides.
#include <gtest/gtest.h>

#include "prt/mesh/corners.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// Two triangles that share an edge, each with a material of its own.
const std::string kTwoPaints =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl lamp\nf 1 3 4\n";
const std::string kPaints = "newmtl red\nKd 1 0 0\n\nnewmtl lamp\nKd 0 0 0\nKe 5 4 0.5\n";

std::string triangle_of(const nlohmann::json& material) {
  return gltf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}, material);
}

class Materials : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) { write_all(folder_.file(name), text); }
  Scene load(const std::string& mesh) {
    put("scene.json", R"({"meshes": [)" + mesh + "]}");
    return load_scene(folder_.file("scene.json"), OnFlaw::kRefuse);
  }
  // The message, from the JSON path on.
  std::string refusal(const std::string& mesh) {
    const std::string said = message_of([&] { load(mesh); });
    const std::string before = folder_.file("scene.json") + ": /meshes/0";
    EXPECT_EQ(said.find(before), 0U) << said;
    return said.substr(std::min(before.size(), said.size()));
  }

  TemporaryFolder folder_;
};

Eigen::Vector3f color_at(const std::vector<Eigen::Vector3f>& values, const Mesh& mesh, std::size_t face) {
  for (const std::uint32_t v : mesh.faces[face]) {
    EXPECT_EQ(values[v], values[mesh.faces[face][0]]);
  }
  return values[mesh.faces[face][0]];
}

TEST_F(Materials, OfEachFaceOfAnObjFileAreItsOwn) {
  put("a.mtl", kPaints);
  put("a.obj", kTwoPaints);
  const Mesh mesh = load(R"({"file": "a.obj", "max_edge": 0.3})").mesh;
  const auto faces = static_cast<std::ptrdiff_t>(mesh.faces.size());
  std::ptrdiff_t red = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const bool is_red = color_at(mesh.albedo, mesh, f) == Eigen::Vector3f(1, 0, 0);
    red += is_red ? 1 : 0;
    EXPECT_EQ(color_at(mesh.emission, mesh, f), is_red ? Eigen::Vector3f(0, 0, 0) : Eigen::Vector3f(5, 4, 0.5F));
  }
  EXPECT_EQ(2 * red, faces) << "the paints do not bleed into each other over the edge they share";
  EXPECT_TRUE(mesh.mirror.empty());
}

TEST_F(Materials, AreReadFromGltf) {
  put("a.gltf", triangle_of({{"name", "lamp"}, {"doubleSided", true}, {"emissiveFactor", {0.25, 0.5, 1.0}}}));
  const ImportedMesh mesh = import_mesh(folder_.file("a.gltf"));
  EXPECT_EQ(mesh.materials, std::vector<std::string>{"lamp"});
  const Finish finish = mesh.soup.finishes[mesh.soup.finish_of(0)];
  EXPECT_TRUE(finish.is_two_sided);
  EXPECT_EQ(finish.emission, Eigen::Vector3f(0.25F, 0.5F, 1.0F));
  EXPECT_EQ(finish.mirror, Eigen::Vector3f(0, 0, 0));
  put("b.gltf", triangle_of({{"name", "plain"}}));
  EXPECT_EQ(import_mesh(folder_.file("b.gltf")).soup.finishes[0], Finish());
}

TEST_F(Materials, OfEachVertexOfAPlyFileAreItsColors) {
  put("a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
  const Mesh mesh = load(R"({"file": "a.ply"})").mesh;
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_EQ(mesh.albedo[mesh.remap[v]], Eigen::Vector3f(Eigen::Vector3f::Unit(static_cast<Eigen::Index>(v))));
  }
  EXPECT_EQ(load(R"({"file": "a.ply", "albedo": [0.1, 0.2, 0.3]})").mesh.albedo[0], Eigen::Vector3f(0.1F, 0.2F, 0.3F));
}

TEST_F(Materials, OfTheSceneGoBeforeTheFilesByNameBeforeAll) {
  put("a.mtl", kPaints);
  put("a.obj", kTwoPaints);
  const Mesh mesh = load(R"({"file": "a.obj", "albedo": [0.5, 0.5, 0.5], "emission": [9, 9, 9],
    "materials": {"red": {"emission": [0, 0, 2]}, "lamp": {"mirror": [0.5, 0.6, 0.7], "sides": 2}}})")
                        .mesh;
  ASSERT_EQ(mesh.faces.size(), 3U) << "the lamp got a back";
  EXPECT_EQ(color_at(mesh.albedo, mesh, 0), Eigen::Vector3f(0.5F, 0.5F, 0.5F));
  EXPECT_EQ(color_at(mesh.emission, mesh, 0), Eigen::Vector3f(0, 0, 2));
  EXPECT_EQ(color_at(mesh.mirror, mesh, 0), Eigen::Vector3f(0, 0, 0));
  for (const std::size_t face : {1U, 2U}) {
    EXPECT_EQ(color_at(mesh.albedo, mesh, face), Eigen::Vector3f(0, 0, 0));
    EXPECT_EQ(color_at(mesh.emission, mesh, face), Eigen::Vector3f(9, 9, 9));
    EXPECT_EQ(color_at(mesh.mirror, mesh, face), Eigen::Vector3f(0.5F, 0.6F, 0.7F));
  }
}

TEST_F(Materials, OfOtherMeshesOfTheSceneStayAsTheyAre) {
  const Mesh mesh = load(R"({"primitive": "plane"}, {"primitive": "plane", "emission": [1, 0, 0]},
                            {"primitive": "plane", "mirror": [1, 1, 1], "albedo": [0, 0, 0]}, {"primitive": "plane"})")
                        .mesh;
  ASSERT_EQ(mesh.positions.size(), 16U);
  ASSERT_EQ(mesh.emission.size(), 16U);
  ASSERT_EQ(mesh.mirror.size(), 16U);
  for (std::size_t v = 0; v < 16; ++v) {
    EXPECT_EQ(mesh.emission[v].x(), v / 4 == 1 ? 1.0F : 0.0F);
    EXPECT_EQ(mesh.mirror[v].x(), v / 4 == 2 ? 1.0F : 0.0F);
    EXPECT_EQ(mesh.albedo[v].x(), v / 4 == 2 ? 0.0F : 0.5F);
  }
}

TEST_F(Materials, WithTwoSidesHaveABackOnVerticesOfItsOwn) {
  const Mesh one = load(R"({"primitive": "plane", "max_edge": 0.5, "emission": [1, 2, 3]})").mesh;
  const Mesh two = load(R"({"primitive": "plane", "max_edge": 0.5, "emission": [1, 2, 3], "sides": 2})").mesh;
  ASSERT_EQ(two.positions.size(), 2 * one.positions.size());
  ASSERT_EQ(two.faces.size(), 2 * one.faces.size());
  for (const auto& [edge, faces] : edges_by_position(two)) {
    EXPECT_EQ(faces.first, faces.second);
  }
  EXPECT_EQ(two.emission.size(), two.positions.size());
  for (std::size_t v = 0; v < one.positions.size(); ++v) {
    EXPECT_EQ(two.normals[v], Eigen::Vector3f(0, 0, 1));
    EXPECT_EQ(two.normals[v + one.positions.size()], Eigen::Vector3f(0, 0, -1));
    EXPECT_EQ(two.geometric_normals[v + one.positions.size()], Eigen::Vector3f(0, 0, -1));
  }
}

// A triangle whose winding says down and whose normals say up, and one that is as it should be.
TEST_F(Materials, OfFacesWoundAgainstTheirNormalsAreOnTheSideOfTheNormals) {
  put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 3//1 4//1 2//1\n");
  EXPECT_EQ(
      message_of([&] { load(R"({"file": "a.obj"})"); }),
      folder_.file("a.obj") + ": 1 of 2 faces are wound against their normals (turned); refused because of --strict");
  testing::internal::CaptureStderr();
  const Mesh mesh = load_scene(folder_.file("scene.json"), OnFlaw::kMend).mesh;
  EXPECT_NE(testing::internal::GetCapturedStderr().find("warning: "), std::string::npos);
  for (const Face& face : mesh.faces) {
    EXPECT_GT(face_normal(mesh.positions, face).z(), 0.9F);
  }
}

TEST_F(Materials, AreOnTheOtherSideOfAMeshThatIsFlipped) {
  const Mesh box = load(R"({"primitive": "box", "flip": true, "transform": {"scale": [1, -1, 1]}})").mesh;
  EXPECT_NEAR(signed_volume(box), -1.0, 1e-6);
  for (std::size_t v = 0; v < box.positions.size(); ++v) {
    EXPECT_LT(box.normals[v].dot(box.positions[v]), 0.0F);
    EXPECT_EQ(box.normals[v], box.geometric_normals[v]);
  }
  EXPECT_NEAR(signed_volume(load(R"({"primitive": "box", "flip": false})").mesh), 1.0, 1e-6);
  EXPECT_EQ(refusal(R"({"primitive": "box", "flip": 1})"), "/flip: expected true or false, got 1");
}

TEST_F(Materials, ThatCannotBeAreRefused) {
  put("a.mtl", kPaints);
  put("a.obj", kTwoPaints);
  const std::pair<const char*, const char*> cases[] = {
      {R"("primitive": "box", "sides": 3)", "/sides: expected an integer from 1 to 2, got 3"},
      {R"("primitive": "box", "emission": [1, -1, 1])", "/emission/1: expected three numbers of 0 or more, got -1"},
      {R"("primitive": "box", "mirror": [1.5, 1, 1])", "/mirror/0: expected three numbers from 0 to 1, got 1.5"},
      {R"("primitive": "box", "mirror": [0.5, 0.5, 0.5], "albedo": [0.4, 0.6, 0.2])",
       "/mirror: expected a reflectance that is at most 1 together with the albedo, got [0.5,0.5,0.5]"},
      {R"("primitive": "box", "materials": {"red": {}})",
       "/materials/red: expected no `materials`: the mesh has none, got {}"},
      {R"("file": "a.obj", "materials": {"green": {}})",
       "/materials/green: expected the name of one of the mesh's materials (red, lamp), got {}"},
      {R"("file": "a.obj", "materials": {"red": {"colour": [1, 1, 1]}})",
       "/materials/red/colour: unknown key, expected one of albedo, brdf, emission, exponent, metallic, mirror, "
       "normal_map, roughness, "
       "sides, specular, subsurface, translucent"}};
  for (const auto& [mesh, message] : cases) EXPECT_EQ(refusal("{" + std::string(mesh) + "}"), message);
}

}  // namespace
}  // namespace sh::prt::test
