// Scene files: their meshes and lights, and messages that name their errors.
#include "prt/scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "prt/mesh/weld.hpp"
#include "prt/scene/scene_parts.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

void expect_start(const std::string& text, const std::string& start) { EXPECT_EQ(text.substr(0, start.size()), start); }

class SceneFile : public testing::Test {
 protected:
  Scene load(const std::string& text) {
    write_all(file_, text);
    return load_scene(file_, OnFlaw::kRefuse);
  }
  // The message without the path of the file before its name.
  std::string refusal(const std::string& text) {
    const std::string said = message_of([&] { load(text); });
    const std::string folder = folder_.file("");
    EXPECT_EQ(said.find(folder), 0U) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said.substr(std::min(folder.size(), said.size()));
  }
  TemporaryFolder folder_;
  std::string file_ = folder_.file("scene.json");
};

TEST_F(SceneFile, MakesPrimitivesWithTransformAlbedoAndEdgeLimit) {
  const Scene scene = load(R"({"name": "crate", "meshes": [{"primitive": "box", "albedo": [0.1, 0.2, 0.3],
    "max_edge": 0.4, "transform": {"scale": [2, 1, 1], "rotate": {"degrees": 90}, "translate": [0, 0, 5]}}]})");
  EXPECT_EQ(scene.name, "crate");
  EXPECT_TRUE(is_closed_surface(scene.mesh));
  EXPECT_LE(longest_edge(scene.mesh), 0.4F);
  EXPECT_NEAR(signed_volume(scene.mesh), 2.0, 1e-5);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : scene.mesh.positions) box.extend(position);
  EXPECT_LT((box.min() - Eigen::Vector3f(-0.5F, -1.0F, 4.5F)).norm(), 1e-6F);
  EXPECT_EQ(scene.mesh.albedo.front(), Eigen::Vector3f(0.1F, 0.2F, 0.3F));
}

TEST_F(SceneFile, FillsInWhatIsLeftOut) {
  const Scene scene = load(R"({"meshes": [{"primitive": "sphere"}]})");
  EXPECT_EQ(scene.name, "scene");
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].type, LightType::kCieOvercast);
  EXPECT_EQ(scene.bake.degree, 4);
  EXPECT_EQ(scene.bake.directions, 2048);
  EXPECT_EQ(scene.bake.kind, &kShadowed);
  EXPECT_GT((scene.camera.position - scene.camera.target).norm(), 1.0);
}

TEST_F(SceneFile, ReadsLightsCameraAndBakeOptions) {
  std::filesystem::create_directory(folder_.path() / "sky");
  write_all(folder_.file("sky/a.exr"), "not loaded yet");
  const Scene scene = load(R"({"meshes": [{"primitive": "plane"}],
    "lights": [{"type": "constant", "radiance": [1, 2, 3]},
               {"type": "environment", "file": "sky/a.exr", "scale": 0.5, "rotate": {"axis": [0, 2, 0], "degrees": 30}}],
    "camera": {"position": [1, 2, 3], "target": [0, 0, 1], "up": [0, 1, 0], "field_of_view": 25},
    "bake": {"degree": 7, "directions": 512, "transfer": "unshadowed"}})");
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].radiance, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(scene.lights[1].file, folder_.file("sky/a.exr"));
  EXPECT_EQ(scene.lights[1].scale, 0.5F);
  EXPECT_EQ(scene.lights[1].rotation_axis, Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(scene.camera.position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scene.camera.target, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(scene.camera.up, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(scene.camera.vertical_field_of_view, 25.0F);
  EXPECT_EQ(scene.bake.degree, 7);
  EXPECT_EQ(scene.bake.directions, 512);
  EXPECT_EQ(scene.bake.kind, &kUnshadowed);
}

TEST_F(SceneFile, PutsGroundJustBelowTheMeshesFineNearThemAndWithoutCracks) {
  const Scene scene = load(R"({"meshes": [{"primitive": "box"}], "ground": {"max_edge": 0.1, "size": 20}})");
  Mesh ground;
  ground.positions = scene.mesh.positions;
  float finest = 1e9F;
  for (const Face& face : scene.mesh.faces) {
    if (scene.mesh.positions[face[0]].z() < -0.5F) {
      ground.faces.push_back(face);
      finest = std::min(finest, (scene.mesh.positions[face[0]] - scene.mesh.positions[face[1]]).norm());
      EXPECT_NEAR(scene.mesh.positions[face[0]].z(), -0.5F, 1e-3F);
    }
  }
  EXPECT_LE(finest, 0.1F);
  EXPECT_GT(longest_edge(ground), 0.5F);
  int borders = 0;
  for (const auto& [edge, faces] : edges_by_position(ground)) {
    EXPECT_LE(faces.first, 1);
    EXPECT_LE(faces.second, 1);
    borders += faces.first + faces.second == 1 ? 1 : 0;
  }
  EXPECT_LT(borders, 400);
  EXPECT_EQ(scene.mesh.remap.size(), make_primitive("box").positions.size());
}

/// Entries of a part of a scene, and the message that refuses them: from the part's path on, or only its beginning.
using Refusals = std::vector<std::pair<std::string, std::string>>;

TEST_F(SceneFile, NamesWhatIsWrongByItsPath) {
  const Refusals cases = {
      {R"("max_edge": "x")", R"(/max_edge: expected a positive number, got "x")"},
      {R"("max_edge": 0)", "/max_edge: expected a positive number, got 0"},
      {R"("albedo": [0.5, 0.5, 1.5])", "/albedo/2: expected three numbers from 0 to 1, got 1.5"},
      {R"("albedo": 0.5)", "/albedo: expected three numbers from 0 to 1, got 0.5"},
      {R"("up": "x")", R"(/up: expected one of y, z, got "x")"},
      {R"("colour": 1)", "/colour: unknown key, expected one of file, "},
      {R"("transform": {"scale": 0})", "/transform/scale: expected factors that are not zero, got 0"},
      {R"("transform": {"rotate": {"axis": [0, 0, 0], "degrees": 1}})",
       "/transform/rotate/axis: expected an axis that is not zero, got [0,0,0]"},
      {R"("transform": {"rotate": {"degrees": 1.5708}})",
       "/transform/rotate/degrees: expected degrees; this looks like 6/12 pi radians, which are 90 degrees"},
      {R"("transform": {"rotate": {"degrees": 1e30}})",
       "/transform/rotate/degrees: expected degrees from -36000 to 36000"},
      {R"("transform": {"rotate": {}})", "/transform/rotate: the key `degrees` is missing"},
      {R"("transform": [])", "/transform: expected an object, got []"},
      {R"("segments": 2.5)", "/segments: expected an integer from 3 to 4096, got 2.5"},
      {R"("file": "a.obj")", ": expected either `file` or `primitive`"}};
  for (const auto& [entries, message] : cases) {
    expect_start(refusal(R"({"meshes": [{"primitive": "box", )" + entries + "}]}"), "scene.json: /meshes/0" + message);
  }
  expect_start(refusal(R"({"meshes": [{"primitive": "box", "max_edge": 1e999}]})"), "scene.json: ");
}

TEST_F(SceneFile, IsRefusedWithAWrongShape) {
  const Refusals cases = {{"[]", "/: expected an object, got []"},
                          {"{}", "/: the key `meshes` is missing"},
                          {R"({"meshes": {}})", "/meshes: expected an array, got {}"},
                          {R"({"meshes": []})", "/meshes: expected at least one mesh, got []"},
                          {R"({"meshes": [3]})", "/meshes/0: expected an object, got 3"},
                          {R"({"meshes": [{"primitive": "cube"}]})", "/meshes/0/primitive: expected one of"},
                          {R"({"meshes": )", "not JSON: parse error"}};
  for (const auto& [text, message] : cases) expect_start(refusal(text), "scene.json: " + message);
}

TEST_F(SceneFile, IsRefusedWithABadLightCameraGroundOrOption) {
  const Refusals cases = {
      {R"("lights": [{"type": "sun"}])",
       "/lights/0/type: expected one of constant, cie_overcast, cie_clear, cie_partly_cloudy, cie_sky, directional, "
       "cap, "
       "sphere, polygon, environment, coefficients, got \"sun\""},
      {R"("lights": [{"type": "environment"}])", "/lights/0: the key `file` is missing"},
      {R"("lights": [{"type": "constant", "radiance": [1, -1, 1]}])",
       "/lights/0/radiance/1: expected three numbers of 0 or more, got -1"},
      {R"("lights": [{"type": "constant", "file": "a.exr"}])", "/lights/0/file: unknown key"},
      {R"("bake": {"degree": 11})", "/bake/degree: expected an integer from 0 to 10, got 11"},
      {R"("bake": {"degree": true})", "/bake/degree: expected an integer from 0 to 10, got true"},
      {R"("bake": {"bounce_directions": 0})", "/bake/bounce_directions: expected an integer from 1 to 1048576, got 0"},
      {R"("bake": {"tolerance": 0})", "/bake/tolerance: expected a number from 1e-9 to 1, got 0"},
      {R"("bake": {"transfer": "glossy"})",
       "/bake/transfer: expected one of unshadowed, shadowed, interreflected, glossy_unshadowed, "
       R"(glossy_shadowed, glossy_interreflected, got "glossy")"},
      {R"("ground": {"size": -1})", "/ground/size: expected a positive number, got -1"},
      {R"("camera": {"field_of_view": 180})", "/camera/field_of_view: expected degrees from 1 to 170, got 180"},
      {R"("camera": {"position": [0, 0, 0], "target": [0, 0, 0]})", "/camera: expected a target"},
      {R"("camera": {"position": [0, 0, 5], "target": [0, 0, 0]})", "/camera: expected a target"},
      {R"("camera": {"position": [1, 0, 5], "target": [1, 0, 0]})", "/camera: expected a target"},
      {R"("camera": {"position": [0, 5, 0], "target": [0, 0, 0], "up": [0, -3, 0]})", "/camera: expected a target"},
      {R"("camera": {"zoom": 2})", "/camera/zoom: unknown key, expected one of position, target"},
      {R"("ground": {"width": 3})", "/ground/width: unknown key, expected one of height, size"},
      {R"("ground": {"size": 1e20})", "/ground/size: expected a length of at most 1.732e+06, a million times"},
      {R"("ground": {"height": -1e20})", "/ground/height: expected a distance from the meshes of at most 1.732e+06"},
      {R"("bake": {"bounces": 3})", "/bake/bounces: unknown key, expected one of degree, directions"},
      {R"("bake": {"compress": 64})", "/bake/compress: expected an object"},
      {R"("bake": {"keep": 3})", "/bake/keep: expected an object"},
      {R"("bake": {"keep": {"rows": 3}})", "/bake/keep/rows: unknown key, expected one of visibility, result, light"},
      {R"("bake": {"keep": {"visibility": 11}})", "/bake/keep/visibility: expected an integer from 0 to 10, got 11"},
      {R"("bake": {"keep": {"result": 6}})", "/bake/keep/result: expected an integer from 0 to 5, got 6"},
      {R"("bake": {"keep": {"light": -1}})", "/bake/keep/light: expected an integer from 0 to 5, got -1"},
      {R"("bake": {"compress": "much"})", "/bake/compress: expected one of auto, got \"much\""},
      {R"("bake": {"compress": {"clusters": 64}})", "/bake/compress: the key `vectors` is missing"},
      {R"("bake": {"compress": {"clusters": 0, "vectors": 8}})",
       "/bake/compress/clusters: expected an integer from 1 to 4096, got 0"},
      {R"("bake": {"compress": {"clusters": 64, "vectors": 65}})",
       "/bake/compress/vectors: expected an integer from 0 to 64, got 65"},
      {R"("bake": {"compress": {"clusters": 64, "vectors": 8, "bits": 8}})", "/bake/compress/bits: unknown key"},
      {R"("bake": {"directions": 0})", "/bake/directions: expected an integer from 1 to "},
      {R"("bake": {"seed": -1})", "/bake/seed: expected an integer from 0 to "},
      {R"("bake": {"tolerance": 1.5})", "/bake/tolerance: expected a number from 1e-9 to 1, got 1.5"},
      {R"("plan": {"budget": 1})", "/plan/budget: unknown key, expected one of error, light_turns, without"},
      {R"("plan": {"error": 0})", "/plan/error: expected a number from 1e-9 to 1, got 0"},
      {R"("plan": {"without": ["rays", "noise"]})", "/plan/without/0: expected one of "},
      {R"("lights": [{"type": "constant", "rotate": {"degrees": 1, "angle": 1}}])",
       "/lights/0/rotate/angle: unknown key, expected one of axis, degrees"},
      {R"("light": [])", "/light: unknown key, expected one of name, meshes"}};
  for (const auto& [entry, message] : cases) {
    expect_start(refusal(R"({"meshes": [{"primitive": "box"}], )" + entry + "}"), "scene.json: " + message);
  }
}

// Powers of two, so that all numbers of one scene are those of the other times the scale.
TEST_F(SceneFile, PutsTheSameGroundUnderMeshesOfAnyScaleAndPlace) {
  const auto scene_of_scale = [&](double scale, const std::string& size) {
    const auto text = [&](double value) { return nlohmann::json(value * scale).dump(); };
    return load(R"({"meshes": [{"primitive": "box", "transform": {"scale": )" + text(1.0) +
                R"(, "translate": [0, 0, )" + text(64.0) + R"(]}}], "ground": {"height": )" + text(63.25) +
                R"(, "size": )" + size + R"(, "max_edge": )" + text(0.5) + "}}");
  };
  const Mesh one = scene_of_scale(1.0, "16").mesh;
  for (const double scale : {0x1p24, 0x1p-24}) {
    const Mesh mesh = scene_of_scale(scale, nlohmann::json(16.0 * scale).dump()).mesh;
    EXPECT_NE(mesh.frame.unit, 1.0);
    ASSERT_EQ(mesh.positions.size(), one.positions.size());
    for (std::size_t v = 0; v < one.positions.size(); ++v) {
      ASSERT_LT((mesh.point(v) / scale - one.point(v)).norm(), 1e-5) << v;
    }
  }
  const Scene fine = load(R"({"meshes": [{"primitive": "box", "transform": {"translate": [0, 0, 64]}}],
    "ground": {"height": 63.25, "size": 16, "max_edge": 0.125}})");
  EXPECT_GT(fine.mesh.positions.size(), one.positions.size()) << "its shortest edges are a quarter as long";
  const std::string said = message_of([&] { scene_of_scale(0x1p24, "1e30"); });
  EXPECT_NE(said.find("expected a length of at most 2.906e+13, a million times the extent"), std::string::npos) << said;
}

// The two numbers of the message `PATH: single precision rounds its positions by up to A, E of its mean edge`.
std::pair<double, double> rounding_in(const std::string& said) {
  const std::string before = "single precision rounds its positions by up to ";
  const std::size_t first = said.find(before);
  EXPECT_NE(first, std::string::npos) << said;
  if (first == std::string::npos) return {};
  return {std::stod(said.substr(first + before.size())), std::stod(said.substr(said.find(", ", first) + 2))};
}

// 2^-24 of the largest coordinate; the mean edge of a triangle with a right angle, and of a box, is (2 + sqrt 2) / 3.
TEST_F(SceneFile, SaysHowMuchSinglePrecisionRoundsItsMeshesAtAnyScale) {
  const double mean_edge = (2.0 + std::sqrt(2.0)) / 3.0;
  constexpr double kPrinted = 0.06;  // two digits
  for (const double scale : {1.0, 0x1p40}) {
    const auto text = [&](double value) { return nlohmann::json(value * scale).dump(); };
    const double far = 40000.0;
    write_all(folder_.file("far.obj"), "v " + text(far) + " 0 0\nv " + text(far + 1.0) + " 0 0\nv " + text(far) + " " +
                                           text(1.0) + " 0\nf 1 2 3\n");
    const std::string file = message_of([&] { load(R"({"meshes": [{"file": "far.obj"}]})"); });
    const auto [in_file, of_edge] = rounding_in(file);
    EXPECT_NEAR(in_file / (0x1p-24 * far * scale), 1.0, kPrinted) << file;
    EXPECT_NEAR(of_edge / (0x1p-24 * far / mean_edge), 1.0, kPrinted) << file;
    EXPECT_NE(file.find("expected a file with its origin near the mesh"), std::string::npos) << file;
    const std::string box = R"({"primitive": "box", "transform": {"scale": )" + text(1.0) + R"(, "translate": [)";
    const std::string apart = message_of(
        [&] { load(R"({"meshes": [)" + box + text(-far) + ", 0, 0]}}, " + box + text(far) + ", 0, 0]}}]}"); });
    const auto [in_scene, of_box] = rounding_in(apart);
    EXPECT_NEAR(in_scene / (0x1p-24 * far * scale), 1.0, kPrinted) << apart;
    EXPECT_NEAR(of_box / (0x1p-24 * far / mean_edge), 1.0, kPrinted) << apart;
    EXPECT_NE(apart.find("expected meshes nearer to each other"), std::string::npos) << apart;
    EXPECT_EQ(message_of([&] { load_scene(file_, OnFlaw::kMend); }), "");
    const auto lost = [&] {
      load(R"({"meshes": [)" + box + text(-1e9) + ", 0, 0]}}, " + box + text(1e9) + ", 0, 0]}}]}");
    };
    EXPECT_NE(message_of(lost), "");
    EXPECT_NE(message_of([&] { load_scene(file_, OnFlaw::kMend); }), "") << "nothing is left of the boxes";
  }
}

// Two triangles that meet at a right angle over the edge from (0, 0, 0) to (0, 2, 0).
TEST_F(SceneFile, StandsFilesUprightAndRoundsEdgesBelowTheCrease) {
  write_all(folder_.file("a.obj"), "v 0 0 0\nv 0 2 0\nv 3 0 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\n");
  const auto mesh = [&](const std::string& more) {
    return load(R"({"meshes": [{"file": "a.obj")" + more + "}]}").mesh;
  };
  const auto corner = [](const Mesh& m) {
    return Eigen::Vector3d(m.point(m.faces[0][0]) + m.point(m.faces[0][1]) + m.point(m.faces[0][2]));
  };
  EXPECT_EQ(corner(mesh("")), Eigen::Vector3d(3, 0, 2)) << "OBJ files have y up";
  EXPECT_EQ(corner(mesh(R"(, "up": "y")")), Eigen::Vector3d(3, 0, 2));
  EXPECT_EQ(corner(mesh(R"(, "up": "z")")), Eigen::Vector3d(3, 2, 0));
  EXPECT_EQ(mesh("").positions.size(), 6U) << "40 degrees";
  EXPECT_EQ(mesh(R"(, "crease": 89)").positions.size(), 6U);
  EXPECT_EQ(mesh(R"(, "crease": 91)").positions.size(), 4U);
  EXPECT_EQ(refusal(R"({"meshes": [{"file": "a.obj", "crease": 181}]})"),
            "scene.json: /meshes/0/crease: expected degrees from 0 to 180, got 181");
}

TEST_F(SceneFile, ReadsAShapeOnceHoweverOftenItStands) {
  write_all(folder_.file("a.obj"), "v 0 0 0\nv 0 2 0\nv 3 0 0\nf 1 3 2\n");
  const std::string one = R"({"file": "a.obj")";
  const std::vector<std::string> entries = {one + R"(, "flip": true, "transform": {"scale": [1, -2, 1]}})",
                                            one + R"(, "albedo": [0.25, 0.5, 0.75]})",
                                            one + R"(, "max_edge": 1, "crease": 10, "up": "z"})", one + "}"};
  Mesh apart;
  std::string all;
  for (const std::string& entry : entries) {
    append(apart, load(R"({"meshes": [)" + entry + "]}").mesh);
    all += (all.empty() ? "" : ", ") + entry;
  }
  const Mesh mesh = load(R"({"meshes": [)" + all + "]}").mesh;
  EXPECT_EQ(mesh.positions, apart.positions);
  EXPECT_EQ(mesh.albedo, apart.albedo);
  EXPECT_EQ(mesh.normals, apart.normals);
  EXPECT_EQ(mesh.faces, apart.faces);
  const nlohmann::json document = read_json(file_);
  const JsonReader meshes = JsonReader(file_, document).at("meshes");
  Shapes shapes(meshes);
  const std::vector<JsonReader> readers = meshes.items();
  const auto taken = [&](std::size_t entry) {
    return shapes.take(readers[entry], folder_.file(""), OnFlaw::kRefuse).soup;
  };
  const Soup first = taken(0);
  std::filesystem::remove(folder_.file("a.obj"));
  EXPECT_EQ(taken(2).positions, first.positions);
  EXPECT_EQ(taken(3).positions, first.positions);
  EXPECT_THROW(taken(1), std::runtime_error) << "another material";
}

TEST_F(SceneFile, IsRefusedWithNormalsOfNoLength) {
  write_all(folder_.file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 0 -1\nvn 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//2\n");
  expect_start(refusal(R"({"meshes": [{"file": "a.obj"}]})"),
               "a.obj: 1 vertex normals are zero or not finite (made from the faces); refused");
}

TEST_F(SceneFile, HalvesTheSameEdgesAtAnyScale) {
  const auto faces = [&](double scale) {
    const auto text = [&](double value) { return nlohmann::json(value * scale).dump(); };
    return load(R"({"meshes": [{"primitive": "box", "transform": {"scale": )" + text(1.0) + R"(}, "max_edge": )" +
                text(0.3) + "}]}")
        .mesh.faces;
  };
  EXPECT_GT(faces(1.0).size(), 100U);
  EXPECT_EQ(faces(0x1p40), faces(1.0));
  EXPECT_EQ(faces(0x1p-40), faces(1.0));
}

TEST_F(SceneFile, TakesEveryLimitOfItsOptions) {
  for (const char* entry :
       {R"("ground": {"size": 1.7e6})", R"("ground": {"height": -1.7e6})", R"("bake": {"degree": 0})",
        R"("bake": {"degree": 10})",
        R"("bake": {"directions": 1, "bounce_directions": 1048576, "seed": 0, "tolerance": 1})",
        R"("bake": {"compress": {"clusters": 1, "vectors": 0}})",
        R"("bake": {"compress": {"clusters": 4096, "vectors": 64}})", R"("camera": {"field_of_view": 1})",
        R"("camera": {"field_of_view": 170})", R"("plan": {"error": 1})", R"("plan": {"without": []})"}) {
    EXPECT_NO_THROW(load(R"({"meshes": [{"primitive": "box"}], )" + std::string(entry) + "}")) << entry;
  }
}

TEST_F(SceneFile, NamesTheBandsToKeep) {
  const std::string start = R"({"meshes": [{"primitive": "plane"}])";
  EXPECT_EQ(load(start + "}").bake.keep, KeptBands());
  const auto kept = [&](const std::string& keep) {
    return load(start + R"(, "bake": {"keep": )" + keep + "}}").bake.keep;
  };
  EXPECT_EQ(kept("{}"), KeptBands());
  EXPECT_EQ(kept(R"({"visibility": 6, "result": 4, "light": 2})"), (KeptBands{6, 4, 2}));
  EXPECT_EQ(kept(R"({"light": 0})"), (KeptBands{2 * kMaxDegree, kMaxDegree, 0}));
}

TEST_F(SceneFile, PlansExactlyUnlessItSaysMore) {
  const std::string start = R"({"meshes": [{"primitive": "plane"}])";
  EXPECT_EQ(load(start + "}").plan.mode, PlanMode::kExact);
  const PlanOptions plan =
      load(start + R"(, "plan": {"error": 0.25, "light_turns": "about_z", "without": ["storage"]}})").plan;
  EXPECT_EQ(plan.mode, PlanMode::kLossy);
  EXPECT_EQ(plan.error, 0.25);
  EXPECT_EQ(plan.turns, LightTurns::kAboutZ);
  EXPECT_EQ(plan.without, std::vector<std::string>{"storage"});
}

TEST_F(SceneFile, ListsTheFilesThatItReads) {
  std::filesystem::create_directory(folder_.path() / "in");
  write_all(folder_.file("in/a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_all(folder_.file("b.exr"), "not loaded yet");
  const Scene scene = load(R"({"meshes": [{"primitive": "plane"}, {"file": "in/../in/a.obj"}],
    "lights": [{"type": "constant"}, {"type": "environment", "file": "b.exr"}]})");
  EXPECT_EQ(scene.files, (std::vector<std::string>{file_, folder_.file("in/a.obj"), folder_.file("b.exr")}));
  const Scene alone = load_scene(folder_.file("in/a.obj"), OnFlaw::kMend);
  EXPECT_EQ(alone.name, "a");
  EXPECT_GT(alone.mesh.faces.size(), 1U) << "a ground is around it";
}

TEST_F(SceneFile, ReadsEveryKindOfLight) {
  const Scene scene = load(R"({"meshes": [{"primitive": "plane"}], "lights": [
    {"type": "directional", "direction": [0, 3, 4], "irradiance": [1, 2, 3], "rotate": {"degrees": 90}},
    {"type": "cap", "direction": {"elevation": 30, "azimuth": 90}, "half_angle": 60, "irradiance": [3, 3, 3]},
    {"type": "sphere", "position": [0, 0, 3], "from": [0, 0, 1], "radius": 1},
    {"type": "cie_clear", "sun": {"elevation": 0}},
    {"type": "cie_partly_cloudy", "sun": {"elevation": 90, "azimuth": -20}},
    {"type": "cie_sky", "sky": 15, "sun": [1, 0, 1]},
    {"type": "polygon", "corners": [[-1, -1, 2], [-1, 1, 2], [1, 1, 2], [1, -1, 2]], "from": [0, 0, 1]}]})");
  ASSERT_EQ(scene.lights.size(), 7U);
  EXPECT_LT((scene.lights[0].direction - Eigen::Vector3d(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(scene.lights[0].rotation_degrees, 90.0F);
  EXPECT_LT((scene.lights[1].direction - Eigen::Vector3d(0, std::sqrt(0.75), 0.5)).norm(), 1e-15);
  EXPECT_NEAR(scene.lights[1].one_minus_cos, 0.5, 1e-15);
  EXPECT_NEAR(scene.lights[1].radiance.x(), 4.0F / std::numbers::pi_v<float>, 1e-6F);  // 3 / (pi sin^2 60)
  EXPECT_EQ(scene.lights[2].type, LightType::kCap);
  EXPECT_NEAR(scene.lights[2].one_minus_cos, 1.0 - std::sqrt(0.75), 1e-15);
  EXPECT_EQ(scene.lights[3].sky, 12);
  EXPECT_EQ(scene.lights[4].sky, 7);
  EXPECT_EQ(scene.lights[5].sky, 15);
  EXPECT_EQ(scene.lights[6].corners[0], Eigen::Vector3d(-1, -1, 1));
}

TEST_F(SceneFile, RefusesLightsThatCannotBe) {
  const Refusals cases = {
      {R"("cap", "direction": [0, 0, 1], "half_angle": 0)", "/half_angle: expected degrees from 1e-09 to 180, got 0"},
      {R"("cap", "direction": [0, 0, 1], "half_angle": 181)",
       "/half_angle: expected degrees from 1e-09 to 180, got 181"},
      {R"("cap", "direction": [0, 0, 0], "half_angle": 1)",
       "/direction: expected a direction that is not zero, got [0,0,0]"},
      {R"("cap", "direction": {"elevation": 91}, "half_angle": 1)",
       "/direction/elevation: expected degrees from -90 to 90, got 91"},
      {R"("cap", "direction": [0, 0, 1], "half_angle": 1e-9, "irradiance": [1e38, 0, 0])",
       "/irradiance: expected an irradiance whose radiance stays below 3.4e38, got [1e+38,0,0]"},
      {R"("cie_clear", "sun": {"elevation": -3})",
       R"(/sun: expected a sun that is not below the horizon, got {"elevation":-3})"},
      {R"("cie_clear")", ": the key `sun` is missing"},
      {R"("cie_sky", "sky": 16, "sun": [0, 0, 1])", "/sky: expected an integer from 1 to 15, got 16"},
      {R"("sphere", "position": [0, 0, 1], "radius": 2)",
       "/position: expected a position farther than the radius from where the sphere is seen, got [0,0,1]"},
      {R"("sphere", "position": [0, 0, 1], "radius": -1)", "/radius: expected a positive number, got -1"},
      {R"("polygon", "corners": [[0, 0, 1], [0, 1, 1]])",
       "/corners: expected 3 to 1000 corners, got [[0,0,1],[0,1,1]]"},
      {R"("polygon", "corners": [[0, 0, 1], [1, 0, 1], [1, 1, 1]])", "/corners: expected corne"},
      {R"("environment", "file": "a.exr", "mapping": "cube")",
       "/mapping: expected one of lat_long, angular_map, mirror_ball, horizontal_cross, vertical_cross, cube_strip, "
       "got "
       "\"cube\""},
      {R"("directional", "direction": [0, 0, 1], "radiance": [1, 1, 1])", "/radiance: unknown"}};
  for (const auto& [type, message] : cases) {
    expect_start(refusal(R"({"meshes": [{"primitive": "box"}], "lights": [{"type": )" + type + "}]}"),
                 "scene.json: /lights/0" + message);
  }
}

TEST_F(SceneFile, IsRefusedWhenMissing) {
  EXPECT_EQ(message_of([] { load_scene("/nowhere/scene.json", OnFlaw::kMend); }),
            "/nowhere/scene.json: cannot read: No such file or directory");
}

TEST(EmbeddedScene, IsLargeEnoughHasNoFlawsAndStandsOnGround) {
  const Scene scene = load_scene("demo", OnFlaw::kRefuse);
  EXPECT_GT(scene.mesh.positions.size(), 20000U);
  EXPECT_LT(scene.mesh.positions.size(), 60000U);
  float lowest = 1.0F;
  for (const Eigen::Vector3f& position : scene.mesh.positions) lowest = std::min(lowest, position.z());
  EXPECT_EQ(lowest, 0.0F);
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].type, LightType::kCieOvercast);
}

}  // namespace
}  // namespace sh::prt::test
