// `prt lightmap`: every content over every kind, read back; refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "prt/image/image.hpp"
#include "prt/light/light.hpp"
#include "prt/runtime/lightmap.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

class LightmapTool : public testing::Test {
 protected:
  std::string baked(const std::string& kind, const std::string& texels = R"("texels": 6)") {
    write_all(folder_.file("s.json"),
              R"({"meshes": [{"primitive": "plane", "albedo": [0.5, 0.25, 0.75], )" + texels +
                  R"(}, {"primitive": "box", "transform": {"translate": [0, 0, 0.6], "scale": 0.2}}],
                                             "bake": {"directions": 64, "degree": 2, "transfer": ")" +
                  kind + "\"}}");
    succeeded({"bake", folder_.file("s.json"), "-o", folder_.file("t")});
    return folder_.file("t");
  }
  TemporaryFolder folder_;
  const std::string out_ = folder_.file("l.exr");
};

TEST_F(LightmapTool, WritesTheRadianceOfTexelsUnderTheLight) {
  for (const char* kind : {"unshadowed", "shadowed", "interreflected"}) {
    const Transfer transfer = read_transfer(baked(kind));
    succeeded({"lightmap", folder_.file("t"), "-o", out_, "--of", "radiance", "--light", "constant"});
    const Image image = read_image(out_, OnFlaw::kRefuse);
    ASSERT_EQ(image.width, 6);
    ASSERT_EQ(image.height, 6);
    const auto radiance = relight(transfer, project(load_lights({{.type = LightType::kConstant}}, OnFlaw::kRefuse), 2));
    const Atlases::Head& atlas = transfer.mesh.atlases.heads[0];
    for (std::uint32_t i = 0; i < atlas.count; ++i) {
      EXPECT_LT((image.pixels[transfer.mesh.atlases.pixels[i]] - radiance[atlas.first + i]).norm(), 1e-6F) << kind;
    }
    succeeded({"lightmap", folder_.file("t"), "-o", out_, "--light", "constant"});
    const Image irradiance = read_image(out_, OnFlaw::kRefuse);
    EXPECT_NEAR(irradiance.pixels[0].y(), 3.14159265F * image.pixels[0].y() / 0.25F, 1e-5F) << kind;
  }
}

TEST_F(LightmapTool, TheIrradianceDoesNotDependOnTheColor) {
  baked("shadowed");
  succeeded({"lightmap", folder_.file("t"), "-o", out_, "--light", "constant"});
  const Image own = read_image(out_, OnFlaw::kRefuse);
  succeeded({"lightmap", folder_.file("t"), "-o", out_, "--light", "constant", "--recolor", "1,1,1"});
  const Image recolored = read_image(out_, OnFlaw::kRefuse);
  for (std::size_t i = 0; i < own.pixels.size(); ++i) EXPECT_LT((own.pixels[i] - recolored.pixels[i]).norm(), 1e-5F);
}

TEST_F(LightmapTool, DoesNotOverwriteItsInput) {
  write_all(folder_.file("s.json"),
            R"({"meshes": [{"primitive": "plane", "texels": 2}, {"primitive": "plane", "texels": 2,
                "transform": {"translate": [2, 0, 0]}}], "bake": {"directions": 64}})");
  succeeded({"bake", folder_.file("s.json"), "-o", folder_.file("l_2.exr")});  // as the map of the second atlas
  const std::string transfer = read_all(folder_.file("l_2.exr"));
  expect_refused({"lightmap", folder_.file("l_2.exr"), "-o", out_}, "l_2.exr");
  EXPECT_TRUE(read_all(folder_.file("l_2.exr")) == transfer);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("l_1.exr")));
}

TEST_F(LightmapTool, WritesDirectionalIrradianceAndRows) {
  baked("glossy_shadowed");
  succeeded({"lightmap", folder_.file("t"), "-o", out_, "--of", "directional", "--light", "constant"});
  const std::string bytes = read_all(out_);
  for (const char* channel : {"e0.R", "e1.G", "e2.B", "e3.R"}) EXPECT_NE(bytes.find(channel), std::string::npos);
  succeeded({"lightmap", folder_.file("t"), "-o", out_, "--of", "transfer"});
  EXPECT_NE(read_all(out_).find("T.24"), std::string::npos) << "visibility of degree 4";
  baked("interreflected");
  succeeded({"lightmap", folder_.file("t"), "-o", out_, "--of", "transfer"});
  EXPECT_NE(read_all(out_).find("B.08"), std::string::npos);
}

TEST_F(LightmapTool, WritesOneFileForEachAtlas) {
  write_all(folder_.file("s.json"),
            R"({"meshes": [{"primitive": "plane", "texels": 6}, {"primitive": "plane", "texels": 3,
                "transform": {"translate": [2, 0, 0]}}], "bake": {"directions": 64}})");
  succeeded({"bake", folder_.file("s.json"), "-o", folder_.file("t")});
  succeeded({"lightmap", folder_.file("t"), "-o", out_});
  EXPECT_EQ(read_image(folder_.file("l_1.exr"), OnFlaw::kRefuse).width, 6);
  EXPECT_EQ(read_image(folder_.file("l_2.exr"), OnFlaw::kRefuse).width, 3);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(LightmapTool, RefusesWhatHasNoSuchMap) {
  baked("shadowed", R"("max_edge": 0.5)");
  expect_refused({"lightmap", folder_.file("t"), "-o", out_}, "its receivers are vertices; expected");
  baked("shadowed");
  expect_refused({"lightmap", folder_.file("t"), "-o", out_, "--of", "directional"}, "holds the cosine");
  expect_refused({"lightmap", folder_.file("t"), "-o", folder_.file("l.png")}, "ends in .exr");
  expect_refused({"lightmap", folder_.file("t"), "-o", out_, "--of", "albedo"}, "--of");
  baked("glossy_shadowed");
  expect_refused({"lightmap", folder_.file("t"), "-o", out_}, "depends on the eye");
  baked("glossy_unshadowed");
  expect_refused({"lightmap", folder_.file("t"), "-o", out_, "--of", "transfer"}, "it stores no numbers");
  EXPECT_FALSE(std::filesystem::exists(out_));
  for (const char* texels : {"0", "-1", "8193", "1.5", "\"a\""}) {
    write_all(folder_.file("s.json"), R"({"meshes": [{"primitive": "plane", "texels": )" + std::string(texels) + "}]}");
    expect_refused({"bake", folder_.file("s.json"), "-o", folder_.file("u")}, "texels");
  }
  write_all(folder_.file("s.json"), R"({"meshes": [{"primitive": "arch", "texels": 8}]})");
  expect_refused({"bake", folder_.file("s.json"), "-o", folder_.file("u")}, "the mesh has none");
  write_all(folder_.file("s.json"), R"({"meshes": [{"primitive": "box", "texels": 8}]})");
  expect_refused({"bake", folder_.file("s.json"), "-o", folder_.file("u")}, "its texture coordinates overlap: faces ");
}

}  // namespace
}  // namespace sh::prt::test
