// `prt plan -o FILE`, and what follows the file: the bytes of a bake that plans itself; other meshes, other lights and
// changed files are refused.
#include "prt/plan/plan_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "prt/mesh/mesh_checksum.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

using Json = nlohmann::json;

// Options of a plan that chooses counts of clusters.
const Arguments kClustered = {
    "--error", "0.3", "--without", "bands,symmetry,storage", "--kind", "interreflected", "--compress-auto"};

class PlanFile : public testing::Test {
 protected:
  void SetUp() override { write_all(scene_, text()); }
  // A torus over stairs, whose entry holds `torus`, beside more entries of the scene.
  static std::string text(const std::string& torus = R"("albedo": [0.5, 0.5, 0.5])", const std::string& more = {}) {
    return R"({"meshes": [{"primitive": "stairs", "max_edge": 0.25},
        {"primitive": "torus", "segments": 10, "transform": {"translate": [0, 0, 0.9]}, )" +
           torus + "}]" + more + "}";
  }
  void plan(const Arguments& options) {
    succeeded(joined({"plan", scene_, "--degree", "2", "--directions", "256", "-o", plan_}, options));
  }
  [[nodiscard]] Arguments bake() const { return {"bake", scene_, "--plan", plan_, "-o", out_}; }
  void expect_no_bake(const std::string& reason) {
    expect_refused(bake(), reason);
    EXPECT_FALSE(std::filesystem::exists(out_));
  }
  [[nodiscard]] Json held() const { return Json::parse(read_all(plan_)); }

  TemporaryFolder folder_;
  const std::string scene_ = folder_.file("scene.json");
  const std::string plan_ = folder_.file("plan.json");
  const std::string out_ = folder_.file("out.transfer");
};

TEST_F(PlanFile, GivesTheBytesOfTheBakeThatPlansItself) {
  const std::string whole = folder_.file("whole.transfer");
  const std::pair<const char*, Arguments> cases[] = {
      {"", {"--plan", "none"}},
      {"", {"--plan", "exact", "--kind", "interreflected"}},
      {"", {"--plan", "lossy", "--error", "0.05"}},
      {"", {"--plan", "lossy", "--error", "0.3", "--light-turns", "none"}},
      {"", {"--plan", "lossy", "--error", "0.05", "--without", "bands,symmetry", "--sampler", "sobol", "--seed", "7"}},
      {"", {"--plan", "lossy", "--error", "0.1", "--kind", "interreflected"}},
      {"", kClustered},
      {"", {"--plan", "exact", "--compress", "6", "2"}},
      {R"("mirror": [0.2, 0.4, 0.6])", {"--plan", "lossy", "--error", "0.1", "--kind", "interreflected"}},
      {R"("emission": [1, 2, 3])", {"--plan", "exact", "--kind", "interreflected"}},
      {R"("specular": [0.3, 0.3, 0.3], "exponent": 20)",
       {"--plan", "lossy", "--error", "0.2", "--kind", "glossy_shadowed"}},
      {R"("metallic": 0.5, "roughness": 0.5)", {"--plan", "exact", "--kind", "glossy_shadowed", "--fit-lobes"}},
      {"", {"--plan", "lossy", "--error", "0.2", "--kind", "glossy_interreflected"}}};
  for (const auto& [torus, options] : cases) {
    if (*torus != '\0') write_all(scene_, text(torus));
    succeeded(joined({"bake", scene_, "--degree", "2", "--directions", "256", "-o", whole}, options));
    plan(options);
    succeeded(bake());
    EXPECT_TRUE(read_all(out_) == read_all(whole)) << torus << " " << Json(options).dump();
  }
}

// The decisions that hold numbers of their own: bytes and the largest numbers, clusters and their lights, open vertices.
TEST_F(PlanFile, HoldsWhatABakeNeeds) {
  plan({"--error", "0.3"});
  EXPECT_EQ(held()["storage"]["element"], "byte");
  EXPECT_FALSE(held()["largest"].empty());
  plan(kClustered);
  EXPECT_FALSE(held()["clusters"].empty());
  EXPECT_FALSE(held()["lights"].empty());
  EXPECT_EQ(held()["light"].size(), 363U);
  EXPECT_EQ(held()["bake"]["compress"], "auto");
  plan({"--plan", "exact"});
  EXPECT_FALSE(held()["open"].empty());
  EXPECT_FALSE(held().contains("light")) << "an exact plan holds under any light";
}

TEST_F(PlanFile, IsPrintedAsItWasMade) {
  const Arguments options = {"plan", scene_, "--degree", "2", "--directions", "256", "--error", "0.1"};
  const std::string table = succeeded(joined(options, {"-o", plan_})).out;
  EXPECT_EQ(succeeded({"plan", scene_, "--plan", plan_}).out, table);
  EXPECT_EQ(printed({"plan", scene_, "--plan", plan_, "--json"}), printed(joined(options, {"--json"})));
  const std::string copy = folder_.file("copy.json");
  succeeded({"plan", scene_, "--plan", plan_, "-o", copy});
  EXPECT_EQ(read_all(copy), read_all(plan_));
}

TEST_F(PlanFile, MayBeLaidOutOtherwise) {
  plan({"--error", "0.1"});
  succeeded(bake());
  const std::string first = read_all(out_);
  write_all(plan_, held().dump(4));  // sorts the keys, too
  succeeded(bake());
  EXPECT_TRUE(read_all(out_) == first);
}

TEST_F(PlanFile, ServesNoOtherMesh) {
  plan({"--plan", "exact"});
  for (const char* other :
       {R"("albedo": [0.5, 0.5, 0.6])", R"("emission": [0, 0, 1e-9])", R"("mirror": [0.1, 0.1, 0.1])", R"("texels": 4)",
        R"("specular": [0.3, 0.3, 0.3], "exponent": 20)"}) {
    write_all(scene_, text(other));
    expect_no_bake("plan.json: a plan for another mesh than that of scene");
  }
  write_all(scene_, text(R"("albedo": [0.5, 0.5, 0.5])", R"(, "camera": {"position": [3, 3, 3]})"));
  succeeded(bake());
}

TEST_F(PlanFile, WithAnErrorServesNoOtherLights) {
  const std::string sun = R"(, "lights": [{"type": "directional", "direction": [0, 1, 1]}])";
  plan({"--error", "0.1"});
  write_all(scene_, text(R"("albedo": [0.5, 0.5, 0.5])", sun));
  expect_no_bake("plan.json: its errors hold for other lights than those of scene");
  write_all(scene_, text());
  plan({"--plan", "exact"});
  write_all(scene_, text(R"("albedo": [0.5, 0.5, 0.5])", sun));
  succeeded(bake());
}

TEST_F(PlanFile, ThatIsChangedIsRefused) {
  plan({"--error", "0.1"});
  const std::string good = read_all(plan_);
  const auto expect_damaged = [&](const Json& json, const std::string& reason) {
    write_all(plan_, json.dump());
    expect_no_bake(reason);
  };
  for (const char* key : {"bake", "storage", "open", "decisions", "mesh", "light", "lights", "largest", "budget"}) {
    Json json = Json::parse(good);
    json[key] = json[key].is_string() ? Json("x") : Json(7);
    expect_damaged(json, "plan.json: damaged or edited; expected a file that `prt plan -o` made");
    json = Json::parse(good);
    json.erase(key);
    if (json != Json::parse(good)) expect_damaged(json, "damaged or edited");
  }
  Json json = Json::parse(good);
  json["shforge_plan"] = 2;
  expect_damaged(json, "plan.json: a plan of version 2, not 1");
  json.erase("shforge_plan");
  expect_damaged(json, "plan.json: no plan; expected a file");
  expect_damaged(Json::array(), "plan.json: no plan");
  write_all(plan_, good.substr(0, good.size() / 2));
  expect_no_bake("plan.json: not JSON");
  write_all(plan_, "");
  expect_no_bake("plan.json: not JSON");
}

TEST_F(PlanFile, HoldsAllOptionsOfABake) {
  plan({"--plan", "exact"});
  for (const Arguments& option :
       {Arguments{"--degree", "2"}, Arguments{"--directions", "256"}, Arguments{"--error", "1"},
        Arguments{"--kind", "shadowed"}, Arguments{"--without", "bands"}, Arguments{"--sampler", "sobol"},
        Arguments{"--seed", "0"}, Arguments{"--fit-lobes"}, Arguments{"--light-turns", "any"},
        Arguments{"--compress", "0", "0"}}) {
    expect_refused(joined(bake(), option), option[0] + ": " + plan_ + " has decided it");
  }
  expect_refused({"bake", scene_, "--plan", "loss", "-o", out_},
                 "--plan loss: no such file; expected none, exact, lossy or a file that `prt plan -o` made");
  expect_refused({"bake", scene_, "--plan", plan_, "-o", plan_}, "plan.json");
  expect_refused({"plan", scene_, "-o", scene_}, "scene.json");
  EXPECT_EQ(read_all(scene_), text());
}

TEST(MeshChecksums, TellEveryChangeAndWhetherRaysSeeIt) {
  Mesh mesh = primitive_mesh("box", 4);
  mesh.brdfs.rows = {1.0F, 2.0F};
  mesh.normal_maps.texels = {Eigen::half(1.0F), Eigen::half(0.5F)};
  mesh.albedo_maps.bytes = {1, 2};
  mesh.atlases.reach = {1.0F};
  const std::size_t count = mesh.positions.size();
  for (auto* values : {&mesh.emission, &mesh.mirror, &mesh.specular, &mesh.tint}) {
    values->assign(count, Eigen::Vector3f::Zero());
  }
  for (auto* values : {&mesh.texture, &mesh.chart}) values->assign(count, Eigen::Vector2f::Zero());
  for (auto* values : {&mesh.brdf, &mesh.normal_map, &mesh.albedo_map, &mesh.atlas}) values->assign(count, 0);
  mesh.exponent.assign(count, 0.0F);
  mesh.nodes = {{"box", "", Eigen::Affine3d::Identity(), {{0, 2}, {4, 2}}}};
  const MeshChecksums whole = checksums_of(mesh);
  EXPECT_EQ(whole.rays.size(), 16U);
  EXPECT_EQ(whole.whole.size(), 16U);
  const auto expect_told = [&](const char* what, bool rays, const std::function<void(Mesh&)>& change) {
    Mesh other = mesh;
    change(other);
    EXPECT_NE(checksums_of(other).whole, whole.whole) << what;
    EXPECT_EQ(checksums_of(other).rays != whole.rays, rays) << what;
  };
  const auto longer = [](Eigen::Vector3f& v) { v *= 1.5F; };
  expect_told("positions", true, [&](Mesh& m) { longer(m.positions.back()); });
  expect_told("normals", true, [&](Mesh& m) { longer(m.normals.back()); });
  expect_told("geometric normals", true, [&](Mesh& m) { longer(m.geometric_normals.back()); });
  expect_told("the map of a node", true, [](Mesh& m) { m.nodes.back().to_world.translate(Eigen::Vector3d::UnitX()); });
  expect_told("the faces of a node", true, [](Mesh& m) { m.nodes.back().faces.back()[1] = 3; });
  expect_told("the runs of a node", true, [](Mesh& m) { m.nodes.back().faces.pop_back(); });
  expect_told("the nodes", true, [](Mesh& m) { m.nodes.clear(); });
  expect_told("mirror", true, [](Mesh& m) { m.mirror.back().x() = 0.5F; });
  expect_told("faces", true, [](Mesh& m) { std::swap(m.faces.back()[0], m.faces.back()[1]); });
  expect_told("reach of texels", true, [](Mesh& m) { m.atlases.reach[0] = 2.0F; });
  expect_told("albedo", false, [](Mesh& m) { m.albedo.back().x() = 0.125F; });
  expect_told("emission", false, [](Mesh& m) { m.emission.back().x() = 0.5F; });
  expect_told("specular", false, [](Mesh& m) { m.specular.back().x() = 0.5F; });
  expect_told("tint", false, [](Mesh& m) { m.tint.back().x() = 0.5F; });
  expect_told("exponent", false, [](Mesh& m) { m.exponent.back() = 1.0F; });
  expect_told("BRDF", false, [](Mesh& m) { m.brdf.back() = 1; });
  expect_told("texture", false, [](Mesh& m) { m.texture.back().x() = 1.0F; });
  expect_told("normal map", false, [](Mesh& m) { m.normal_map.back() = 1; });
  expect_told("albedo map", false, [](Mesh& m) { m.albedo_map.back() = 1; });
  expect_told("chart", false, [](Mesh& m) { m.chart.back().x() = 1.0F; });
  expect_told("atlas", false, [](Mesh& m) { m.atlas.back() = 1; });
  expect_told("tables", false, [](Mesh& m) { m.brdfs.rows[1] = 3.0F; });
  expect_told("normals of a map", false, [](Mesh& m) { m.normal_maps.texels[1] = Eigen::half(0.25F); });
  expect_told("a picture", false, [](Mesh& m) { m.albedo_maps.bytes[1] = 3; });
  expect_told("the frame", false, [](Mesh& m) { m.frame.unit = 2.0; });
}

// Plans of which every number is set, written and read without the tool.
class KeptPlan : public testing::Test {
 protected:
  void SetUp() override {
    scene_.name = "hall";
    scene_.mesh = primitive_mesh("box", 4);
    scene_.lights.assign(30, LightSpec());  // whose largest number is not about 1
    scene_.bake.degree = 2;
    scene_.bake.directions = 77;
    scene_.bake.sampler = Sampler::kSobol;
    scene_.bake.seed = 5;
    scene_.bake.kind = &kInterreflected;
    scene_.bake.bounces.tolerance = 0.0123;
    scene_.bake.bounces.directions = 33;
    scene_.bake.compress_by_plan = true;
    plan_.record = {0.05, 0.0123, "any", {{"clusters", "some", "why", 12, -34, 0.002, "bound"}}};
    plan_.open.assign(scene_.mesh.positions.size(), 0);
    for (const std::size_t v : {0U, 1U, 5U}) plan_.open[v] = 1;
    plan_.open.back() = 1;
    plan_.storage.element = Element::kByte;
    plan_.storage.kept = {0, 2, 6};
    plan_.largest = {1.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 1e-9F};
    plan_.clusters = {{1, 0}, {kMostClusters, kMostVectors}};
    plan_.lights = {LightCoefficients::zero(2), LightCoefficients::zero(3)};
    plan_.lights[1].at(2, 15) = 1.0 / 3.0;
    plan_.known_by = "measured";
    plan_.reference = 2.5;
    plan_.beyond = 0.25;
    plan_.asked = {4000, 8000};
    plan_.planned = {1000, 6000};
  }
  Scene write() {
    write_plan(file_, plan_, scene_, checksums_of(scene_.mesh).whole);
    Scene other = scene_;
    other.bake = {};
    other.plan = {};
    return other;
  }
  // The line with which a file of this text is refused; empty if it is not.
  std::string refusal_of(const std::string& text) {
    Scene other = scene_;
    write_all(file_, text);
    try {
      static_cast<void>(read_plan(file_, other));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  // The same after such a change, with a checksum that is right.
  std::string refusal(const std::function<void(Json&)>& change) {
    static_cast<void>(write());
    Json json = Json::parse(read_all(file_));
    change(json);
    json["checksum"] = plan_checksum(json);
    return refusal_of(json.dump());
  }

  TemporaryFolder folder_;
  const std::string file_ = folder_.file("plan.json");
  Scene scene_;
  Plan plan_;
};

TEST_F(KeptPlan, HasEveryNumberOfThePlanAndOfTheBake) {
  Scene other = write();
  const Plan read = read_plan(file_, other);
  EXPECT_EQ(other.bake.degree, 2);
  EXPECT_EQ(other.bake.directions, 77);
  EXPECT_EQ(other.bake.sampler, Sampler::kSobol);
  EXPECT_EQ(other.bake.seed, 5U);
  EXPECT_EQ(other.bake.kind, &kInterreflected);
  EXPECT_EQ(other.bake.bounces.tolerance, 0.0123);
  EXPECT_EQ(other.bake.bounces.directions, 33);
  EXPECT_TRUE(other.bake.compress_by_plan);
  EXPECT_EQ(other.plan.mode, PlanMode::kLossy);
  EXPECT_EQ(plan_json(read, other), plan_json(plan_, scene_));
  EXPECT_TRUE(read.open == plan_.open);
  EXPECT_TRUE(read.storage.kept == plan_.storage.kept);
  EXPECT_TRUE(read.largest == plan_.largest);
  ASSERT_EQ(read.clusters.size(), 2U);
  EXPECT_EQ(read.clusters[0].clusters, 1U);
  EXPECT_EQ(read.clusters[1].vectors, kMostVectors);
  ASSERT_EQ(read.lights.size(), 2U);
  EXPECT_EQ(read.lights[1].degree, 3);
  EXPECT_TRUE(read.lights[1].values == plan_.lights[1].values);
  EXPECT_EQ(read.known_by, "measured");
  EXPECT_EQ(read.reference, 2.5);
}

TEST_F(KeptPlan, WithoutAnErrorSaysSoAndHasNoLight) {
  plan_.record.budget = 0.0;
  plan_.known_by.clear();
  plan_.open.clear();
  scene_.bake.compress_by_plan = false;
  scene_.bake.compress = {7, 3};
  Scene other = write();
  other.lights = {};
  const Plan read = read_plan(file_, other);
  EXPECT_EQ(other.plan.mode, PlanMode::kExact);
  EXPECT_EQ(other.bake.compress.clusters, 7U);
  EXPECT_EQ(other.bake.compress.vectors, 3U);
  EXPECT_FALSE(other.bake.compress_by_plan);
  EXPECT_TRUE(read.open.empty());
  EXPECT_TRUE(read.known_by.empty());
}

TEST_F(KeptPlan, OfGlossyTransferHasTheBandsToKeep) {
  plan_ = {};
  scene_.bake.kind = &kGlossyInterreflected;
  scene_.bake.compress_by_plan = false;
  scene_.bake.keep = {3, 1, 2};
  Scene other = write();
  static_cast<void>(read_plan(file_, other));
  EXPECT_EQ(other.bake.kind, &kGlossyInterreflected);
  EXPECT_EQ(other.bake.keep, scene_.bake.keep);
  EXPECT_EQ(other.bake.compress.clusters, 0U);
  EXPECT_FALSE(other.bake.compress_by_plan);
}

TEST_F(KeptPlan, RefusesNumbersThatNoPlanHas) {
  const std::string damaged = file_ + ": damaged";
  const std::size_t vertices = scene_.mesh.positions.size();
  const std::pair<std::string, std::function<void(Json&)>> cases[] = {
      {" (vertices that the mesh does not have)",
       [&](Json& json) {
         json["open"] = {{0, vertices + 1}};
       }},
      {" (vertices that the mesh does not have)",
       [](Json& json) {
         json["open"] = {{3, 2}};
       }},
      {" (a light of no degree)",
       [](Json& json) {
         json["lights"] = {{1, 2, 3, 4}};
       }},
      {" (a light of no degree)", [](Json& json) { json["lights"] = {std::vector<int>(3 * 144)}; }},
      {" (a light of no degree)", [](Json& json) { json["lights"] = {std::vector<int>(3 * 4)}; }},
      {" (counts of no clusters)",
       [](Json& json) {
         json["clusters"] = {{0, 1}};
       }},
      {" (counts of no clusters)",
       [](Json& json) {
         json["clusters"] = {{kMostClusters + 1, 1}};
       }},
      {" (counts of no clusters)",
       [](Json& json) {
         json["clusters"] = {{1, kMostVectors + 1}};
       }},
      {" (clusters without a decision)", [](Json& json) { json["decisions"][0]["name"] = "bands"; }},
      {" (clusters without a decision)", [](Json& json) { json["reference_radiance"] = 0; }},
      {" (bytes of another count of numbers)",
       [](Json& json) {
         json["largest"] = {1, 2};
       }},
      {" (a plan with 1e+67, expected a whole number", [](Json& json) { json["bytes"]["asked"] = 1e67; }},
      {" (a plan with -1, expected a whole number", [](Json& json) { json["rays"]["planned"] = -1; }},
      {" (a plan with 0.5, expected a whole number",
       [](Json& json) {
         json["open"] = {{0.5, 2}};
       }},
      {" (a plan with 4294967296, expected a whole number",
       [](Json& json) {
         json["clusters"] = {{4294967296, 1}};
       }},
      {"; expected a file", [](Json& json) { json.erase("storage"); }},
      {"; expected a file", [](Json& json) { json["largest"] = "x"; }}};
  for (const auto& [reason, change] : cases) {
    EXPECT_TRUE(refusal(change).starts_with(damaged + reason)) << reason << ": " << refusal(change);
  }
  EXPECT_EQ(refusal([&](Json& json) { json["open"] = {{0, vertices}, {2, 2}}; }), "");
  EXPECT_EQ(refusal([](Json& json) { json["lights"] = {std::vector<int>(3 * 121), std::vector<int>(3 * 9)}; }), "");
}

TEST_F(KeptPlan, RefusesWhatIsNoPlanForThisMesh) {
  for (const char* text : {"[]", "7", "{}", R"("shforge_plan")"}) {
    EXPECT_EQ(refusal_of(text), file_ + ": no plan; expected a file that `prt plan -o` made") << text;
  }
  EXPECT_NE(refusal_of(R"({"shforge_plan": 1})").find("damaged or edited"), std::string::npos);
  static_cast<void>(write());
  Json edited = Json::parse(read_all(file_));
  edited["budget"] = 0.5;
  EXPECT_NE(refusal_of(edited.dump()).find("damaged or edited"), std::string::npos);
  EXPECT_NE(refusal([](Json& json) { json["mesh"] = "0"; }).find("a plan for another mesh"), std::string::npos);
  EXPECT_NE(refusal([](Json& json) { json["shforge_plan"] = 2; }).find("of version 2, not 1"), std::string::npos);
}

TEST_F(KeptPlan, TakesALightThatDiffersByRounding) {
  const auto changed = [](double part) {
    return [part](Json& json) { json["light"][0] = json["light"][0].get<double>() * (1.0 + part); };
  };
  EXPECT_EQ(refusal(changed(1e-9)), "");
  EXPECT_EQ(refusal(changed(-1e-9)), "");
  for (const double part : {1e-5, -1e-5}) {
    EXPECT_NE(refusal(changed(part)).find("its errors hold for other lights"), std::string::npos);
  }
  for (const auto& light : {Json::array(), Json::array({1.0})}) {
    EXPECT_NE(refusal([&](Json& json) { json["light"] = light; }).find("other lights"), std::string::npos);
  }
}

}  // namespace
}  // namespace sh::prt::test
