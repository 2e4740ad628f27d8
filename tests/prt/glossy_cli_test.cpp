// Glossy transfer with the tool `prt`: results, and what it refuses in one line.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

std::string scene_with(const std::string& material, const std::string& bake) {
  return R"({"meshes": [{"primitive": "torus", "segments": 16, )" + material + R"(}], "ground": {}, "bake": {)" + bake +
         "}}";
}

const std::string kGold = R"("albedo": [0.1, 0.1, 0.1], "specular": [0.8, 0.6, 0.3], "exponent": 20)";

class GlossyTool : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    for (const std::string kind : {"unshadowed", "shadowed"}) {
      write_all(folder->file(kind + ".json"),
                scene_with(kGold, R"("directions": 128, "transfer": "glossy_)" + kind + "\""));
      succeeded({"bake", folder->file(kind + ".json"), "-o", folder->file(kind)});
    }
  }
  static void TearDownTestSuite() { delete folder; }

  static void expect_scene_refused(const std::string& material, const std::string& bake, const std::string& reason) {
    write_all(folder->file("bad.json"), scene_with(material, bake));
    expect_refused({"bake", folder->file("bad.json"), "-o", folder->file("bad")}, reason);
    EXPECT_FALSE(std::filesystem::exists(folder->file("bad")));
  }

  static inline TemporaryFolder* folder = nullptr;
};

TEST_F(GlossyTool, TellsOperatorDegreesAndBytes) {
  const auto shadowed = printed({"info", folder->file("shadowed"), "--check"});
  EXPECT_EQ(shadowed["kind"], "GS");
  EXPECT_EQ(shadowed["meets"], "operator");
  EXPECT_EQ(shadowed["degree"], 4);
  EXPECT_EQ(shadowed["result_degree"], 4);
  EXPECT_EQ(shadowed["bytes_a_vertex"], 324);
  EXPECT_EQ(shadowed["sharpest_lobe"]["exponent"], 20);
  const auto unshadowed = printed({"info", folder->file("unshadowed")});
  EXPECT_EQ(unshadowed["kind"], "GU");
  EXPECT_EQ(unshadowed["meets"], "nothing");
  EXPECT_EQ(unshadowed["bytes_a_vertex"], 0);
}

TEST_F(GlossyTool, BakesBouncesAndTellsTheirMatrices) {
  const std::string file = folder->file("bounced");
  const Finished run = succeeded({"bake", folder->file("shadowed.json"), "--kind", "glossy_interreflected", "--degree",
                                  "2", "--directions", "64", "-o", file});
  EXPECT_NE(run.err.find("(measured); matrices of 486 bytes a vertex"), std::string::npos) << run.err;
  const auto info = printed({"info", file});
  EXPECT_EQ(info["kind"], "GI");
  EXPECT_EQ(info["indirect"]["rows"], 9);
  EXPECT_EQ(info["bytes_a_vertex"], 25 * 4 + 3 * 81 * 2);
  EXPECT_EQ(info["bounces"]["certified"], false);
  succeeded({"render", file, "--width", "24", "--height", "16", "--samples", "1", "-o", folder->file("b.png")});
  const auto estimate =
      printed({"bake", folder->file("shadowed.json"), "--kind", "glossy_interreflected", "--estimate"});
  EXPECT_TRUE(estimate["bounces"].is_null()) << "not estimated";
  EXPECT_GT(estimate["bytes"], 4 * 9 * 32 * 4 * estimate["vertices"].get<std::size_t>()) << "the matrices";
  expect_refused({"render", file, "--recolor", "1", "0", "0", "-o", folder->file("b.png")}, "holds its albedo");
}

TEST_F(GlossyTool, ShowsMoreOfLobesThanTheTransferHolds) {
  const auto picture = [&](const std::string& file, std::vector<std::string> more) {
    std::vector<std::string> words = {
        "render", folder->file(file), "--light", "overcast",         "--width", "24", "--height",
        "16",     "--samples",        "1",       "--fixed-exposure", "1",       "-o", folder->file("sharp.png")};
    words.insert(words.end(), more.begin(), more.end());
    succeeded(words);
    return read_all(folder->file("sharp.png"));
  };
  for (const char* file : {"shadowed", "unshadowed"}) EXPECT_NE(picture(file, {}), picture(file, {"--sharp"}));
  EXPECT_EQ(picture("shadowed", {"--sharp"}), picture("shadowed", {"--sharp", "--threads", "1"}));
  expect_refused({"render", folder->file("shadowed"), "--sharp", "--white", "-o", folder->file("b.png")},
                 "--sharp: expected a file of glossy transfer and light in color");
  expect_refused({"render", folder->file("shadowed"), "--sharp", "--window", "hann", "-o", folder->file("b.png")},
                 "--sharp: expected lights without a window");
  succeeded({"bake", folder->file("shadowed.json"), "--kind", "shadowed", "--degree", "1", "--directions", "16", "-o",
             folder->file("diffuse")});
  expect_refused({"render", folder->file("diffuse"), "--sharp", "-o", folder->file("b.png")},
                 "--sharp: expected a file of glossy transfer");
}

TEST_F(GlossyTool, BakesAndTellsBrdfs) {
  write_all(folder->file("brdf.json"), scene_with(R"("albedo": [0.9, 0.7, 0.3], "roughness": 0.4, "metallic": 1)",
                                                  R"("degree": 2, "directions": 64, "transfer": "glossy_shadowed")"));
  succeeded({"bake", folder->file("brdf.json"), "-o", folder->file("brdf")});
  const auto info = printed({"info", folder->file("brdf"), "--check"});
  ASSERT_EQ(info["brdfs"].size(), 1U);
  EXPECT_EQ(info["brdfs"][0]["name"], "roughness 0.4, metallic 1");
  EXPECT_GT(info["brdfs"][0]["share_that_the_degree_holds"], 0.1);
  const Finished sharp = succeeded({"render", folder->file("brdf"), "--sharp", "--width", "24", "--height", "16",
                                    "--samples", "1", "-o", folder->file("b.png")});
  EXPECT_NE(sharp.err.find("above degree 2: BRDF `roughness 0.4, metallic 1` as a lobe of exponent"), std::string::npos)
      << sharp.err;
  write_all(folder->file("brdf.json"), scene_with(R"("brdf": "none.binary")", R"("degree": 2)"));
  expect_refused({"bake", folder->file("brdf.json"), "-o", folder->file("brdf2")},
                 "none.binary: cannot read the measured BRDF: No such file or directory");
}

TEST_F(GlossyTool, SaysHowMuchOfALobeTheDegreeHolds) {
  write_all(folder->file("sharp.json"), scene_with(R"("albedo": [0, 0, 0], "specular": [1, 1, 1], "exponent": 1000)",
                                                   R"("degree": 2, "directions": 64, "transfer": "glossy_shadowed")"));
  const Finished run = succeeded({"bake", folder->file("sharp.json"), "-o", folder->file("sharp")});
  EXPECT_NE(run.err.find("degree 2 holds 0.9 % of the lobe of exponent 1000"), std::string::npos) << run.err;
}

TEST_F(GlossyTool, RendersAndRelightsTowardsTheEye) {
  for (const std::string kind : {"unshadowed", "shadowed"}) {
    const auto ply = [&](const std::string& x) {
      succeeded({"relight", folder->file(kind), "--eye", x, "-2", "1", "-o", folder->file("a.ply")});
      return read_all(folder->file("a.ply"));
    };
    const std::string first = ply("3");
    EXPECT_EQ(ply("3"), first) << kind;
    EXPECT_NE(ply("-3"), first) << kind << ": glossy light depends on the eye";
    const auto picture = [&](const std::string& threads) {
      succeeded({"render", folder->file(kind), "--width", "48", "--height", "32", "--samples", "1", "--threads",
                 threads, "-o", folder->file("a.png")});
      return read_all(folder->file("a.png"));
    };
    EXPECT_EQ(picture("1"), picture("2")) << kind;
  }
}

TEST_F(GlossyTool, RefusesMaterialsThatReflectTooMuchOrHalfOfALobe) {
  const std::string bake = R"("transfer": "glossy_shadowed")";
  expect_scene_refused(R"("specular": [0.5, 0.5, 0.5])", bake,
                       "/meshes/0: expected `specular` and `exponent` together");
  expect_scene_refused(R"("exponent": 3)", bake, "/meshes/0: expected `specular` and `exponent` together");
  expect_scene_refused(R"("specular": [0.6, 0.1, 0.1], "exponent": 3)", bake,
                       "/meshes/0: expected reflectances of at most 1 together");
  expect_scene_refused(R"("specular": [0.1, 0.1, 0.1], "exponent": -1)", bake,
                       "/meshes/0/exponent: expected an exponent from 0 to 1e6");
  expect_scene_refused(R"("specular": [0.1, 0.1, 0.1], "exponent": 1e7)", bake, "/meshes/0/exponent");
  expect_scene_refused(R"("specular": [1.1, 0, 0], "exponent": 1)", bake, "/meshes/0/specular");
}

TEST_F(GlossyTool, RefusesBakesThatGlossyTransferCannotHold) {
  expect_scene_refused(kGold, R"("transfer": "glossy_shadowed", "degree": 6)",
                       "degree: expected 0 to 5 (of the kind glossy_shadowed), got 6");
  expect_scene_refused(kGold, R"("transfer": "glossy_shadowed", "sampler": "cosine")", "the sampler cosine");
  expect_scene_refused(R"("mirror": [1, 1, 1])", R"("transfer": "glossy_shadowed")", "expected no mirrors");
  expect_scene_refused(kGold, R"("transfer": "shiny")", "glossy_shadowed");
  expect_refused({"plan", folder->file("shadowed.json"), "--sampler", "cosine"}, "the sampler cosine");
}

TEST_F(GlossyTool, BakesByAPlanWithAnError) {
  const std::string scene = folder->file("shadowed.json");
  const auto plan = printed({"plan", scene, "--error", "0.1", "--json"});
  EXPECT_LE(plan["error"].get<double>(), 0.1);
  EXPECT_LT(plan["bytes"]["planned"], plan["bytes"]["asked"]);
  EXPECT_NE(plan["error_known_by"].get<std::string>().find("99 % confidence"), std::string::npos);
  EXPECT_NE(succeeded({"plan", scene, "--error", "0.1"}).out.find("\nerror "), std::string::npos);
  succeeded({"bake", scene, "--error", "0.1", "-o", folder->file("planned")});
  const auto info = printed({"info", folder->file("planned")});
  EXPECT_EQ(info["plan"]["budget"], 0.1);
  EXPECT_EQ(info["storage"]["element"], "byte");
  const auto without = printed({"plan", scene, "--error", "0.1", "--without", "storage,bands", "--json"});
  EXPECT_EQ(without["bake"]["degree"], 4);
  EXPECT_EQ(without["storage"]["element"], "single");
  for (const std::string file : {"planned", "shadowed"}) {
    succeeded({"relight", folder->file(file), "--eye", "3", "-2", "1", "-o", folder->file("a.ply")});
    succeeded({"render", folder->file(file), "--width", "24", "--height", "16", "-o", folder->file("a.png")});
  }
  expect_refused({"plan", scene, "--error", "1e-7"}, "cannot be met");
  const auto nothing = printed({"plan", folder->file("unshadowed.json"), "--json"});
  EXPECT_EQ(nothing["error"], 0.0);
  EXPECT_EQ(nothing["bytes"]["asked"], 0);
}

TEST_F(GlossyTool, RefusesGlossyTransferWhereNoDirectionOfViewIsKnown) {
  const std::string file = folder->file("shadowed");
  for (const std::string kind : {"GU", "GS", "GI"}) {
    expect_refused({"shader", "--kind", kind}, "--kind " + kind + ": the shader of a glossy kind depends on its file");
  }
  expect_refused({"render", file, "--local", "4", "-o", folder->file("x.png")}, "--local 4: glossy transfer");
  expect_refused({"relight", file, "--eye", "1", "2", "-o", folder->file("x.ply")}, "--eye");
  expect_refused({"relight", file, "--eye", "nan", "2", "1", "-o", folder->file("x.ply")}, "--eye");
}

// The visibility does not know the material.
TEST_F(GlossyTool, ShowsAnotherLobeThanThatOfTheBake) {
  const std::string other = R"("albedo": [0.1, 0.1, 0.1], "specular": [0.2, 0.5, 0.7], "exponent": 3)";
  const auto mean = [](const std::vector<std::string>& options) {
    std::vector<std::string> words = {
        "relight", "--eye", "3", "-2", "1", "--light", "overcast", "-o", folder->file("a.ply")};
    words.insert(words.end(), options.begin(), options.end());
    const std::string said = succeeded(words).err;
    return said.substr(said.find("mean exit radiance"));
  };
  const std::vector<std::string> lobe = {"--lobe", "0.2", "0.5", "0.7", "3"};
  for (const std::string kind : {"unshadowed", "shadowed"}) {
    const std::string bake = R"("directions": 128, "transfer": "glossy_)" + kind + "\"";
    write_all(folder->file("other.json"),
              R"({"meshes": [{"primitive": "torus", "segments": 16, )" + other + "}], \"bake\": {" + bake + "}}");
    write_all(folder->file("gold.json"),
              R"({"meshes": [{"primitive": "torus", "segments": 16, )" + kGold + "}], \"bake\": {" + bake + "}}");
    for (const std::string name : {"other", "gold"}) {
      succeeded({"bake", folder->file(name + ".json"), "-o", folder->file(name)});
    }
    std::vector<std::string> changed = {folder->file("gold")};
    changed.insert(changed.end(), lobe.begin(), lobe.end());
    EXPECT_EQ(mean(changed), mean({folder->file("other")})) << kind;
    EXPECT_NE(mean(changed), mean({folder->file("gold")})) << kind;
  }
  const std::string file = folder->file("gold");
  const auto refused = [&](const std::string& of, const std::vector<std::string>& numbers, const std::string& reason) {
    std::vector<std::string> words = {"relight", of, "-o", folder->file("x.ply"), "--lobe"};
    words.insert(words.end(), numbers.begin(), numbers.end());
    expect_refused(words, reason);
  };
  refused(file, {"0.2", "0.5", "1.7", "3"}, "--lobe 0.2 0.5 1.7 3: expected reflectances from 0 to 1");
  refused(file, {"0.2", "0.5", "0.7", "2e6"}, "an exponent from 0 to 1e6");
  refused(file, {"0.2", "0.5", "nan", "2"}, "--lobe: expected a finite number, got nan");
  refused(file, {"0.2", "0.5", "0.95", "2"}, "reflects 1.05 together with the albedo");
  refused(file, {"0.2", "0.5"}, "--lobe");
  succeeded({"bake", folder->file("gold.json"), "--kind", "shadowed", "--degree", "1", "--directions", "16", "-o",
             folder->file("dull")});
  refused(folder->file("dull"), {"0.2", "0.5", "0.7", "3"}, "transfer of kind DS shows no other lobe");
}

TEST_F(GlossyTool, ComparesBakesAsTheCameraSeesThem) {
  const std::string shadowed = folder->file("shadowed");
  const std::string unshadowed = folder->file("unshadowed");
  const std::string picture = folder->file("compared.png");
  const auto same = printed({"compare", shadowed, shadowed, "--light", "overcast", "-o", picture});
  EXPECT_EQ(same["relative_rms"], 0.0);
  EXPECT_GT(std::filesystem::file_size(picture), 100U);
  EXPECT_GT(printed({"compare", unshadowed, shadowed, "--light", "overcast"})["relative_rms"], 0.05);
  succeeded(
      {"bake", folder->file("shadowed.json"), "--kind", "shadowed", "--directions", "128", "-o", folder->file("dull")});
  EXPECT_GT(printed({"compare", folder->file("dull"), shadowed, "--light", "overcast"})["relative_rms"], 0.05)
      << "diffuse transfer lacks the lobes";
}

TEST_F(GlossyTool, WritesVectorsOfDiffuseSurfacesFromTheSameRun) {
  const std::string scene = folder->file("shadowed.json");
  const std::string vectors = folder->file("vectors");
  succeeded({"bake", scene, "--vectors", vectors, "--degree", "2", "--directions", "64", "-o", folder->file("both")});
  EXPECT_EQ(printed({"info", vectors})["kind"], "DI");
  EXPECT_EQ(printed({"info", folder->file("both")})["kind"], "GS");
  succeeded({"relight", vectors, "--light", "overcast", "-o", folder->file("a.ply")});
  const std::string none = folder->file("nothing");
  expect_refused({"bake", scene, "--kind", "shadowed", "--vectors", vectors, "-o", none},
                 "--vectors: the kind shadowed");
  expect_refused({"bake", scene, "--vectors", none, "-o", none}, "expected another file than the output");
  expect_refused({"bake", scene, "--vectors", scene, "-o", none}, "expected an output that is not an input too");
  EXPECT_FALSE(std::filesystem::exists(none));
}

TEST_F(GlossyTool, FixesTheView) {
  const std::string file = folder->file("shadowed");
  const std::string seen = folder->file("seen");
  succeeded({"fix-view", file, "--eye", "3,-2,1", "-o", seen});
  const Finished whole =
      succeeded({"relight", file, "--eye", "3", "-2", "1", "--light", "overcast", "-o", folder->file("a.ply")});
  const Finished rows = succeeded({"relight", seen, "--light", "overcast", "-o", folder->file("b.ply")});
  const auto mean = [](const std::string& text) { return text.substr(text.find("mean exit radiance")); };
  EXPECT_EQ(mean(whole.err), mean(rows.err));
  EXPECT_EQ(printed({"info", seen})["kind"], "DI");
  expect_refused({"fix-view", file, "-o", seen}, "--eye");
  expect_refused({"fix-view", file, "--eye", "nan", "0", "0", "-o", seen}, "nan");
  expect_refused({"fix-view", file, "--eye", "0", "0", "0", "-o", file}, "expected an output that is not an input too");
  expect_refused({"fix-view", seen, "--eye", "0", "0", "0", "-o", folder->file("c")}, "expected a glossy kind");
  expect_refused({"fix-view", folder->file("none"), "--eye", "0", "0", "0", "-o", seen}, "none");
}

}  // namespace
}  // namespace sh::prt::test
