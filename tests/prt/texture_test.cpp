// Textures of models: pictures of the surface show them over the transfer, receivers take means of them.
#include <gtest/gtest.h>

#include "numeric/output/png.hpp"
#include "numeric/output/srgb.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/surface_colors.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const nlohmann::json kColored = {
    {"pbrMetallicRoughness",
     {{"baseColorFactor", {1.0, 0.5, 0.25, 1.0}}, {"metallicFactor", 0.0}, {"baseColorTexture", {{"index", 0}}}}}};

class Textured : public testing::Test {
 protected:
  // Two columns, the left one dark, the right one bright, on a square in x and z of the world.
  void SetUp() override {
    output::write_png(folder_.file("c.png"), 2, 1, std::vector<std::uint8_t>{64, 64, 64, 255, 255, 255});
    write(kColored);
  }
  void write(const nlohmann::json& material) {
    write_all(folder_.file("a.gltf"), gltf({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}, material,
                                           {{"mesh", 0}}, {{0, 1, 1, 1, 1, 0, 0, 0}, {"c.png"}}));
  }
  Scene scene(const std::string& more = {}, const std::string& bake = R"("transfer": "shadowed")") {
    write_all(folder_.file("scene.json"),
              R"({"meshes": [{"file": "a.gltf")" + more + R"(}], "bake": {"directions": 64, )" + bake + "}}");
    return load_scene(folder_.file("scene.json"), OnFlaw::kRefuse);
  }
  TemporaryFolder folder_;
  const float dark_ = output::srgb_decode(64.0F / 255.0F);
};

TEST_F(Textured, SurfacesShowThePictureAndNotItsMeans) {
  for (const char* kind : {"unshadowed", "shadowed", "interreflected", "glossy_shadowed"}) {
    for (const char* more : {"", R"(, "texels": 4)", R"(, "max_edge": 0.3)"}) {
      const Transfer transfer = bake(scene(more, R"("transfer": ")" + std::string(kind) + "\""));
      const Mesh& mesh = transfer.mesh;
      const SurfaceColors colors(mesh, decoded(mesh.albedo_maps, "t"));
      const LightCoefficients light = constant_light(transfer.degree());
      const Surface surface = transfer.kind->is_glossy()
                                  ? glossy_surface(transfer, TransferredRadiance(transfer, light), colors)
                                  : diffuse_surface(mesh, relight(transfer, light), transfer.emitted, colors);
      for (std::uint32_t f = 0; f < mesh.faces.size() && !transfer.kind->is_glossy(); ++f) {
        const Hit hit{f, 0.2F, 0.3F, 1.0F};
        const float x = interpolated(hit, mesh, mesh.positions).x();
        const float bright = x < 0.25F ? 0.5F - 2.0F * x : x > 0.75F ? 2.5F - 2.0F * x : 2.0F * x - 0.5F;
        const float expected = dark_ + (1.0F - dark_) * bright;
        const Eigen::Vector3f shown = surface(hit, Eigen::Vector3f::UnitY());
        EXPECT_LT((shown - expected * Eigen::Vector3f(1.0F, 0.5F, 0.25F)).norm(), 2e-3F) << kind << more << " " << x;
      }
      if (transfer.kind->is_glossy()) {
        const auto at = [&](float u) {  // the first face: (0, 0), (1, 0), (1, 1)
          return surface({0, u - 0.1F, 0.1F, 1.0F}, Eigen::Vector3f::UnitY()).x();
        };
        EXPECT_GT(at(0.75F), 1.5F * at(0.25F));
      }
    }
  }
}

TEST_F(Textured, ReceiversTakeTheMeanOverTheirPlace) {
  for (const char* more : {"", R"(, "max_edge": 0.3)", R"(, "max_edge": 0.013)"}) {
    const Mesh mesh = scene(more).mesh;
    double sum = 0.0;
    double area = 0.0;
    for (const Face& face : mesh.faces) {
      const Eigen::Vector3f a = mesh.positions[face[1]] - mesh.positions[face[0]];
      const double own = 0.5 * static_cast<double>(a.cross(mesh.positions[face[2]] - mesh.positions[face[0]]).norm());
      for (const std::uint32_t v : face) sum += own / 3.0 * static_cast<double>(mesh.albedo[v].x());
      area += own;
    }
    EXPECT_NEAR(sum / area, 0.5 * (1.0 + static_cast<double>(dark_)), 0.03) << more;
  }
  const Mesh texels = scene(R"(, "texels": 2)").mesh;
  ASSERT_EQ(texels.atlases.heads[0].count, 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(texels.albedo[4 + i].x(), i % 2 == 0 ? dark_ : 1.0F, 1e-5F) << i;
    EXPECT_NEAR(texels.tint[4 + i].y(), 0.5F, 1e-6F);
  }
}

// Finer than any vertex: squares of black and white, of which a vertex sees about as much of each.
TEST_F(Textured, AveragesFinePicturesInsteadOfPickingAPoint) {
  std::vector<std::uint8_t> rgb;
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) rgb.insert(rgb.end(), 3, (row + column) % 2 == 0 ? 0 : 255);
  }
  output::write_png(folder_.file("c.png"), 32, 32, rgb);
  for (const Eigen::Vector3f& albedo : scene().mesh.albedo) EXPECT_NEAR(albedo.x(), 0.5F, 0.05F);
  for (const Eigen::Vector3f& albedo : scene(R"(, "texels": 3)").mesh.albedo) EXPECT_NEAR(albedo.x(), 0.5F, 0.05F);
}

TEST_F(Textured, EmissionIsThatOfItsPicture) {
  nlohmann::json material = {{"emissiveFactor", {1.0, 0.5, 0.0}}, {"emissiveTexture", {{"index", 0}}}};
  write(material);
  const Mesh mesh = scene(R"(, "texels": 2)").mesh;
  EXPECT_LT((mesh.emission[4] - dark_ * Eigen::Vector3f(1.0F, 0.5F, 0.0F)).norm(), 1e-5F);
  material["emissiveFactor"] = {0.0, 0.0, 0.0};
  write(material);
  EXPECT_TRUE(scene().mesh.emission.empty());
}

TEST_F(Textured, BacksOfSheetsHaveThePictureButNoTexels) {
  nlohmann::json material = kColored;
  material["doubleSided"] = true;
  write(material);
  const Mesh mesh = scene(R"(, "texels": 3)").mesh;
  ASSERT_EQ(mesh.faces.size(), 4U);
  EXPECT_EQ(mesh.atlas[mesh.faces[0][0]], 1);
  EXPECT_EQ(mesh.atlas[mesh.faces[2][0]], 0);
  EXPECT_EQ(mesh.albedo_map[mesh.faces[2][0]], 1);
  EXPECT_EQ(mesh.atlases.heads[0].count, 9U);
  EXPECT_EQ(SurfaceReceivers(mesh).at({3, 0.3F, 0.3F, 1.0F}).count, 3U);
}

TEST_F(Textured, PicturesThatCannotBeReadAreRefusedWithTheirName) {
  Mesh mesh = scene().mesh;
  mesh.albedo_maps = {};
  mesh.albedo_maps.number_of({"a.png", "no picture"});
  EXPECT_EQ(message_of([&] { decoded(mesh.albedo_maps, "x.transfer"); }),
            "x.transfer: picture a.png: cannot be read: it is neither PNG nor JPEG");
}

TEST_F(Textured, PicturesAreDecodedInTheirOrder) {
  output::write_png(folder_.file("d.png"), 1, 2, std::vector<std::uint8_t>{255, 0, 0, 0, 0, 255});
  Mesh mesh = scene().mesh;
  EXPECT_EQ(mesh.albedo_maps.number_of({"d.png", read_all(folder_.file("d.png"))}), 1U);
  EXPECT_EQ(mesh.albedo_maps.number_of({"d.png", read_all(folder_.file("c.png"))}), 2U) << "another name";
  EXPECT_EQ(mesh.albedo_maps.number_of({"d.png", read_all(folder_.file("d.png"))}), 1U) << "the same again";
  EXPECT_EQ(mesh.albedo_maps.at(1).name, "d.png");
  const DecodedPictures pictures = decoded(mesh.albedo_maps, "t");
  ASSERT_EQ(pictures->size(), 3U);
  EXPECT_EQ((*pictures)[0].width, 2);
  EXPECT_EQ((*pictures)[1].height, 2);
  EXPECT_EQ((*pictures)[1].at(0, 1), Eigen::Vector3f::UnitZ());
  EXPECT_EQ((*pictures)[2].pixels, (*pictures)[0].pixels);
}

TEST_F(Textured, SurfacesWithoutAPictureShowTheAlbedoOfTheirCorners) {
  Mesh mesh = scene().mesh;
  const std::size_t faces = mesh.faces.size();
  append(mesh, primitive_mesh("plane"));
  const Face plain = mesh.faces[faces];
  mesh.albedo[plain[0]] = {1.0F, 0.0F, 0.25F};
  mesh.albedo[plain[1]] = {0.0F, 1.0F, 0.25F};
  mesh.albedo[plain[2]] = {0.0F, 0.0F, 0.25F};
  const Hit hit{static_cast<std::uint32_t>(faces), 0.25F, 0.5F, 1.0F};
  const SurfaceColors both(mesh, decoded(mesh.albedo_maps, "t"));
  EXPECT_TRUE(both.has_picture(0));
  EXPECT_FALSE(both.has_picture(plain[0]));
  EXPECT_LT((both.at(hit) - Eigen::Vector3f(0.25F, 0.25F, 0.25F)).norm(), 1e-6F);
  // Colors in place of the mesh's own hide its picture, too.
  std::vector<Eigen::Vector3f> others(mesh.positions.size(), Eigen::Vector3f(0.5F, 1.0F, 0.0F));
  others[plain[2]].setZero();
  const SurfaceColors replaced(mesh, others);
  EXPECT_FALSE(replaced.has_picture(0));
  EXPECT_LT((replaced.at(hit) - Eigen::Vector3f(0.25F, 0.5F, 0.0F)).norm(), 1e-6F);
  EXPECT_EQ(replaced.at({0, 0.2F, 0.3F, 1.0F}).y(), 1.0F);
}

TEST(Pictures, AreNoMoreThanTheirNumbersCount) {
  Pictures pictures;
  pictures.heads.resize(65534);
  EXPECT_EQ(pictures.number_of({"last.png", "x"}), 65534U);
  EXPECT_EQ(message_of([&] {
              pictures.number_of({"more.png", "y"});
            }),
            "more.png: a scene has more than 65535 pictures; expected fewer");
  EXPECT_EQ(pictures.number_of({"last.png", "x"}), 65534U) << "known";
}

TEST(WithoutAlbedo, TakesEmissionOffAndDividesByTheColor) {
  const std::vector<Eigen::Vector3f> radiance = {{3.0F, 1.0F, 5.0F}, {0.5F, 0.25F, 0.0F}};
  const std::vector<Eigen::Vector3f> emitted = {{1.0F, 1.0F, 2.0F}, {0.0F, 0.25F, 0.0F}};
  const std::vector<Eigen::Vector3f> albedo = {{0.5F, 0.25F, 0.0F}, {1.0F, 0.0F, 0.75F}};
  const std::vector<Eigen::Vector3f> rest = without_albedo(radiance, emitted, albedo);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0], Eigen::Vector3f(4.0F, 0.0F, 0.0F));
  EXPECT_EQ(rest[1], Eigen::Vector3f(0.5F, 0.0F, 0.0F));
  EXPECT_EQ(without_albedo(radiance, {}, albedo)[0], Eigen::Vector3f(6.0F, 4.0F, 0.0F));
}

TEST_F(Textured, AppendedMeshesKeepTheirPicturesAndAtlases) {
  const Mesh one = scene(R"(, "texels": 3)").mesh;
  Mesh both = primitive_mesh("plane");
  append(both, one);
  append(both, one);
  ASSERT_EQ(both.atlases.heads.size(), 2U);
  EXPECT_EQ(both.albedo_maps.heads.size(), 1U) << "one picture";
  EXPECT_EQ(both.atlases.heads[1].first, 4U + one.positions.size() + 4U);
  EXPECT_EQ(both.atlas[both.faces.back()[0]], 2);
  EXPECT_EQ(both.atlas.front(), 0);
  EXPECT_EQ(both.tint.size(), both.positions.size());
  EXPECT_EQ(both.atlases.pixels.size(), 18U);
  EXPECT_EQ(both.atlases.entry(1), 9U);
}

TEST_F(Textured, WavefrontFilesShowTheirDiffusePicture) {
  write_all(folder_.file("a.mtl"), "newmtl m\nKd 1 0.5 0.25\nmap_Kd .\\c.png\n");
  write_all(folder_.file("a.obj"),
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl m\nf 1/1 2/2 3/3\n");
  write_all(folder_.file("scene.json"), R"({"meshes": [{"file": "a.obj"}]})");
  const Mesh mesh = load_scene(folder_.file("scene.json"), OnFlaw::kRefuse).mesh;
  ASSERT_EQ(mesh.albedo_map.size(), mesh.positions.size());
  const SurfaceColors colors(mesh, decoded(mesh.albedo_maps, "t"));
  EXPECT_NEAR(colors.at({0, 0.65F, 0.1F, 1.0F}).x(), 1.0F, 1e-5F) << "u = 0.75: the middle of the bright column";
  EXPECT_NEAR(colors.at({0, 0.15F, 0.1F, 1.0F}).x(), dark_, 1e-5F);
}

}  // namespace
}  // namespace sh::prt::test
