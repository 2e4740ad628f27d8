// Normal maps: their frames on surfaces, what pictures show with them, files, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <tuple>

#include "numeric/output/png.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/shading_normals.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/cosine_integral.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Eigen::Vector3f kFlat(0.5F, 0.5F, 1.0F);
const Eigen::Vector3f kTilted = Eigen::Vector3f(0.48F, -0.36F, 0.8F);  // unit

Eigen::Vector3f texel_of(const Eigen::Vector3f& normal) { return 0.5F * (normal + Eigen::Vector3f::Ones()); }

Image one_color(const Eigen::Vector3f& color, int width = 1, int height = 1) {
  return {width, height, std::vector<Eigen::Vector3f>(static_cast<std::size_t>(width * height), color), 0};
}

Image squares(const std::vector<Eigen::Vector3f>& colors, int width) {
  return {width, static_cast<int>(colors.size()) / width, colors, 0};
}

NormalMaps maps_of(const Image& image) {
  NormalMaps maps;
  maps.number_of(normal_map_of("map", image));
  return maps;
}

// The mesh of a primitive with a map; its texture coordinates are those of the primitive.
Mesh mapped(std::string_view primitive, const Image& image, int segments = 24) {
  Soup soup = make_primitive(primitive, segments);
  soup.finishes[0].normal_map = std::make_shared<NormalMap>(normal_map_of("map", image));
  return weld(soup, soup.positions.size());
}

Mesh without_map(Mesh mesh) {
  mesh.texture.clear();
  mesh.normal_map.clear();
  mesh.normal_maps = {};
  return mesh;
}

std::vector<Hit> hits_on(const Mesh& mesh) {
  std::vector<Hit> hits;
  for (std::uint32_t f = 0; f < mesh.faces.size(); f += 3) {
    for (const auto& [u, v] : {std::pair(0.25F, 0.5F), std::pair(0.1F, 0.1F), std::pair(0.0F, 1.0F)}) {
      hits.push_back({f, u, v, 1.0F});
    }
  }
  return hits;
}

// Glossy transfer by `kind` of meshes that differ only in normals and maps, without another bake.
Surface surface_of(const Transfer& transfer, const LightCoefficients& light) {
  return glossy_surface(transfer, TransferredRadiance(transfer, light), transfer.mesh.albedo);
}

// Diffuse with a lobe, and with a BRDF.
std::vector<Mesh> finishes_of(const Mesh& mesh) {
  Mesh coated = mesh;
  coated.brdf.assign(mesh.positions.size(), 1);
  coated.brdfs.number_of(microfacet_reflectance(0.5F, 0.5F));
  return {polished(mesh, 0.5F, 0.4F, 10.0F), coated};
}

TEST(NormalMap, WithFlatTexelsShowsThePictureWithoutAMap) {
  for (const Mesh& mesh : finishes_of(mapped("torus", one_color(kFlat, 3, 2), 16))) {
    for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
      const LightCoefficients light = random_light(2, 7);
      const Transfer with = baked(mesh, kind, 64, 2);
      Transfer without = with;
      without.mesh = without_map(mesh);
      const Surface a = surface_of(with, light);
      const Surface b = surface_of(without, light);
      for (const Hit& hit : hits_on(mesh)) {
        const Eigen::Vector3f direction = Eigen::Vector3f(0.6F, 0.0F, -0.8F);
        EXPECT_LT((a(hit, direction) - b(hit, direction)).norm(), 2e-6F);
      }
    }
  }
}

TEST(NormalMap, OfEightBitsIsFlatToTheRoundingOfATexel) {
  const TemporaryFolder folder;
  output::write_png(folder.file("flat.png"), 1, 1, std::vector<std::uint8_t>{128, 128, 255});
  NormalMaps maps;
  maps.number_of(read_normal_map(folder.file("flat.png"), OnFlaw::kRefuse));
  const Eigen::Vector3f n = maps.normal(0, {0.3F, 0.7F});
  EXPECT_NEAR(n.x(), 1.0F / 255.0F, 1e-5F) << "linear, not sRGB";
  EXPECT_NEAR(n.y(), 1.0F / 255.0F, 1e-5F);
  EXPECT_EQ(maps.heads[0].name, "flat.png");
}

TEST(NormalMap, ThatTiltsIsTheMeshWithTiltedNormals) {
  for (const Mesh& mesh : finishes_of(mapped("plane", one_color(texel_of(kTilted))))) {
    Transfer with = baked(mesh, &kGlossyShadowed, 64, 4);
    Transfer turned = with;
    turned.mesh = without_map(mesh);
    turned.mesh.normals.assign(mesh.positions.size(), kTilted);
    const LightCoefficients light = random_light(4, 3);
    for (const Hit& hit : hits_on(mesh)) {
      for (const Eigen::Vector3f& direction :
           {Eigen::Vector3f(0.0F, 0.6F, -0.8F), Eigen::Vector3f(0.99F, 0.1F, -0.1F)}) {
        const Eigen::Vector3f expected = surface_of(turned, light)(hit, direction.normalized());
        EXPECT_LT((surface_of(with, light)(hit, direction.normalized()) - expected).norm(), 3e-3F * expected.norm());
      }
    }
  }
}

// The light is a sum of bands to degree 4, whose integral with the clamped cosine the quadrature has exactly.
TEST(NormalMap, GathersTheCosineAboutTheMappedNormalAsByIntegration) {
  const LightCoefficients light = random_light(4, 11);
  for (const Eigen::Vector3f& n : {kTilted, Eigen::Vector3f(0.0F, 0.0F, 1.0F), Eigen::Vector3f(-0.8F, 0.6F, 0.0F),
                                   Eigen::Vector3f(0.0F, 0.0F, -1.0F), Eigen::Vector3f(0.6F, 0.0F, -0.8F)}) {
    Mesh mesh = mapped("plane", one_color(texel_of(n)));
    paint(mesh, {1.0F, 0.5F, 0.25F});
    const Transfer transfer = baked(mesh, &kGlossyUnshadowed, 64, 4);
    const Eigen::Vector3f seen = surface_of(transfer, light)({0, 0.3F, 0.3F, 1.0F}, -Eigen::Vector3f::UnitZ());
    const std::vector<double> cosine =
        transfer_by_quadrature(4, n.cast<double>().normalized(), 0.0, 2.0 * std::numbers::pi);
    for (std::size_t c = 0; c < 3; ++c) {
      double expected = 0.0;
      for (std::size_t i = 0; i < cosine.size(); ++i) expected += cosine[i] * light.at(c, i);
      EXPECT_NEAR(seen[static_cast<Eigen::Index>(c)],
                  expected * static_cast<double>(mesh.albedo[0][static_cast<Eigen::Index>(c)]), 1e-3)
          << n.transpose();
    }
  }
}

TEST(NormalMap, BelowTheHorizonIsFiniteInEveryKindAndFinish) {
  for (const Mesh& mesh : finishes_of(mapped("torus", one_color(texel_of({0.6F, 0.0F, -0.8F})), 12))) {
    for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
      const Transfer transfer = baked(mesh, kind, 64, 2);
      const Surface surface = surface_of(transfer, random_light(2, 5));
      for (const Hit& hit : hits_on(mesh)) {
        for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(surface(hit, Eigen::Vector3f::Unit(axis)).allFinite());
      }
    }
  }
}

// The coordinates are turned, mirrored, stretched and scaled; what u and v point to, the derivatives of the place say.
TEST(ShadingNormals, FollowTheTextureCoordinates) {
  Mesh mesh = mapped("plane", one_color(texel_of(kTilted)));
  for (const float mirror : {1.0F, -1.0F}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      for (const auto& [stretch, size] :
           {std::pair(1.0F, 1.0F), {1e-3F, 1.0F}, {50.0F, 1.0F}, {1.0F, 1e-4F}, {3.0F, 1e4F}}) {
        const Eigen::Rotation2Df turn(0.5F * std::numbers::pi_v<float> * static_cast<float>(quarter));
        const Eigen::Matrix2f place_of = turn.toRotationMatrix() * Eigen::DiagonalMatrix<float, 2>(mirror, stretch);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
          mesh.texture[v] = size * (place_of.inverse() * mesh.positions[v].head<2>());
        }
        const Eigen::Vector2f along_u = place_of.col(0).normalized();
        const Eigen::Vector2f along_v = place_of.col(1).normalized();
        Eigen::Vector3f expected = Eigen::Vector3f(0.0F, 0.0F, kTilted.z());
        expected.head<2>() = kTilted.x() * along_u + kTilted.y() * along_v;
        const Eigen::Vector3f n = ShadingNormals(mesh).at({1, 0.2F, 0.3F, 1.0F});
        EXPECT_LT((n - expected).norm(), 1e-3F) << mirror << " " << quarter << " " << stretch;
      }
    }
  }
}

// A picture and its mirror image that share the vertices of the seam.
TEST(ShadingNormals, AreMirroredWhereCoordinatesAreWithoutASeam) {
  Soup soup;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      soup.positions.emplace_back(x, y, 0.0);
      soup.normals.emplace_back(Eigen::Vector3f::UnitZ());
      soup.albedo.emplace_back(0.5F, 0.5F, 0.5F);
      soup.texture.emplace_back(std::abs(x), y);
    }
  }
  soup.faces = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  soup.finishes[0].normal_map = std::make_shared<NormalMap>(normal_map_of("map", one_color(texel_of(kTilted))));
  const Mesh mesh = weld(soup);
  ASSERT_EQ(mesh.positions.size(), 6U);
  const ShadingNormals normals(mesh);
  for (const float u : {0.0F, 0.5F, 1.0F}) {
    EXPECT_LT((normals.at({2, u, 0.0F, 1.0F}) - kTilted).norm(), 1e-3F) << u;
    const Eigen::Vector3f mirrored(-kTilted.x(), kTilted.y(), kTilted.z());
    EXPECT_LT((normals.at({0, u, 0.0F, 1.0F}) - mirrored).norm(), 1e-3F) << u;
  }
}

TEST(ShadingNormals, OfASphereTurnAboutItsOwnNormals) {
  const Mesh mesh = mapped("sphere", one_color(texel_of(kTilted)), 48);
  const ShadingNormals normals(mesh);
  for (std::uint32_t f = 0; f < mesh.faces.size(); f += 5) {
    const Hit hit{f, 0.3F, 0.4F, 1.0F};
    const Eigen::Vector3f z = interpolated(hit, mesh, mesh.normals).normalized();
    if (std::abs(z.z()) > 0.9F) continue;
    const Eigen::Vector3f x = Eigen::Vector3f::UnitZ().cross(z).normalized();
    const Eigen::Vector3f expected = kTilted.x() * x + kTilted.y() * z.cross(x) + kTilted.z() * z;
    EXPECT_LT((normals.at(hit) - expected).norm(), 0.03F) << f;
  }
  EXPECT_GT(mesh.positions.size(), primitive_mesh("sphere", 48).positions.size()) << "a seam where u wraps";
}

TEST(ShadingNormals, AreNotMappedWhereCoordinatesHaveNoAreaOrTexelsNoLength) {
  for (const Eigen::Vector3f& texel : {texel_of(kTilted), Eigen::Vector3f::Zero().eval()}) {  // one points inwards
    Mesh mesh = mapped("plane", one_color(texel));
    const std::vector<Eigen::Vector2f> good = mesh.texture;
    for (const Eigen::Vector2f& factor :
         {Eigen::Vector2f(0.0F, 0.0F), Eigen::Vector2f(1.0F, 0.0F), Eigen::Vector2f(1.0F, 1e-9F)}) {
      for (std::size_t v = 0; v < good.size(); ++v) mesh.texture[v] = good[v].cwiseProduct(factor);
      EXPECT_EQ(ShadingNormals(mesh).at({0, 0.2F, 0.3F, 1.0F}), Eigen::Vector3f::UnitZ());
    }
  }
  const Mesh empty = mapped("plane", one_color(Eigen::Vector3f::Constant(0.5F)));
  EXPECT_LT((ShadingNormals(empty).at({0, 0.2F, 0.3F, 1.0F}) - Eigen::Vector3f::UnitZ()).norm(), 1e-6F);
}

TEST(ShadingNormals, TakeTheFrameOfNeighborsWhereAFaceHasNoneOfItsOwn) {
  Mesh mesh = mapped("plane", one_color(texel_of(kTilted)));
  const std::uint32_t apart = mesh.faces[1][1] == mesh.faces[0][2] ? mesh.faces[1][2] : mesh.faces[1][1];
  mesh.texture[apart] = 0.5F * (mesh.texture[mesh.faces[0][0]] + mesh.texture[mesh.faces[0][2]]);
  EXPECT_LT((ShadingNormals(mesh).at({1, 0.2F, 0.3F, 1.0F}) - kTilted).norm(), 1e-3F);
}

TEST(ShadingNormals, OfABackAreThoseOfItsFrontMirrored) {
  Mesh mesh = mapped("plane", one_color(texel_of(kTilted)));
  const std::size_t faces = mesh.faces.size();
  add_backs(mesh, std::vector<std::uint8_t>(faces, 1));
  const ShadingNormals normals(mesh);
  for (std::uint32_t f = 0; f < faces; ++f) {
    const Eigen::Vector3f front = normals.at({f, 0.2F, 0.3F, 1.0F});
    const Eigen::Vector3f back = normals.at({f + static_cast<std::uint32_t>(faces), 0.3F, 0.2F, 1.0F});
    EXPECT_LT((back - front.cwiseProduct(Eigen::Vector3f(1.0F, 1.0F, -1.0F))).norm(), 1e-3F);
  }
}

TEST(ShadingNormals, StayWhereFacesAreSplitAndMeshesJoined) {
  std::vector<Eigen::Vector3f> colors;
  for (int i = 0; i < 12; ++i)
    colors.push_back(texel_of(Eigen::Vector3f(0.1F * static_cast<float>(i % 5), -0.2F, 0.7F)));
  Mesh whole = mapped("plane", squares(colors, 4));
  Mesh fine = primitive_mesh("box");
  const auto boxes = static_cast<std::uint32_t>(fine.faces.size());
  Mesh part = whole;
  refine(part, 0.1F);
  append(fine, part);
  append(fine, part);
  EXPECT_EQ(fine.normal_maps.heads.size(), 1U);
  const ShadingNormals coarse(whole);
  const ShadingNormals split(fine);
  for (std::uint32_t f = boxes; f < fine.faces.size(); f += 7) {
    const Hit hit{f, 0.3F, 0.4F, 1.0F};
    const Eigen::Vector3f p = interpolated(hit, fine, fine.positions);
    for (std::uint32_t k = 0; k < 2; ++k) {
      const Face& face = whole.faces[k];
      Eigen::Matrix2f edges;
      edges << (whole.positions[face[1]] - whole.positions[face[0]]).head<2>(),
          (whole.positions[face[2]] - whole.positions[face[0]]).head<2>();
      const Eigen::Vector2f uv = edges.inverse() * (p - whole.positions[face[0]]).head<2>();
      if (uv.minCoeff() < 0.0F || uv.sum() > 1.0F) continue;
      EXPECT_LT((split.at(hit) - coarse.at({k, uv.x(), uv.y(), 1.0F})).norm(), 1e-5F);
    }
  }
  EXPECT_EQ(split.at({0, 0.2F, 0.2F, 1.0F}), fine.normals[fine.faces[0][0]]);
}

TEST(NormalMaps, LieWithTheirFirstRowAboveAndRepeat) {
  const std::vector<Eigen::Vector3f> n = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};
  std::vector<Eigen::Vector3f> colors;
  for (const Eigen::Vector3f& normal : n) colors.push_back(texel_of(normal));
  const NormalMaps maps = maps_of(squares(colors, 3));  // two rows of three
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      for (const float around : {-7.0F, 0.0F, 1.0F, 4096.0F}) {
        const Eigen::Vector2f place((static_cast<float>(column) + 0.5F) / 3.0F + around,
                                    1.0F - (static_cast<float>(row) + 0.5F) / 2.0F - around);
        EXPECT_LT((maps.normal(0, place) - n[static_cast<std::size_t>(3 * row + column)]).norm(), 5e-3F)
            << row << column;
      }
    }
  }
  const Eigen::Vector3f across = (n[0] + n[2] + n[3] + n[5]).normalized();  // the corner where four copies meet
  for (const Eigen::Vector2f& corner : {Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 1), Eigen::Vector2f(5, -2)}) {
    EXPECT_LT((maps.normal(0, corner) - across).norm(), 2e-3F);
  }
  const Eigen::Vector3f between = (0.75F * n[0] + 0.25F * n[1]).normalized();
  EXPECT_LT((maps.normal(0, {0.75F / 3.0F, 0.75F}) - between).norm(), 2e-3F);
}

TEST(NormalMaps, OfOneTexelAreTheSameEverywhere) {
  const NormalMaps maps = maps_of(one_color(texel_of(kTilted)));
  for (const float u : {-1e30F, -0.3F, 0.0F, 0.5F, 0.999999F, 1.0F, 1e30F}) {
    EXPECT_LT((maps.normal(0, {u, -u}) - kTilted).norm(), 1e-3F) << u;
  }
}

TEST(NormalMaps, AreKeptOnceAndFoundAmongOthers) {
  NormalMaps maps;
  EXPECT_EQ(maps.number_of(normal_map_of("a", one_color(kFlat, 2, 3))), 0U);
  EXPECT_EQ(maps.number_of(normal_map_of("b", one_color(texel_of(kTilted), 4, 1))), 1U);
  EXPECT_EQ(maps.number_of(normal_map_of("a", one_color(kFlat, 2, 3))), 0U);
  EXPECT_EQ(maps.number_of(normal_map_of("a", one_color(texel_of(kTilted), 2, 3))), 2U);
  EXPECT_LT((maps.normal(1, {0.1F, 0.1F}) - kTilted).norm(), 1e-3F);
  EXPECT_EQ(maps.texel_count(), 16U);
  EXPECT_EQ(maps.at(2), normal_map_of("a", one_color(texel_of(kTilted), 2, 3)));
  EXPECT_EQ(maps.number_of(maps.at(1)), 1U);
  EXPECT_EQ(maps.number_of(maps.at(2)), 2U);
  const NormalMap scaled = normal_map_of("s", one_color(texel_of({0.5F, -0.25F, 1.0F})), 2.0F);
  EXPECT_EQ(static_cast<float>(scaled.texels[0]), 1.0F);
  EXPECT_EQ(static_cast<float>(scaled.texels[1]), -0.5F);
}

class MapOfScene : public testing::Test {
 protected:
  // What is said of a scene of one mesh after the name of the scene's folder.
  std::string refusal(const std::string& mesh, const std::string& bake = R"("transfer": "glossy_shadowed")") {
    write_all(folder_.file("scene.json"),
              R"({"meshes": [{)" + mesh + R"(}], "bake": {"directions": 64, )" + bake + "}}");
    std::string said = message_of([&] { bake_scene(); });
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    if (said.starts_with(folder_.file(""))) said.erase(0, folder_.file("").size());
    return said;
  }
  Transfer bake_scene() { return bake(load_scene(folder_.file("scene.json"), OnFlaw::kRefuse)); }
  void picture(const std::string& name, const Image& image) { write_exr(folder_.file(name), image); }
  TemporaryFolder folder_;
};

TEST_F(MapOfScene, ComesBesideItAndGoesIntoTheFile) {
  picture("a.exr", one_color(texel_of(kTilted), 3, 2));
  EXPECT_EQ(refusal(R"("primitive": "plane", "max_edge": 0.3, "normal_map": "a.exr")"), "");
  const Transfer made = bake_scene();
  write_transfer(folder_.file("t"), made);
  const Transfer read = read_transfer(folder_.file("t"));
  EXPECT_EQ(read.mesh.texture, made.mesh.texture);
  EXPECT_EQ(read.mesh.normal_map, std::vector<std::uint16_t>(made.mesh.positions.size(), 1));
  ASSERT_EQ(read.mesh.normal_maps.heads.size(), 1U);
  EXPECT_EQ(read.mesh.normal_maps.at(0), made.mesh.normal_maps.at(0));
  EXPECT_EQ(read.mesh.normal_maps.at(0).name, "a.exr");
  const Scene scene = load_scene(folder_.file("scene.json"), OnFlaw::kRefuse);
  EXPECT_NE(std::find(scene.files.begin(), scene.files.end(), folder_.file("a.exr")), scene.files.end());
}

// A square in the plane z = 0 of glTF, which becomes y = 0 here; v of glTF grows downwards.
std::string square_with(const nlohmann::json& material, const Textures& textures) {
  return gltf({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}, material, {{"mesh", 0}}, textures);
}
const std::vector<float> kUpright = {0, 1, 1, 1, 1, 0, 0, 0};

TEST_F(MapOfScene, ComesFromTheModelWithItsScale) {
  const std::string png = folder_.file("n.png");
  // Two pixels side by side: the left one tilts along +u, the right one along +v (up).
  output::write_png(png, 2, 1, std::vector<std::uint8_t>{204, 128, 230, 128, 204, 230});
  for (const std::string& picture : {std::string("n.png"), "data:image/png;base64," + base64_of(read_all(png))}) {
    const nlohmann::json material = {{"normalTexture", {{"index", 0}, {"scale", 0.5}}}};
    write_all(folder_.file("a.gltf"), square_with(material, {kUpright, {picture}}));
    EXPECT_EQ(refusal(R"("file": "a.gltf")"), "");
    const Mesh mesh = bake_scene().mesh;
    ASSERT_EQ(mesh.normal_maps.heads.size(), 1U);
    const ShadingNormals normals(mesh);
    for (const auto& [u, side, up] : {std::tuple(0.25F, 0.3F, 0.0F), std::tuple(0.75F, 0.0F, 0.3F)}) {
      // The face whose corners are (0, 0), (1, 0) and (1, 1) in x and z of the world.
      const Eigen::Vector3f expected = Eigen::Vector3f(side, -0.804F, up).normalized();
      EXPECT_LT((normals.at({0, u - 0.2F, 0.2F, 1.0F}) - expected).norm(), 5e-3F) << u;
    }
  }
}

TEST_F(MapOfScene, OfAModelIsLeftOutWithAWarningWhereItCannotBeShown) {
  const nlohmann::json material = {{"normalTexture", {{"index", 0}}}};
  const auto said = [&](const Textures& textures, const std::string& kind) {
    write_all(folder_.file("a.gltf"), square_with(material, textures));
    return refusal(R"("file": "a.gltf")", R"("transfer": ")" + kind + "\"");
  };
  output::write_png(folder_.file("n.png"), 1, 1, std::vector<std::uint8_t>{204, 128, 230});
  testing::internal::CaptureStderr();
  EXPECT_EQ(said({kUpright, {"n.png"}}, "shadowed"), "");
  EXPECT_NE(testing::internal::GetCapturedStderr().find("normal maps are left out, which only glossy kinds show"),
            std::string::npos);
  const Mesh left = bake_scene().mesh;
  EXPECT_TRUE(left.texture.empty() && left.normal_map.empty() && left.normal_maps.heads.empty());
  EXPECT_NE(said({{}, {"n.png"}}, "glossy_shadowed").find("without a first set of texture coordinates"),
            std::string::npos);
  const std::string missing = said({kUpright, {"none.png"}}, "glossy_shadowed");
  EXPECT_NE(missing.find("a.gltf: its picture none.png is left out: "), std::string::npos) << missing;
  EXPECT_NE(missing.find("none.png"), std::string::npos) << missing;
  write_all(folder_.file("a.gltf"), square_with(material, {kUpright, {"none.png"}}));
  write_all(folder_.file("scene.json"), R"({"meshes": [{"file": "a.gltf"}]})");
  EXPECT_TRUE(load_scene(folder_.file("scene.json"), OnFlaw::kMend).mesh.normal_map.empty());
  picture("own.exr", one_color(texel_of(kTilted)));
  EXPECT_EQ(refusal(R"("file": "a.gltf", "normal_map": "own.exr")"), "") << "that of the scene comes first";
}

TEST_F(MapOfScene, NeedsAGlossyKind) {
  picture("a.exr", one_color(kFlat));
  for (const std::string kind : {"unshadowed", "shadowed", "interreflected"}) {
    EXPECT_EQ(refusal(R"("primitive": "plane", "normal_map": "a.exr")", R"("transfer": ")" + kind + "\""),
              "scene.json: /meshes/0/normal_map: " + kind +
                  " holds the cosine about the normals of vertices, which a normal map cannot turn; expected "
                  "glossy_unshadowed, glossy_shadowed or glossy_interreflected, or no normal map");
  }
}

TEST_F(MapOfScene, IsRefusedWithoutCoordinatesOrAPicture) {
  picture("a.exr", one_color(kFlat));
  EXPECT_EQ(refusal(R"("primitive": "arch", "normal_map": "a.exr")"),
            "arch: face 0 has a normal map or a texture, but no finite texture coordinates; expected both, or neither");
  EXPECT_NE(refusal(R"("primitive": "plane", "normal_map": "none.png")").find("none.png"), std::string::npos);
  EXPECT_NE(refusal(R"("primitive": "plane", "normal_map": 1)").find("/meshes/0/normal_map: expected a string"),
            std::string::npos);
  write_all(folder_.file("b.png"), "not a picture");
  EXPECT_EQ(refusal(R"("primitive": "plane", "normal_map": "b.png")"),
            "b.png: is not an OpenEXR, Radiance .hdr, PNG or JPEG picture");
  picture("nan.exr", squares({kFlat, {0.5F, kNan, 1.0F}}, 2));
  EXPECT_EQ(refusal(R"("primitive": "plane", "normal_map": "nan.exr")"),
            "nan.exr: the pixel in column 1, row 0 is (0.5, nan, 1); expected finite values");
}

TEST_F(MapOfScene, IsRefusedInAFileWhoseNumbersAreWrong) {
  picture("a.exr", one_color(kFlat, 4, 4));
  EXPECT_EQ(refusal(R"("primitive": "plane", "normal_map": "a.exr")"), "");
  const std::string file = folder_.file("t");
  write_transfer(file, bake_scene());
  const std::string good = read_all(file);
  const auto said_of = [&](const std::string& bytes) {
    write_all(file, with_checksums(bytes));
    return message_of([&] { read_transfer(file); });
  };
  const auto with_number = [&](std::string_view section, auto number) {
    std::string bytes = good;
    std::memcpy(bytes.data() + place_of(bytes, section), &number, sizeof number);
    return said_of(bytes);
  };
  const auto with_header = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    return said_of(bytes.replace(bytes.find(from), from.size(), to));
  };
  const std::string start = file + ": damaged transfer file: ";
  EXPECT_EQ(said_of(good), "");
  EXPECT_EQ(with_number("texture", kNan), start + "a texture coordinate is not finite");
  EXPECT_EQ(with_number("normmap", std::uint16_t{2}), start + "it names a normal map that is not there");
  EXPECT_EQ(with_number("normtex", std::uint16_t{0x7e00}), start + "a texel of a normal map is not from -1 to 1");
  EXPECT_EQ(with_number("normtex", std::uint16_t{0x3c01}), start + "a texel of a normal map is not from -1 to 1");
  EXPECT_EQ(with_header("\"width\": 4", "\"width\": 5"), start + "it names a normal map that is not there");
  EXPECT_NE(with_header("\"width\": 4", "\"width\": 0").find("has 0, expected a whole number from 1"),
            std::string::npos);
  EXPECT_NE(with_header("\"width\": 4", "\"width\":-4").find("has -4"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
