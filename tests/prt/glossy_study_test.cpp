// The study of the run time: error of every representation against the time of a frame and of the bake, and its table.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "prt/study/path_render.hpp"
#include "prt/study/study.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

const StudySeries& series_called(const StudyPart& part, const std::string& name) {
  return *std::find_if(part.series.begin(), part.series.end(),
                       [&](const StudySeries& series) { return series.name.find(name) == 0; });
}

Study glossy_study() {
  Scene scene = scene_of(statue(12.0F), &kGlossyShadowed, 32, 4);
  scene.camera.position = {3.0, -4.0, 2.0};
  scene.lights.emplace_back().type = LightType::kCieOvercast;
  StudyOptions options;
  options.bounce_directions = 64;
  options.paths = 512;
  return run_study(scene, options, [](const Study&) {});
}

TEST(GlossyStudy, OrdersRepresentationsByTheirError) {
  const Study study = glossy_study();
  ASSERT_EQ(study.parts.size(), 1U);
  const StudyPart& part = study.parts.front();
  const auto error = [&](const std::string& name, std::size_t i) {
    return series_called(part, name).points.at(i).error.rms;
  };
  EXPECT_EQ(error("GI, light and view free", 3), 0.0) << "it is the reference";
  EXPECT_EQ(error("GI, light at rest", 3), 0.0);
  EXPECT_LT(error("GI, view at rest", 3), 1e-5);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_LT(error("GI, light and view free", i), error("GI, light and view free", i - 1)) << i;
    EXPECT_NEAR(error("GI, view at rest", i), error("GI, light and view free", i), 1e-5) << i;
  }
  EXPECT_GT(error("GS", 3), 10.0 * error("GI, view at rest", 3));
  EXPECT_GT(error("GU", 3), error("GS", 3));
  EXPECT_LT(error("GI in clusters", 1), error("GS", 3));
  EXPECT_GT(error("GI, V stored", 0), 0.0);
  EXPECT_LT(error("GI, V stored", 0), 1e-3) << "half";
  EXPECT_GT(error("GI, V stored", 1), 2.0 * error("GI, V stored", 0)) << "8 bits";
  EXPECT_LT(error("GI, V stored", 1), 2e-2);
}

TEST(GlossyStudy, ComparesWhatAPictureShowsWithRandomPaths) {
  const Study study = glossy_study();
  const StudyPart& part = study.parts.front();
  ASSERT_TRUE(part.paths.has_value());
  EXPECT_GT(part.paths->pixels, 200U);
  EXPECT_EQ(part.paths->paths_a_pixel, 1024);
  EXPECT_GT(part.paths->noise, 0.001);
  EXPECT_LT(part.paths->noise, 0.03);
  const auto error = [&](const std::string& name, std::size_t i) {
    return series_called(part, name).points.at(i).path_error.value();
  };
  EXPECT_LT(error("GI, light and view free", 3), 0.08);  // 64 directions, a coarse mesh, and what degree 4 leaves out
  EXPECT_EQ(error("GI, light at rest", 3), error("GI, light and view free", 3));
  EXPECT_NEAR(error("GI, view at rest", 3), error("GI, light and view free", 3), 0.1)
      << "interpolated after the lobes, over large faces";
  EXPECT_GT(error("GS", 3), 2.0 * error("GI, light and view free", 3));
  EXPECT_GT(error("GI, light and view free", 0), 2.0 * error("GI, light and view free", 3));
  EXPECT_GT(error("DI", 3), 2.0 * error("GI, light and view free", 3)) << "diffuse transfer leaves lobes out";
}

// A constant light has no higher degree; a narrow one has most of its detail there, and a point has no radiance.
TEST(GlossyStudy, SaysWhatTheCutOfTheLightCosts) {
  Scene scene = scene_of(statue(12.0F), &kGlossyShadowed, 32, 4);
  scene.camera.position = {3.0, -4.0, 2.0};
  StudyOptions options;
  options.bounce_directions = 64;
  options.paths = 512;
  const auto study_under = [&](const LightSpec& light) {
    scene.lights = {light};
    return run_study(scene, options, [](const Study&) {}).parts.front();
  };
  const auto best = [](const StudyPart& part) {
    return series_called(part, "GI, light and view free").points.at(3).path_error.value();
  };
  const StudyPart constant = study_under({.type = LightType::kConstant});
  EXPECT_NEAR(constant.paths->uncut_error.value(), best(constant), 1e-4);
  EXPECT_NEAR(constant.paths->uncut_noise.value(), constant.paths->noise, 1e-4);
  const StudyPart narrow = study_under({.type = LightType::kCap, .one_minus_cos = 0.02});
  EXPECT_GT(narrow.paths->uncut_error.value(), 2.0 * best(narrow));
  EXPECT_FALSE(study_under({.type = LightType::kDirectional}).paths->uncut_error.has_value());
}

TEST(GlossyStudy, TabulatesTypesShapesBakesRatesAndErrors) {
  const Study study = glossy_study();
  const std::vector<TableRow>& table = study.parts.front().table;
  ASSERT_EQ(table.size(), 9U);
  const char* const kinds[] = {"DS", "DI", "GU", "GS", "GI", "GI", "GI", "GI", "GI"};
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(table[i].kind, kinds[i]);
    EXPECT_GT(table[i].free.bake_seconds.value(), 0.0);
    EXPECT_EQ(table[i].seconds_fixed_view.has_value(), i >= 2 && i <= 4) << "only the glossy ones have modes";
  }
  EXPECT_GT(table[8].free.bake_seconds.value(), table[4].free.bake_seconds.value()) << "clusters come after the bake";
  for (const auto& seconds : {table[4].free.seconds, table[4].seconds_fixed_light, table[4].seconds_fixed_view}) {
    EXPECT_GT(seconds.value(), 0.0);
  }
  EXPECT_EQ(table[3].shape, "25x25 from 81");
  const std::string csv = table_csv(study);
  const std::string vertices = std::to_string(study.vertices);
  EXPECT_NE(csv.find("GS,25x25 from 81,64," + vertices + ","), std::string::npos) << csv;
  EXPECT_NE(csv.find("GI,25x25 from 81 + 25x25,64,"), std::string::npos) << "gray: one channel\n" << csv;
  EXPECT_NE(table_markdown(study).find("| GS | 25x25 from 81 | 64 | " + vertices + " |"), std::string::npos);
}

TEST(StudyTable, KeepsNamesWithinTheirCells) {
  Study study;
  study.scene = "a \"b\", c|d";
  EXPECT_EQ(table_csv(study), "");
  study.parts.push_back({.name = "runtime", .table = {{.kind = "DS", .shape = "25", .free = {.seconds = 0.004}}}});
  EXPECT_NE(table_csv(study).find("\n\"a \"\"b\"\", c|d\",DS,25,,0,,250,,,,"), std::string::npos) << table_csv(study);
  EXPECT_NE(table_markdown(study).find("\n| a \"b\", c\\|d | DS | 25 |"), std::string::npos) << table_markdown(study);
}

Picture noisy_picture(double value, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> deviation(0.0F, static_cast<float>(noise));
  Picture picture{64, 64, {}, std::vector<float>(64 * 64, 1.0F)};
  for (std::size_t i = 0; i < picture.coverage.size(); ++i) {
    picture.radiance.emplace_back(Eigen::Vector3f::Constant(static_cast<float>(value)) +
                                  Eigen::Vector3f(deviation(random), deviation(random), deviation(random)));
  }
  return picture;
}

TEST(PathError, LeavesTheNoiseOfThePathsOut) {
  const PathPictures paths{noisy_picture(2.0, 0.4, 1), noisy_picture(2.0, 0.4, 2)};
  const double noise = 0.4 / std::sqrt(2.0) / 2.0;  // of the mean, relative
  EXPECT_NEAR(path_noise(paths), noise, 0.02 * noise);
  EXPECT_NEAR(error_against_paths(noisy_picture(2.0, 0.2, 3), paths), 0.1, 0.005) << "less than the noise";
  EXPECT_NEAR(error_against_paths(noisy_picture(2.3, 0.0, 3), paths), 0.15, 0.005);
  EXPECT_LT(error_against_paths(noisy_picture(2.0, 0.0, 3), paths), 0.03) << "nothing but what chance leaves";
}

TEST(PathError, LooksOnlyAtPixelsThatTheMeshCovers) {
  PathPictures paths{noisy_picture(2.0, 0.0, 1), noisy_picture(2.0, 0.0, 2)};
  Picture picture = noisy_picture(2.0, 0.0, 3);
  picture.radiance[7] = Eigen::Vector3f::Constant(1e9F);
  paths.first.coverage[7] = 0.0F;
  EXPECT_EQ(error_against_paths(picture, paths), 0.0);
  picture.coverage.assign(picture.coverage.size(), 0.0F);
  EXPECT_TRUE(std::isnan(error_against_paths(picture, paths))) << "nothing is seen";
}

TEST(PathRender, HasHalfTheNoiseFromFourTimesThePaths) {
  const Scene scene = scene_of(statue(12.0F), &kGlossyShadowed, 32, 4);
  const Tracer tracer(scene.mesh);
  const Camera camera{{3.0, -4.0, 2.0}, {0.0, 0.0, 0.4}, {0.0, 0.0, 1.0}, 30.0F};
  const Background sky = [](const Eigen::Vector3f& direction) {
    return Eigen::Vector3f::Constant(1.0F + 0.9F * direction.z()).eval();
  };
  const double few = path_noise(path_render(scene.mesh, tracer, sky, camera, {48, 32, 1}, 32));
  const double many = path_noise(path_render(scene.mesh, tracer, sky, camera, {48, 32, 1}, 128));
  EXPECT_NEAR(few / many, 2.0, 0.2);
}

TEST(GlossyStudy, CountsTheBytesAndTimesEveryFrame) {
  const Study study = glossy_study();
  for (const StudySeries& series : study.parts.front().series) {
    for (const StudyPoint& point : series.points) EXPECT_GT(point.seconds.value(), 0.0) << series.name;
  }
  const auto bytes = [&](const std::string& name, std::size_t i = 3) {
    return series_called(study.parts.front(), name).points.at(i).bytes_a_vertex.value();
  };
  EXPECT_EQ(bytes("GI, V stored", 0), 81 * 2 + 625 * 2);
  EXPECT_EQ(bytes("GI, V stored", 1), 81 + 625 * 2);
  EXPECT_EQ(bytes("GU"), 0.0);
  EXPECT_EQ(bytes("GS"), 81 * 4);
  EXPECT_EQ(bytes("GI, light and view free"), 81 * 4 + 625 * 2) << "gray: one channel";
  EXPECT_EQ(bytes("GI, light at rest"), 75 * 4 + 12) << "the lobe, and what leaves diffusely";
  EXPECT_EQ(bytes("GI, view at rest"), 75 * 4);
}

TEST(DiffuseStudy, ComparesTheRunTimeWithRandomPaths) {
  Mesh mesh = statue(0.0F);
  refine(mesh, 0.06F);
  Scene scene = scene_of(finished(mesh, {0.8F, 0.6F, 0.3F}, Eigen::Vector3f::Zero(), 0.0F), &kShadowed, 32, 4);
  scene.camera.position = {3.0, -4.0, 2.0};
  scene.lights.emplace_back().type = LightType::kCieOvercast;
  const StudyOptions options{
      .vertices = 20, .most_directions = 256, .picture_reference = 64, .bounce_directions = 256, .paths = 512};
  const Study study = run_study(scene, options, [](const Study&) {});
  const StudyPart& part = study.parts.back();
  ASSERT_EQ(part.name, "runtime");
  ASSERT_EQ(part.series.size(), 2U);
  EXPECT_EQ(series_called(part, "DI").points.at(3).error.rms, 0.0) << "it is the reference";
  const double all_bounces = series_called(part, "DI").points.at(3).path_error.value();
  EXPECT_LT(all_bounces, 0.03);
  EXPECT_GT(series_called(part, "DS").points.at(3).path_error.value(), 2.0 * all_bounces);
  ASSERT_EQ(part.table.size(), 2U);
  EXPECT_EQ(part.table[1].shape, "3x25");
}

TEST(GlossyStudy, WritesChartsByTheTool) {
  const TemporaryFolder folder;
  write_all(folder.file("s.json"),
            R"({"meshes": [{"primitive": "torus", "segments": 10, "specular": [0.5, 0.5, 0.5], "exponent": 9}],
                "ground": {"size": 3, "max_edge": 0.2}, "lights": [{"type": "cie_overcast"}], "bake": {"transfer": "glossy_shadowed"}})");
  succeeded({"study", folder.file("s.json"), "--quick", "--out", folder.file("s")});
  const auto json = nlohmann::json::parse(read_all(folder.file("s/study.json")));
  EXPECT_EQ(json["parts"][0]["name"], "runtime");
  EXPECT_EQ(json["parts"][0]["series"][0]["points"][3]["label"], "degree 4");
  EXPECT_TRUE(json["parts"][0]["series"][0]["points"][3]["time"].contains("seconds_of_bake"));
  EXPECT_GT(json["parts"][0]["paths"]["noise"], 0.0);
  EXPECT_EQ(read_all(folder.file("s/table.csv")).find("scene,transfer type,transfer shape,directions,vertices,"), 0U);
  EXPECT_EQ(json["parts"][0]["pictures"][0]["file"], "errors_bounces.png");
  EXPECT_TRUE(std::filesystem::exists(folder.file("s/errors_bounces.png")));
  for (const char* chart : {"s/runtime.svg", "s/runtime_time.svg", "s/runtime_paths.svg", "s/runtime_bake.svg"}) {
    EXPECT_NE(read_all(folder.file(chart)).find("</svg>"), std::string::npos);
  }
}

}  // namespace
}  // namespace sh::prt::test
