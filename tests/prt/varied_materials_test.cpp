// Materials that vary from vertex to vertex: pictures of albedo, roughness and metallic part.
#include "prt/mesh/varied_materials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "numeric/output/png.hpp"
#include "numeric/output/srgb.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/scene/scene.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// A square from (0, 0) to (1, 1) in x and z of the world, upright in its picture, as glTF.
std::string square_with(const nlohmann::json& material, const std::vector<std::string>& pictures) {
  return gltf({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}, material, {{"mesh", 0}},
              {{0, 1, 1, 1, 1, 0, 0, 0}, pictures});
}

class VariedMaterials : public testing::Test {
 protected:
  Mesh load(const nlohmann::json& material, const std::vector<std::string>& pictures, const std::string& more = {}) {
    write_all(folder_.file("a.gltf"), square_with(material, pictures));
    write_all(folder_.file("scene.json"), R"({"meshes": [{"file": "a.gltf", "max_edge": 0.2)" + more + "}]}");
    return load_scene(folder_.file("scene.json"), OnFlaw::kRefuse).mesh;
  }
  void picture(const std::string& name, int width, int height, const std::vector<std::uint8_t>& rgb) {
    output::write_png(folder_.file(name), width, height, rgb);
  }
  TemporaryFolder folder_;
};

const nlohmann::json kColored = {
    {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.5, 0.25, 1.0}}, {"baseColorTexture", {{"index", 0}}}}}};

nlohmann::json faceted(double roughness, double metallic) {
  return {
      {"pbrMetallicRoughness",
       {{"roughnessFactor", roughness}, {"metallicFactor", metallic}, {"metallicRoughnessTexture", {{"index", 0}}}}}};
}

// Black below, white above, linear between the centers of the two texels.
TEST_F(VariedMaterials, TakeTheAlbedoOfThePictureTimesTheFactor) {
  picture("c.png", 1, 2, {255, 255, 255, 0, 0, 0});
  const Mesh mesh = load(kColored, {"c.png"});
  ASSERT_GT(mesh.positions.size(), 30U);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float z = mesh.positions[v].z();
    const float part = z < 0.25F || z > 0.75F ? std::abs(2.0F * (z < 0.5F ? z : z - 1.0F)) : 0.0F;
    const float expected = z < 0.25F ? 0.5F - part : z > 0.75F ? 0.5F + part : 2.0F * z - 0.5F;
    const Eigen::Vector3f factor(1.0F, 0.5F, 0.25F);
    EXPECT_LT((mesh.albedo[v] - expected * factor).norm(), 0.16F) << z << ": a mean over its place, not the point";
    EXPECT_EQ(mesh.tint[v], factor);
  }
  EXPECT_EQ(mesh.albedo_map, std::vector<std::uint16_t>(mesh.positions.size(), 1));
  EXPECT_TRUE(mesh.normal_map.empty());
}

TEST_F(VariedMaterials, TakeColorsAsSrgbAndFacetsAsLinear) {
  picture("g.png", 1, 1, {128, 128, 255});
  const Mesh colored = load(kColored, {"g.png"});
  EXPECT_NEAR(colored.albedo[0].x(), output::srgb_decode(128.0F / 255.0F), 1e-6F);
  const Mesh mesh = load(faceted(1.0, 0.25), {"g.png"});
  ASSERT_EQ(mesh.brdfs.heads.size(), 1U);
  EXPECT_EQ(mesh.brdfs.at(0), microfacet_reflectance(0.5F, 0.25F)) << "green, to a 32nd; blue, to an 8th";
  EXPECT_EQ(mesh.brdf, std::vector<std::uint16_t>(mesh.positions.size(), 1));
}

TEST_F(VariedMaterials, KeepOneTableForEachPairOfStepsInUse) {
  picture("ramp.png", 4, 1, {0, 0, 0, 0, 85, 0, 0, 170, 0, 0, 255, 0});
  const Mesh mesh = load(faceted(1.0, 1.0), {"ramp.png"});
  ASSERT_EQ(mesh.brdf.size(), mesh.positions.size());
  std::set<std::uint16_t> used(mesh.brdf.begin(), mesh.brdf.end());
  EXPECT_EQ(used.count(0), 0U);
  EXPECT_EQ(used.size(), mesh.brdfs.heads.size()) << "no table without a vertex";
  EXPECT_GT(used.size(), 4U);
  std::set<std::string> names;
  for (int step = 0; step <= kRoughnessSteps; ++step) {
    names.insert(microfacet_reflectance(static_cast<float>(step) / kRoughnessSteps, 0.0F).name);
  }
  for (const Reflectances::Head& head : mesh.brdfs.heads) EXPECT_EQ(names.count(head.name), 1U) << head.name;
}

TEST_F(VariedMaterials, GiveWayToWhatTheSceneSays) {
  picture("c.png", 1, 1, {10, 20, 30});
  const Mesh painted = load(kColored, {"c.png"}, R"(, "albedo": [0.1, 0.2, 0.3])");
  EXPECT_EQ(painted.albedo[0], Eigen::Vector3f(0.1F, 0.2F, 0.3F));
  const Mesh coated = load(faceted(1.0, 1.0), {"c.png"}, R"(, "roughness": 0.5)");
  ASSERT_EQ(coated.brdfs.heads.size(), 1U);
  EXPECT_EQ(coated.brdfs.at(0), microfacet_reflectance(0.5F, 0.0F));
}

TEST_F(VariedMaterials, AreWarnedOfWhereAPictureIsMissingOrHasNoPlace) {
  const auto said = [&](const nlohmann::json& material) { return message_of([&] { load(material, {"none.png"}); }); };
  for (const nlohmann::json& material : {kColored, faceted(1.0, 1.0)}) {
    EXPECT_NE(said(material).find("a.gltf: its picture none.png is left out: "), std::string::npos) << said(material);
  }
  nlohmann::json second = kColored;
  second["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
  EXPECT_NE(said(second).find("textures without a first set of texture coordinates"), std::string::npos);
  nlohmann::json lit = kColored;
  lit["occlusionTexture"] = {{"index", 0}};
  picture("none.png", 1, 1, {255, 255, 255});
  EXPECT_NE(said(lit).find("1 of its materials have textures (not read)"), std::string::npos) << said(lit);
}

// Two vertices of one finish and place, but with other coordinates, keep their own colors.
TEST_F(VariedMaterials, StayApartAtASeam) {
  Soup soup = make_primitive("sphere", 12);
  Image halves{2, 1, {Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones()}, 0};
  soup.finishes[0].varied.albedo = std::make_shared<Image>(halves);
  Mesh mesh = weld(soup);
  std::vector<std::uint32_t> origins(mesh.faces.size());
  for (std::uint32_t f = 0; f < origins.size(); ++f) origins[f] = f;
  EXPECT_GT(mesh.positions.size(), primitive_mesh("sphere", 12).positions.size());
  vary_materials(soup, origins, {}, mesh);
  for (const Eigen::Vector3f& albedo : mesh.albedo) EXPECT_LE(albedo.x(), 0.5F + 1e-6F);
}

TEST_F(VariedMaterials, AreInterpolatedBetweenVerticesInPictures) {
  Mesh mesh = primitive_mesh("plane");
  paint(mesh, {0.8F, 0.6F, 0.4F});
  for (const float roughness : {0.2F, 0.5F, 0.9F}) mesh.brdfs.number_of(microfacet_reflectance(roughness, 1.0F));
  mesh.brdf = {1, 2, 3, 2};
  const Transfer transfer = baked(mesh, &kGlossyShadowed, 64, 4);
  const TransferredRadiance reaching(transfer, random_light(4, 2));
  const Eigen::Vector3f direction = Eigen::Vector3f(0.5F, 0.3F, -1.0F).normalized();
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    const auto with = [&](std::uint16_t brdf) {
      Transfer one = transfer;
      one.mesh.brdf.assign(4, brdf);
      return glossy_surface(one, reaching, mesh.albedo)({f, 0.2F, 0.7F, 1.0F}, direction);
    };
    const Eigen::Vector3f expected =
        0.1F * with(mesh.brdf[face[0]]) + 0.2F * with(mesh.brdf[face[1]]) + 0.7F * with(mesh.brdf[face[2]]);
    EXPECT_LT((glossy_surface(transfer, reaching, mesh.albedo)({f, 0.2F, 0.7F, 1.0F}, direction) - expected).norm(),
              1e-5F);
  }
}

}  // namespace
}  // namespace sh::prt::test
