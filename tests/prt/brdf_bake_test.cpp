// BRDFs from scenes and mesh files to bakes, files and pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "prt/material/microfacet.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/runtime/fixed_view.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/runtime/shading.hpp"
#include "prt/scene/scene.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/brdf_files.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/gltf.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

const Eigen::Vector3d kEye(2.0, -3.0, 1.5);

Mesh with_brdf(Mesh mesh, const Reflectance& brdf) {
  mesh.specular.clear();
  mesh.exponent.clear();
  mesh.brdf.assign(mesh.positions.size(), static_cast<std::uint16_t>(1 + mesh.brdfs.number_of(brdf)));
  return mesh;
}

std::vector<Eigen::Vector3f> seen(const Transfer& transfer, const LightCoefficients& light) {
  return exit_radiance(transfer, TransferredRadiance(transfer, light), kEye, transfer.mesh.albedo);
}

class BrdfOfScenes : public testing::Test {
 protected:
  Mesh load(const std::string& mesh) {
    write_all(folder_.file("scene.json"), R"({"meshes": [)" + mesh + "]}");
    return load_scene(folder_.file("scene.json"), OnFlaw::kRefuse).mesh;
  }
  std::string refusal(const std::string& mesh) {
    const std::string said = message_of([&] { load(R"({"primitive": "box", )" + mesh + "}"); });
    EXPECT_EQ(said.find('\n'), std::string::npos);
    const std::string before = folder_.file("scene.json") + ": /meshes/0";
    EXPECT_EQ(said.find(before), 0U) << said;
    return said.substr(std::min(before.size(), said.size()));
  }
  TemporaryFolder folder_;
};

TEST_F(BrdfOfScenes, ComesFromRoughnessAndMetallic) {
  const Mesh mesh = load(R"({"primitive": "box", "albedo": [1, 0.8, 0.3], "roughness": 0.25, "metallic": 1})");
  ASSERT_EQ(mesh.brdfs.heads.size(), 1U);
  EXPECT_EQ(mesh.brdfs.at(0), microfacet_reflectance(0.25F, 1.0F));
  EXPECT_EQ(mesh.brdf, std::vector<std::uint16_t>(mesh.positions.size(), 1));
  EXPECT_EQ(mesh.albedo[0], Eigen::Vector3f(1.0F, 0.8F, 0.3F));
  EXPECT_EQ(load(R"({"primitive": "box", "roughness": 1})").brdfs.heads[0].name, "roughness 1, metallic 0");
  EXPECT_TRUE(load(R"({"primitive": "box"})").brdf.empty());
}

TEST_F(BrdfOfScenes, IsKeptOnceForMeshesThatShareIt) {
  const Mesh mesh = load(R"({"primitive": "box"}, {"primitive": "plane", "roughness": 0.5, "sides": 2},
                            {"primitive": "torus", "segments": 8, "roughness": 0.1},
                            {"primitive": "sphere", "segments": 8, "roughness": 0.5})");
  EXPECT_EQ(mesh.brdfs.heads.size(), 2U);
  ASSERT_EQ(mesh.brdf.size(), mesh.positions.size());
  EXPECT_EQ(mesh.brdf.front(), 0);
  EXPECT_EQ(mesh.brdf.back(), 1);
  const auto torus = static_cast<std::ptrdiff_t>(primitive_mesh("torus", 8).positions.size());
  EXPECT_EQ(std::count(mesh.brdf.begin(), mesh.brdf.end(), 2), torus);
}

TEST_F(BrdfOfScenes, ComesFromAFileWithItsAlbedo) {
  write_brdf(folder_.file("clay.binary"), diffuse_brdf({0.6, 0.4, 0.2}));
  const Mesh mesh = load(R"({"primitive": "box", "brdf": "clay.binary"})");
  ASSERT_EQ(mesh.brdfs.heads.size(), 1U);
  EXPECT_TRUE(mesh.brdfs.heads[0].is_measured);
  EXPECT_LT((mesh.albedo[0] - Eigen::Vector3f(0.6F, 0.4F, 0.2F)).norm(), 3e-3F);
}

TEST_F(BrdfOfScenes, ThatContradictThemselvesAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("roughness": 1.5)", "/roughness: expected a number from 0 to 1, got 1.5"},
      {R"("roughness": -0.1)", "/roughness: expected a number from 0 to 1, got -0.1"},
      {R"("roughness": 0.5, "metallic": 2)", "/metallic: expected a number from 0 to 1, got 2"},
      {R"("metallic": 1)", ": expected `roughness` beside `metallic`, got {...}"},
      {R"("roughness": 0.5, "specular": [0, 0, 0], "exponent": 1)",
       ": expected `roughness` or `specular`, not both, got {...}"},
      {R"("roughness": 0.5, "mirror": [0, 0, 0])", ": expected `roughness` or `mirror`, not both, got {...}"},
      {R"("roughness": 0.5, "brdf": "a.binary")", ": expected `roughness` or `brdf`, not both, got {...}"},
      {R"("brdf": "a.binary", "albedo": [0, 0, 0])", ": expected `brdf` or `albedo`, not both, got {...}"}};
  for (const auto& [mesh, message] : cases) {
    const std::string said = refusal(mesh);
    const std::string expected = message;
    const std::string start = expected.substr(0, expected.find("{...}"));
    EXPECT_EQ(said.substr(0, start.size()), start);
  }
  const std::string said = message_of([&] { load(R"({"primitive": "box", "brdf": "none.binary"})"); });
  EXPECT_EQ(said, folder_.file("none.binary") + ": cannot read the measured BRDF: No such file or directory");
}

TEST(BrdfOfGltf, IsReadFromItsFactors) {
  const TemporaryFolder folder;
  const auto imported = [&](const nlohmann::json& material) {
    write_all(folder.file("a.gltf"), gltf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}, material));
    return import_mesh(folder.file("a.gltf"));
  };
  const ImportedMesh gold =
      imported({{"name", "gold"},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", {1.0, 0.8, 0.3, 1.0}}, {"roughnessFactor", 0.25}, {"metallicFactor", 0.5}}}});
  ASSERT_NE(gold.soup.finishes.at(gold.soup.finish_of(0)).gloss.brdf, nullptr);
  EXPECT_EQ(*gold.soup.finishes.at(gold.soup.finish_of(0)).gloss.brdf, microfacet_reflectance(0.25F, 0.5F));
  EXPECT_EQ(gold.soup.albedo[0], Eigen::Vector3f(1.0F, 0.8F, 0.3F));
  const ImportedMesh standard =
      imported({{"name", "standard"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.8, 0.3, 1.0}}}}});
  EXPECT_EQ(standard.soup.finishes.at(standard.soup.finish_of(0)).gloss.brdf->name, "roughness 1, metallic 1");
}

TEST(BrdfBake, OfDiffuseMeasurementsIsThatOfTheAlbedo) {
  const TemporaryFolder folder;
  write_brdf(folder.file("clay.binary"), diffuse_brdf({0.8, 0.5, 0.2}));
  const Mesh plain = finished(hollow_sphere(8, 0.3F), {0.8F, 0.5F, 0.2F}, Eigen::Vector3f::Zero(), 0.0F);
  const auto measured = [&] {
    write_all(folder.file("scene.json"), R"({"meshes": [{"primitive": "box", "brdf": "clay.binary"}]})");
    return with_brdf(plain, load_scene(folder.file("scene.json"), OnFlaw::kRefuse).mesh.brdfs.at(0));
  }();
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    const LightCoefficients light = constant_light(4);
    const std::vector<Eigen::Vector3f> expected = seen(baked(plain, kind, 256, 4), light);
    const std::vector<Eigen::Vector3f> found = seen(baked(measured, kind, 256, 4), light);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      EXPECT_LT((found[v] - expected[v]).cwiseAbs().maxCoeff(), 0.01F) << kind->letters << v;
    }
  }
}

TEST(BrdfBake, KeepsEnergyUnderConstantLightOnAConvexBody) {
  for (const float roughness : {0.0F, 0.2F, 1.0F}) {
    Mesh mesh = with_brdf(primitive_mesh("sphere", 12), microfacet_reflectance(roughness, 1.0F));
    paint(mesh, Eigen::Vector3f::Ones());
    for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed}) {
      for (const Eigen::Vector3f& radiance : seen(baked(mesh, kind, 2048, 4), constant_light(4))) {
        EXPECT_LE(radiance.maxCoeff(), kind == &kGlossyUnshadowed ? 1.001F : 1.15F) << "but for the bands of V";
        EXPECT_GT(radiance.minCoeff(), kind == &kGlossyShadowed || roughness == 1.0F ? 0.2F : 0.85F);
      }
    }
  }
}

TEST(BrdfBake, OfMeasurementsCannotBeRecolored) {
  Reflectance measured = microfacet_reflectance(0.5F, 0.0F);
  const Shading red{.recolor = {1.0F, 0.0F, 0.0F}};
  const auto coated = [&] { return baked(with_brdf(primitive_mesh("box"), measured), &kGlossyShadowed, 16, 1); };
  EXPECT_EQ(message_of([&] { red.require_fit(coated(), 1); }), "");
  measured.is_measured = true;
  EXPECT_NE(message_of([&] { red.require_fit(coated(), 1); }).find("brings its own colors"), std::string::npos);
}

TEST(BrdfBake, AreAtMostAThousand) {
  Reflectances brdfs;
  Reflectance one{"one", false, ReflectanceTable(kReflectanceTableSize)};
  for (std::size_t i = 0; i < kMostBrdfs; ++i) {
    one.table[0] = static_cast<float>(i);
    EXPECT_EQ(brdfs.number_of(one), i);
  }
  EXPECT_EQ(brdfs.number_of(one), kMostBrdfs - 1);
  one.name = "another";
  EXPECT_NE(message_of([&] { brdfs.number_of(one); }).find("more than 1000 different BRDFs"), std::string::npos);
}

TEST(BrdfBake, TakesNoPartInDiffuseKinds) {
  const Mesh plain = primitive_mesh("stairs");
  const Mesh coated = with_brdf(plain, microfacet_reflectance(0.3F, 1.0F));
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    const Transfer transfer = baked(coated, kind, 64, 2);
    EXPECT_EQ(transfer.coefficients, baked(plain, kind, 64, 2).coefficients);
    EXPECT_TRUE(transfer.mesh.brdf.empty() && transfer.mesh.brdfs.heads.empty());
  }
}

TEST(BrdfBake, IsSeenFromAFixedPointAsAtRunTime) {
  Mesh mesh = statue(5.0F);
  mesh = with_brdf(mesh, microfacet_reflectance(0.4F, 0.6F));
  for (const TransferKind* kind : {&kGlossyUnshadowed, &kGlossyShadowed, &kGlossyInterreflected}) {
    const Transfer glossy = baked(mesh, kind, 64, 3);
    const Transfer fixed = seen_from(glossy, kEye);
    EXPECT_TRUE(fixed.mesh.brdfs.heads.empty());
    const LightCoefficients light = random_light(3, 4);
    const std::vector<Eigen::Vector3f> expected = seen(glossy, light);
    const std::vector<Eigen::Vector3f> found = relight(fixed, light);
    for (std::size_t v = 0; v < expected.size(); ++v) EXPECT_LT((found[v] - expected[v]).norm(), 1e-5F);
  }
}

TEST(BrdfBake, OfAPlainVertexBesideCoatedOnesIsItsLobe) {
  Mesh mesh = statue(12.0F);
  const Mesh plain = mesh;
  mesh.brdfs.number_of(microfacet_reflectance(0.4F, 0.6F));
  mesh.brdf.assign(mesh.positions.size(), 1);
  mesh.brdf[3] = 0;
  const LightCoefficients light = random_light(2, 8);
  const std::vector<Eigen::Vector3f> with = seen(baked(mesh, &kGlossyShadowed, 64, 2), light);
  const std::vector<Eigen::Vector3f> without = seen(baked(plain, &kGlossyShadowed, 64, 2), light);
  EXPECT_EQ(with[3], without[3]);
  EXPECT_NE(with[4], without[4]);
}

class BrdfFile : public testing::Test {
 protected:
  void SetUp() override {
    Mesh mesh = with_brdf(primitive_mesh("plane"), microfacet_reflectance(0.4F, 0.6F));
    append(mesh, primitive_mesh("box"));
    transfer_ = baked(mesh, &kGlossyShadowed, 64, 1);
    write_transfer(file_, transfer_);
    good_ = read_all(file_);
  }
  std::string refusal(const std::string& bytes) {
    write_all(file_, with_checksums(bytes));
    const std::string said = message_of([&] { read_transfer(file_); });
    EXPECT_EQ(said.rfind(file_ + ": ", 0), 0U) << said;
    return said.substr(std::min(said.size(), file_.size() + 2));
  }
  template <class Number>
  std::string with_number(std::string_view section, Number number) {
    std::string bytes = good_;
    std::memcpy(bytes.data() + place_of(bytes, section), &number, sizeof number);
    return refusal(bytes);
  }
  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.transfer");
  Transfer transfer_;
  std::string good_;
};

TEST_F(BrdfFile, IsReadAsItWasWritten) {
  const Transfer read = read_transfer(file_);
  EXPECT_EQ(read.mesh.brdf, transfer_.mesh.brdf);
  ASSERT_EQ(read.mesh.brdfs.heads.size(), 1U);
  EXPECT_EQ(read.mesh.brdfs.at(0), transfer_.mesh.brdfs.at(0));
  EXPECT_EQ(seen(read, random_light(1, 2)), seen(transfer_, random_light(1, 2)));
  const std::string again = folder_.file("b.transfer");
  write_transfer(again, read);
  EXPECT_EQ(read_all(again), good_);
}

TEST_F(BrdfFile, WithHostileContentIsRefused) {
  EXPECT_EQ(with_number("brdf", std::uint16_t{2}), "damaged transfer file: it names a BRDF that is not there");
  EXPECT_EQ(with_number("brdfrow", std::nanf("")),
            "damaged transfer file: a coefficient of a BRDF is not from -1000 to 1000");
  EXPECT_EQ(with_number("brdfrow", 1001.0F),
            "damaged transfer file: a coefficient of a BRDF is not from -1000 to 1000");
  std::string bytes = good_;
  const std::string from = R"("brdfs")";
  bytes.replace(bytes.find(from), from.size(), R"("brdfz")");
  EXPECT_EQ(refusal(bytes), "damaged transfer file: it names a BRDF that is not there");
  bytes = good_;
  const std::string measured = R"("measured": false)";
  bytes.replace(bytes.find(measured), measured.size(), R"("measured": 12345)");
  EXPECT_EQ(refusal(bytes), "its JSON header lacks an entry or has one of the wrong type");
}

}  // namespace
}  // namespace sh::prt::test
