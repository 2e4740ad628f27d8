// Bands that glossy transfer leaves out: numbers, files, bad headers, bakes and the run time, for GS and GI.
#include "prt/transfer/kept_bands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/bake/bake.hpp"
#include "prt/bake/compress.hpp"
#include "prt/runtime/fixed_view.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_json.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/kept_cases.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

/// Rows and columns of either shape, few bands of the visibility, one number of each, and all.
std::vector<KeptBands> some_bands(int degree) {
  return {{degree + degree / 2, degree, degree / 2},
          {2 * degree, degree / 2, degree},
          {degree, degree / 2, degree / 2},
          {0, 0, 0},
          {2 * degree - 1 + (degree == 0 ? 1 : 0), degree, 0},
          {}};
}

/// Calls use(transfer, kept) for every kind, degree, count of channels and choice of bands.
template <class Use>
void for_cases(const Use& use, std::size_t vertices = 21) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    for (const int degree : {0, 1, 2, 4}) {
      for (const std::size_t channels : {std::size_t{1}, std::size_t{3}}) {
        for (const KeptBands& kept : some_bands(degree)) {
          SCOPED_TRACE(testing::Message()
                       << kind->letters << " of degree " << degree << ", " << channels
                       << " channels: " << kept.visibility << ", " << kept.result << " x " << kept.light);
          use(random_glossy(*kind, degree, channels, vertices), kept);
        }
      }
    }
  }
}

void expect_same_light(const Transfer& a, const Transfer& b) {
  const LightCoefficients light = random_light(a.degree(), 5);
  for (const LightCoefficients& lit : {light, first_bands(light, a.degree() / 2)}) {
    const TransferredRadiance ours(a, lit);
    const TransferredRadiance theirs(b, lit);
    const std::size_t count = a.mesh.positions.size() * 3 * coefficient_count(a.degree());
    const auto louder = [](float x, float y) { return std::abs(x) < std::abs(y); };
    const float largest = std::abs(*std::max_element(theirs.at(0), theirs.at(0) + count, louder));
    for (std::size_t i = 0; i < count; ++i) ASSERT_NEAR(ours.at(0)[i], theirs.at(0)[i], 4e-6F * largest) << i;
  }
}

TEST(KeptBands, GiveTheLightOfCompleteRowsWithZerosInPlaceOfTheOthers) {
  for_cases([](const Transfer& whole, const KeptBands& kept) {
    const Transfer some = keeping(whole, kept);
    EXPECT_EQ(some.indirect.size(), some.kind->stores_matrices() ? 21 * some.indirect_shape.length() : 0);
    EXPECT_LE(some.indirect.size(), whole.indirect.size());
    expect_same_light(some, with_zeros(whole, kept));
    EXPECT_EQ(complete(some).coefficients, with_zeros(whole, kept).coefficients);
    EXPECT_EQ(complete(some).indirect, with_zeros(whole, kept).indirect);
    const KeptBands has = whole.kind->stores_matrices() ? kept : KeptBands{kept.visibility};
    EXPECT_EQ(kept_by(some), has.within(whole.degree()));
  });
}

TEST(KeptBands, HaveTheBytesOfTheirNumbers) {
  const Transfer whole = random_glossy(kGlossyInterreflected, 4, 3, 5);
  const Transfer some = keeping(whole, {6, 4, 2});
  EXPECT_EQ(whole.shape.receiver_bytes() + whole.indirect_shape.receiver_bytes(), 81U * 4 + 3U * 25 * 25 * 2);
  EXPECT_EQ(some.shape.receiver_bytes() + some.indirect_shape.receiver_bytes(), 49U * 4 + 3U * 25 * 9 * 2);
  EXPECT_EQ(keeping(whole, {6, 2, 4}).indirect_shape.receiver_bytes(), 3U * 9 * 25 * 2);
  EXPECT_EQ(keeping(whole, {}).shape.storage.kept.size(), 0U);
  EXPECT_EQ(keeping(whole, {8, 4, 4}).shape.storage.kept.size(), 0U);
}

TEST(KeptBands, LeaveOtherShapesAsTheyAre) {
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected, &kGlossyUnshadowed}) {
    const TransferShape same = with_bands(kind->shape(4), {0, 0, 0});
    EXPECT_TRUE(is_alike(same, kind->shape(4))) << kind->letters;
    EXPECT_TRUE(same.storage.kept.empty()) << kind->letters;
  }
}

TEST(KeptBands, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.transfer");
  for_cases([&](const Transfer& whole, const KeptBands& kept) {
    for (const Element element : {Element::kSingle, Element::kHalf, Element::kByte}) {
      Transfer some = keeping(whole, kept);
      some.shape.storage.element = element;
      some.coefficients = decode(encode(some.coefficients, some.shape), some.shape);
      for (auto* colors : {&some.mesh.albedo, &some.mesh.specular}) {
        for (Eigen::Vector3f& color : *colors) color = color.cwiseAbs();
      }
      some.mesh.geometric_normals = some.mesh.normals;
      write_transfer(file, some);
      const Transfer read = read_transfer(file);
      EXPECT_EQ(read.matrices().all(), some.indirect);
      const std::vector<float> numbers = read.rows().all();
      ASSERT_EQ(numbers.size(), some.coefficients.size());
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        ASSERT_NEAR(numbers[i], some.coefficients[i], element == Element::kByte ? 1e-6F : 0.0F);
      }
      EXPECT_EQ(read.shape.storage.kept, some.shape.storage.kept);
      EXPECT_EQ(kept_by(read), kept_by(some));
      EXPECT_EQ(transfer_header(read), transfer_header(some));
      expect_same_light(read, some);
    }
  });
}

TEST(KeptBands, MeetClusters) {
  for_cases(
      [](const Transfer& whole, const KeptBands& kept) {
        Transfer clustered = keeping(whole, kept);
        compress(clustered, {3, 2});
        EXPECT_NE(clustered.clusters.empty(), clustered.indirect_clusters.empty());
        expect_same_light(clustered, complete(clustered));
        for (std::size_t v = 0; v < 33; ++v) {
          std::vector<float> row(clustered.shape.length(), 0.0F);
          if (clustered.clusters.empty()) continue;
          clustered.clusters.row(v, row.data());
          const std::size_t some = std::min(row.size(), coefficient_count(kept.visibility));
          EXPECT_TRUE(std::all_of(row.begin() + static_cast<std::ptrdiff_t>(some), row.end(),
                                  [](float value) { return value == 0.0F; }));
        }
      },
      33);
}

// Matrices and visibility both in clusters, which a bake does not make but a file may have.
TEST(KeptBands, MeetClustersOfBoth) {
  for_cases([](const Transfer& whole, const KeptBands& kept) {
    if (!whole.kind->stores_matrices()) return;
    Transfer clustered = keeping(whole, kept);
    compress(clustered, {3, 2});
    clustered.clusters = sh::prt::clustered(clustered.coefficients, clustered.shape.length(), {2, 1});
    clustered.coefficients.clear();
    expect_same_light(clustered, complete(clustered));
  });
}

TEST(KeptBands, AreSeenFromAPointAtRest) {
  for (const float albedo : {0.4F, 0.0F}) {
    for (const int degree : {0, 1, 4}) {
      Transfer whole = random_glossy(kGlossyInterreflected, degree, 3, 9);
      for (Eigen::Vector3f& color : whole.mesh.albedo) color.setConstant(albedo);
      const Transfer some = keeping(whole, {degree, degree, degree / 2});
      const LightCoefficients light = random_light(degree, 3);
      const auto got = relight(seen_from(some, kEye), light);
      expect_near(got, exit_radiance(some, TransferredRadiance(some, light), kEye, some.mesh.albedo), "seen");
    }
  }
}

/// A bake of a mesh with lobes, of colors or gray, or of black materials.
Scene statue_scene(const TransferKind* kind, const KeptBands& keep, float strength = 1.0F, bool gray = false) {
  Mesh mesh = statue(6.0F);
  paint(mesh, strength * (gray ? Eigen::Vector3f(0.3F, 0.3F, 0.3F) : Eigen::Vector3f(0.3F, 0.2F, 0.1F)));
  for (Eigen::Vector3f& color : mesh.specular) color *= strength;
  Scene scene = scene_of(std::move(mesh), kind, 128, 2);
  scene.bake.keep = keep;
  return scene;
}

TEST(KeptBands, OfABakeAreThoseThatTheSceneAsksFor) {
  const KeptBands kept{3, 2, 1};
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    for (const auto& [strength, gray] : {std::pair(1.0F, false), {1.0F, true}, {0.0F, true}}) {
      KeptBands asked = kept;
      if (!kind->stores_matrices()) asked = {kept.visibility};
      const Transfer some = bake(statue_scene(kind, asked, strength, gray));
      const Transfer whole = bake(statue_scene(kind, {}, strength, gray));
      const Transfer zeros = with_zeros(whole, kept);
      EXPECT_EQ(some.shape.storage.kept.size(), 16U);
      EXPECT_EQ(some.coefficients, zeros.coefficients) << kind->letters;
      EXPECT_EQ(complete(some).indirect, zeros.indirect) << kind->letters;
      EXPECT_EQ(some.indirect.size(), kind->stores_matrices() ? some.mesh.positions.size() * (gray ? 36 : 108) : 0U);
      expect_same_light(some, zeros);
    }
  }
}

TEST(KeptBands, AreRefusedWhereTheKindHasNone) {
  const auto refusal = [](const TransferKind* kind, const KeptBands& keep, PlanMode mode = PlanMode::kNone) {
    Scene scene = statue_scene(kind, keep);
    scene.plan.mode = mode;
    std::string said = message_of([&] { planned(BakeJob(scene)); });
    EXPECT_EQ(said.find('\n'), std::string::npos);
    return said;
  };
  EXPECT_NE(refusal(&kShadowed, {3}).find("keep: shadowed stores no visibility"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyUnshadowed, {3}).find("stores no visibility"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyShadowed, {3, 1}).find("has no matrices"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyShadowed, {3, 10, 1}).find("has no matrices"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyShadowed, {-1}).find("0 or more, got -1"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyInterreflected, {1, -2}).find("0 or more, got 1, -2"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyInterreflected, {1, 1, -3}).find("and -3"), std::string::npos);
  EXPECT_NE(refusal(&kGlossyInterreflected, {1, 1, 1}, PlanMode::kLossy).find("chooses the bands"), std::string::npos);
  EXPECT_EQ(refusal(&kGlossyInterreflected, {1, 1, 1}, PlanMode::kExact), "");
  EXPECT_EQ(refusal(&kShadowed, {}), "");
}

/// What a reader says of a file whose header has another text.
class KeptFile : public testing::Test {
 protected:
  std::string refusal(const std::string& from, const std::string& to) {
    std::string bytes = good_;
    const std::size_t place = bytes.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    EXPECT_LE(to.size(), from.size());
    std::string padded = to;
    padded.resize(from.size(), ' ');
    write_all(file_, with_checksums(bytes.replace(place, from.size(), padded), false));
    std::string said = message_of([&] { read_transfer(file_); });
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  }

  void SetUp() override {
    Transfer some = bake(statue_scene(&kGlossyInterreflected, {1, 2, 1}));
    write_transfer(file_, some);
    good_ = read_all(file_);
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.transfer");
  std::string good_;
};

TEST_F(KeptFile, IsRefusedWithRowsOrColumnsThatNoDegreeHas) {
  EXPECT_EQ(refusal("    \"rows\": 9,", "    \"rows\": 9,"), "");
  for (const char* bad : {"0", "8", "-1", "16", "\"9\"", "[]", "9.5"}) {
    const std::string rows = refusal("    \"rows\": 9,", std::string("  \"rows\":") + bad + ",");
    EXPECT_NE(rows.find(std::string("indirect matrices of 3 x ") + bad + " x 4"), std::string::npos) << rows;
    const std::string columns = refusal("    \"columns\": 4,", std::string("  \"columns\":") + bad + ",");
    EXPECT_NE(columns.find(std::string("indirect matrices of 3 x 9 x ") + bad), std::string::npos) << columns;
    EXPECT_NE(columns.find("expected 1 or 3 x squares of 1 to 3 half"), std::string::npos) << columns;
  }
  for (const char* other : {"1", "4"}) {
    const std::string said = refusal("    \"rows\": 9,", std::string("    \"rows\": ") + other + ",");
    EXPECT_NE(said.find("section indirect does not fit"), std::string::npos) << said;
  }
  const std::string said = refusal("    \"columns\": 4,", "    \"columns\": 9,");
  EXPECT_NE(said.find("section indirect does not fit"), std::string::npos) << said;
}

TEST_F(KeptFile, IsRefusedWithColumnsOfVisibilityThatItDoesNotHave) {
  const auto list = [](const std::string& last) { return "      1,\n      2,\n      " + last + "\n    ]"; };
  EXPECT_EQ(refusal(list("3"), list("3")), "");
  EXPECT_EQ(refusal(list("3"), list("9")), "") << "any columns may be kept";
  EXPECT_NE(refusal(list("3"), list("2")).find("a storage that does not exist"), std::string::npos);
  EXPECT_NE(refusal(list("3"), "      1,\n      2,\n     25\n    ]").find("a storage that"), std::string::npos);
  EXPECT_NE(refusal(list("3"), "      1,\n      3\n    ]").find("section transfer does not fit"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
