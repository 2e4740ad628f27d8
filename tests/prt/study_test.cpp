// The study: the closed answer of the scene `disc`, error and slopes measured against it, and the tool's files.
#include "prt/study/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <tuple>

#include "prt/study/error_picture.hpp"
#include "prt/study/study_setup.hpp"
#include "tests/prt/image_files.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

// The part of the cosine that the disc hides: the form factor of a differential area and a parallel disc [Howell82].
double disc_form_factor(double off_axis, double radius, double height) {
  const double r = radius * radius;
  const double z = off_axis * off_axis + height * height + r;
  return 0.5 * (1.0 - (z - 2.0 * r) / std::sqrt(z * z - 4.0 * r * off_axis * off_axis));
}

TEST(HiddenByDisc, AgreesInBandZeroWithTheFormFactorOfAParallelDisc) {
  double worst = 0.0;
  for (const double height : {0.3, 0.6, 2.0}) {
    for (const double off_axis : {0.0, 0.4, 1.0, 1.7, 8.0}) {
      const double hidden = hidden_by_disc({off_axis, 0.0, 0.0}, 1.0, height, 0).front();
      worst = std::max(worst,
                       std::abs(hidden * std::sqrt(4.0 * std::numbers::pi) - disc_form_factor(off_axis, 1.0, height)));
    }
  }
  EXPECT_LT(worst, 2e-9) << worst;
  EXPECT_NEAR(disc_form_factor(0.0, 1.0, 0.6), 1.0 / 1.36, 1e-15);  // on the axis R^2 / (R^2 + h^2)
}

TEST(FittedSlope, IsThatOfAPowerLawAndOfTheClosedAnswerWhereThereIsOne) {
  std::vector<StudyPoint> points(4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].at = std::ldexp(256.0, static_cast<int>(i));
    points[i].error.rms = 3.0 * std::pow(points[i].at, -0.75);
  }
  EXPECT_NEAR(*fitted_slope(points), -0.75, 1e-12);
  for (StudyPoint& point : points) point.exact_error = RadianceError{std::pow(point.at, -0.5), 1.0, 0};
  EXPECT_NEAR(*fitted_slope(points), -0.5, 1e-12);
  points.resize(1);
  EXPECT_FALSE(fitted_slope(points).has_value());
}

const StudyPart& part_called(const Study& study, const std::string& name) {
  return *std::find_if(study.parts.begin(), study.parts.end(),
                       [&](const StudyPart& part) { return part.name == name; });
}

class DiscStudy : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene = new Scene(load_scene("disc", OnFlaw::kRefuse));
    const StudyOptions options{.vertices = 300, .most_directions = 8192, .bounce_directions = 64, .paths = 64};
    study = new Study(run_study(*scene, options, [](const Study&) {}));
  }
  static void TearDownTestSuite() {
    delete study;
    delete scene;
  }
  static const StudySeries& sampler(Sampler which) {
    return part_called(*study, "directions").series[static_cast<std::size_t>(which)];
  }

  static inline Scene* scene = nullptr;
  static inline Study* study = nullptr;
};

TEST_F(DiscStudy, FindsTheClosedAnswerWithTheReference) {
  ASSERT_TRUE(study->reference_error.has_value());
  EXPECT_LT(study->reference_error->rms, 1.5e-4);  // measured 7e-5: rays start a hair off the ground
}

TEST_F(DiscStudy, MeasuresTheErrorOfTheDefaultAgainstTheClosedAnswer) {
  for (const StudyPoint& point : sampler(Sampler::kFibonacci).points) {
    ASSERT_TRUE(point.exact_error.has_value());
    EXPECT_NEAR(point.exact_error->rms / point.error.rms, 1.0, 0.2) << point.at;
    if (point.at == 2048.0) {
      EXPECT_LT(point.exact_error->rms, 8e-4);
      EXPECT_LT(point.coefficient_error->rms, 1e-3);
      EXPECT_GT(*point.seconds_a_vertex, 0.0);
    }
  }
}

TEST_F(DiscStudy, SeesTheErrorFallAtTheRateOfTheSampler) {
  EXPECT_NEAR(*sampler(Sampler::kRandom).slope, -0.5, 0.2);  // the vertices share few sets: a noisy estimate
  for (const Sampler which : {Sampler::kFibonacci, Sampler::kStratified, Sampler::kSobol, Sampler::kCosine}) {
    EXPECT_NEAR(*sampler(which).slope, -0.75, 0.12) << name_of(which);
    EXPECT_LT(sampler(which).points.back().error.rms, 0.5 * sampler(Sampler::kRandom).points.back().error.rms);
  }
}

TEST_F(DiscStudy, SeesLessErrorTheMoreDegreesThereAre) {
  const std::vector<StudyPoint>& points = part_called(*study, "degrees").series.front().points;
  ASSERT_EQ(points.size(), 11U);
  EXPECT_GT(points[0].error.rms, 0.2);
  EXPECT_LT(points[4].error.rms, 0.01);
  EXPECT_LT(points[10].error.rms, points[4].error.rms);
}

TEST_F(DiscStudy, SeesNoBounceWhereNothingIsSeenFromItsFront) {
  for (const StudyPoint& point : part_called(*study, "bounces").series.front().points) {
    EXPECT_LT(point.error.rms, 1e-12);  // the ground sees the disc from behind, which is black
  }
}

TEST(StudiedVertices, AreEveryKthAndWeighWhatTheCameraSees) {
  const Scene scene = load_scene("disc", OnFlaw::kRefuse);
  const std::size_t count = scene.mesh.positions.size();
  const StudiedVertices some = choose_vertices(scene.mesh, scene.camera, 100);
  EXPECT_EQ(some.step, (count + 50) / 100);
  EXPECT_EQ(some.index[3], 3 * some.step);
  double sum = 0.0;
  for (const double weight : some.weight) sum += weight;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  const StudiedVertices all = choose_vertices(scene.mesh, scene.camera, 10 * count);
  EXPECT_EQ(all.step, 1U);
  EXPECT_EQ(all.index.size(), count);
}

TEST(StudiedVertices, ThatAreClosedHaveTheLightOfABake) {
  Mesh mesh = primitive_mesh("plane");
  refine(mesh, 0.08F);
  append(mesh, primitive_mesh("box", 24, Eigen::Affine3f(Eigen::Scaling(0.5F))));
  Scene scene = scene_of(mesh, &kShadowed, 512, 2);
  scene.lights = {LightSpec{}};
  scene.camera = {{2.0F, 2.0F, 2.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, 40.0F};
  const Transfer baked = bake(scene);
  const StudyOptions options{.vertices = mesh.positions.size() / 3, .most_directions = 512};
  const StudySetup setup(scene, options);
  EXPECT_GT(setup.closed, 10U);
  const TransferRows rows = trace_rows(setup, scene.bake).rows;
  ASSERT_EQ(rows.values.size(), setup.vertices.index.size() * 9);
  for (std::size_t i = 0; i < setup.vertices.index.size(); ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_NEAR(rows.row(i)[k], baked.row(setup.vertices.index[i])[k], 1e-6F) << setup.vertices.index[i];
    }
  }
}

TEST(RadianceErrors, AreRelativeToTheReferenceAndNameTheWorstVertex) {
  const StudiedVertices vertices{1, {5, 9}, {0.75, 0.25}};
  const Radiances reference = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  const Radiances values = {{2.0, 2.0, 2.0}, {2.0, 2.0, 1.0}};
  const RadianceError error = radiance_error(vertices, values, reference);
  EXPECT_NEAR(error.rms, std::sqrt(0.25 / 3.0) / 2.0, 1e-15);
  EXPECT_NEAR(error.largest, 0.5, 1e-15);
  EXPECT_EQ(error.worst_vertex, 9U);
}

TEST(FalseColors, GrowLighterFromTheLeastShownErrorToTheMost) {
  EXPECT_EQ(error_place(0.0), 0.0F);
  EXPECT_EQ(error_place(kLeastShownError), 0.0F);
  EXPECT_NEAR(error_place(1e-2), 0.5F, 1e-6F);
  EXPECT_EQ(error_place(kMostShownError), 1.0F);
  EXPECT_EQ(error_place(1e9), 1.0F);
  EXPECT_EQ(error_place(std::numeric_limits<double>::quiet_NaN()), 1.0F);
  double before = -1.0;
  for (int i = 0; i <= 64; ++i) {
    const numeric::plot::LinearColor c = numeric::plot::decode(false_color(i / 64.0));
    const double luminance = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    EXPECT_GT(luminance, before) << i;
    before = luminance;
  }
}

TEST(VertexErrors, AreTheLargestOfTheChannelsOverTheWholeReference) {
  const Scene scene = load_scene("disc", OnFlaw::kRefuse);
  const Radiances reference(scene.mesh.positions.size(), Eigen::Vector3d::Constant(2.0));
  Radiances values = reference;
  values[7].y() = 3.0;
  const VertexErrors errors = vertex_errors(scene.mesh, scene.camera, values, reference);
  EXPECT_NEAR(errors.relative[7], 0.5F, 1e-6F);
  EXPECT_EQ(errors.relative[8], 0.0F);
  EXPECT_EQ(errors.error.worst_vertex, 7U);
  EXPECT_THROW(vertex_errors(scene.mesh, scene.camera, {}, reference), std::invalid_argument);
}

TEST_F(DiscStudy, SeesStorageCostWhatItRounds) {
  const std::vector<StudySeries>& series = part_called(*study, "storage").series;
  ASSERT_EQ(series.size(), 3U);  // single, half, byte
  for (std::size_t i = 0; i < series[0].points.size(); ++i) {
    EXPECT_EQ(series[0].points[i].coefficient_error->largest, 0.0);
    EXPECT_LT(series[1].points[i].coefficient_error->largest, 2.5e-4);  // 2^-11 of at most 0.3, halved by rounding
    EXPECT_LT(series[2].points[i].coefficient_error->largest, 2e-3);    // half of 1/127 of at most 0.5
    EXPECT_EQ(series[2].points[i].at * 4.0, series[0].points[i].at);
  }
}

// Of the ground: the corners of the disc are those of its model.
TEST_F(DiscStudy, SeesFewerReceiversCostLessWhereAPlanChoosesThem) {
  const StudyPart& part = part_called(*study, "receivers");
  ASSERT_EQ(part.series.size(), 2U);
  const std::vector<StudyPoint>& edges = part.series[0].points;
  const std::vector<StudyPoint>& plans = part.series[1].points;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    EXPECT_LE(edges[i].at, edges[i - 1].at);
    EXPECT_GE(edges[i].error.rms, edges[i - 1].error.rms * 0.99);
    EXPECT_EQ(*edges[i].bytes_a_vertex > 0.0, true);
  }
  for (std::size_t i = 1; i < plans.size(); ++i) EXPECT_GE(plans[i].at, plans[i - 1].at);
  EXPECT_LT(plans.front().at, 0.7 * static_cast<double>(study->vertices));
  const auto better = std::find_if(edges.begin(), edges.end(), [&](const StudyPoint& point) {
    return point.at < plans.front().at && point.error.rms < plans.front().error.rms;
  });
  EXPECT_EQ(better, edges.end()) << "no longer edge has fewer receivers and a smaller error";
}

TEST_F(DiscStudy, SeesWindowsCostSharpness) {
  const std::vector<StudySeries>& series = part_called(*study, "windows").series;
  for (std::size_t w = 1; w < series.size(); ++w) {
    EXPECT_GE(series[w].points[3].error.rms, series[0].points[3].error.rms) << series[w].name;
  }
}

void drop_times(nlohmann::json& json) {
  if (json.is_object()) json.erase("time");
  for (nlohmann::json& part : json) {
    if (part.is_structured()) drop_times(part);
  }
}

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

nlohmann::json study_of(const std::string& scene, const std::string& folder) {
  const Finished run =
      run_prt({"study", scene, "--out", folder, "--quick", "--vertices", "60", "--most-directions", "512"});
  EXPECT_EQ(run.status, 0) << run.err;
  return nlohmann::json::parse(read_all(folder + "/study.json"));
}

TEST(StudyTool, WritesTheSameNumbersTwiceButForTimes) {
  const TemporaryFolder folder;
  nlohmann::json first = study_of("disc", folder.file("a/b"));
  nlohmann::json second = study_of("disc", folder.file("c"));
  EXPECT_EQ(first.at("parts").at(0).at("series").at(0).at("points").size(), 2U);
  EXPECT_TRUE(first.at("parts").at(0).at("series").at(0).at("points").at(0).contains("time"));
  drop_times(first);
  drop_times(second);
  EXPECT_EQ(first, second);
  const std::set<std::string> files = files_in(folder.file("c"));
  EXPECT_TRUE(files.contains("directions.svg") && files.contains("directions_time.svg") &&
              files.contains("degrees.svg") && !files.contains("bounces.svg") && files.contains("study.json") &&
              files.contains("storage.svg") && files.contains("receivers.svg") && files.contains("windows.svg") &&
              files.contains("errors_directions.png") && files.contains("errors_degrees.png") &&
              files.contains("table.csv") && files.contains("table.md"));
  EXPECT_EQ(files, files_in(folder.file("a/b")));
}

TEST(StudyTool, RefusesBadInputInOneLine) {
  const TemporaryFolder folder;
  write_all(folder.file("file"), "text");
  expect_refused({"study", "disc", "--out", folder.file("file")}, folder.file("file"));
  expect_refused({"study", "no_such_scene", "--out", folder.file("x")}, "no_such_scene");
  expect_refused({"study", "disc", "--out", folder.file("x"), "--most-directions", "255"}, "256");
  expect_refused({"study", "disc", "--out", folder.file("x"), "--most-directions", "600000"}, "262144");
  expect_refused({"study", "disc", "--out", folder.file("x"), "--vertices", "0"}, "--vertices");
  expect_refused({"study", "disc"}, "--out");
  write_all(folder.file("mirror.json"), R"({"meshes": [{"primitive": "box", "mirror": [0.5, 0.5, 0.5]}]})");
  expect_refused({"study", folder.file("mirror.json"), "--out", folder.file("x")}, "mirror: has mirrors");
}

TEST(StudyTool, LeavesTheLightOfTheSurfacesThemselvesOut) {
  const TemporaryFolder folder;
  std::vector<nlohmann::json> studies;
  for (const std::string more : {"", R"(, "emission": [9, 9, 9])"}) {
    write_all(folder.file("scene.json"), R"({"meshes": [{"primitive": "torus", "segments": 12, "sides": 2)" + more +
                                             R"(}], "ground": {"max_edge": 1}})");
    drop_times(studies.emplace_back(study_of(folder.file("scene.json"), folder.file("out"))));
  }
  EXPECT_EQ(studies[0], studies[1]);
}

TEST(CompareTool, SaysHowMuchAndWhereTwoBakesDiffer) {
  const TemporaryFolder folder;
  const std::string few = folder.file("few.transfer");
  const std::string many = folder.file("many.transfer");
  ASSERT_EQ(run_prt({"bake", "disc", "-o", few, "--directions", "32", "--degree", "2"}).status, 0);
  ASSERT_EQ(run_prt({"bake", "disc", "-o", many, "--directions", "256", "--degree", "3"}).status, 0);
  const std::vector<std::string> compare = {"compare", few, many, "--scene", "disc"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), compare.begin(), compare.end());
    return run_prt(more);
  };
  const Finished run = with({"-o", folder.file("errors.png"), "--width", "64", "--height", "36", "--samples", "1"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_GT(json.at("relative_rms").get<double>(), 1e-3);
  EXPECT_GT(json.at("relative_largest").get<double>(), json.at("relative_rms").get<double>());
  EXPECT_EQ(read_all(folder.file("errors.png")).substr(1, 3), "PNG");
  EXPECT_EQ(with({"--limit", "0.5"}).status, 0);
  EXPECT_EQ(with({"--limit", "1e-6"}).status, 1);
  const Finished same = run_prt({"compare", many, many, "--limit", "0"});
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_EQ(nlohmann::json::parse(same.out).at("relative_rms"), 0.0);
  ASSERT_EQ(run_prt({"bake", "demo", "-o", few, "--directions", "8", "--degree", "0"}).status, 0);
  expect_refused({"compare", few, many}, "its mesh is not that of");
  write_all(folder.file("text"), "text");
  expect_refused({"compare", few, folder.file("text")}, "one is a transfer file");
  expect_refused({"compare", few, folder.file("nothing")}, "cannot read");
}

TEST(StudyTool, LeavesFinishedFilesWhereItIsInterrupted) {
  const TemporaryFolder folder;
  const Finished run = signal_prt({"study", "demo", "--out", folder.file("x")}, SIGINT,
                                  [&] { return std::filesystem::exists(folder.file("x")); });
  EXPECT_EQ(run.status, 130) << run.err;
  for (const std::string& name : files_in(folder.file("x"))) {
    EXPECT_TRUE(name.ends_with(".svg") || name.ends_with(".json") || name.ends_with(".png")) << name;
  }
}

}  // namespace
}  // namespace sh::prt::test
