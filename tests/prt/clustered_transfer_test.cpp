// Transfer whose rows are clustered: files, hostile files, bakes and the run time, for every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "prt/bake/compress.hpp"
#include "prt/runtime/glossy.hpp"
#include "prt/runtime/lit_clusters.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/glossy_meshes.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

constexpr ClusterCounts kCounts = {5, 3};

/// A bake of a mesh with colors, lobes and shadows.
Transfer baked_statue(const TransferKind& kind, int degree = 2) {
  Mesh mesh = statue(20.0F);
  for (std::size_t v = 0; v < mesh.albedo.size(); ++v) mesh.albedo[v] = {0.3F, 0.2F, v % 2 == 0 ? 0.1F : 0.35F};
  if (!kind.is_glossy()) mesh.specular.clear();
  if (!kind.is_glossy()) mesh.exponent.clear();
  return baked(mesh, &kind, 64, degree);
}

Transfer compressed(Transfer transfer, ClusterCounts counts = kCounts) {
  compress(transfer, counts);
  return transfer;
}

/// The same transfer with complete rows in place of clusters.
Transfer expanded(Transfer transfer) {
  const auto expand = [](Clusters& clusters, TransferShape& shape, std::vector<float>& numbers) {
    if (clusters.empty()) return;
    numbers = clusters.rows();
    clusters = {};
    shape.storage.clusters = shape.storage.vectors = 0;
  };
  expand(transfer.clusters, transfer.shape, transfer.coefficients);
  expand(transfer.indirect_clusters, transfer.indirect_shape, transfer.indirect);
  return transfer;
}

bool is_same(const Clusters& a, const Clusters& b) {
  return a.length == b.length && a.vectors == b.vectors && a.basis == b.basis && a.cluster == b.cluster &&
         a.weights == b.weights && a.error == b.error;
}

const std::vector<const TransferKind*> kStored = {&kUnshadowed, &kShadowed, &kInterreflected, &kGlossyShadowed,
                                                  &kGlossyInterreflected};

TEST(ClusteredTransfer, OfEveryKindIsReadAsItWasWritten) {
  const TemporaryFolder folder;
  for (const TransferKind* kind : kStored) {
    for (const ClusterCounts counts : {kCounts, ClusterCounts{3, 0}, ClusterCounts{1, 1}}) {
      const Transfer transfer = compressed(baked_statue(*kind), counts);
      const std::string file = folder.file("a.transfer");
      write_transfer(file, transfer);
      const Transfer read = read_transfer(file);
      EXPECT_TRUE(is_same(read.clusters, transfer.clusters)) << kind->letters;
      EXPECT_TRUE(is_same(read.indirect_clusters, transfer.indirect_clusters)) << kind->letters;
      EXPECT_EQ(transfer_header(read), transfer_header(transfer)) << kind->letters;
      EXPECT_EQ(kind->indirect != nullptr, read.clusters.empty()) << kind->letters;
      write_transfer(folder.file("b.transfer"), read);
      EXPECT_EQ(read_all(file), read_all(folder.file("b.transfer"))) << kind->letters;
    }
  }
}

TEST(ClusteredTransfer, HasTheBytesThatItsShapeStates) {
  const TemporaryFolder folder;
  for (const TransferKind* kind : kStored) {
    const Transfer transfer = compressed(baked_statue(*kind));
    const bool has_matrices = kind->indirect != nullptr;
    const Clusters& clusters = has_matrices ? transfer.indirect_clusters : transfer.clusters;
    const TransferShape& shape = has_matrices ? transfer.indirect_shape : transfer.shape;
    write_transfer(folder.file("a.transfer"), transfer);
    const std::string bytes = read_all(folder.file("a.transfer"));
    const std::size_t vertices = transfer.mesh.positions.size();
    EXPECT_EQ(shape.receiver_bytes(), 2 + clusters.vectors);
    const std::size_t rows = clusters.basis.size() * 2;
    EXPECT_EQ(shape.stored_bytes(vertices), vertices * (2 + clusters.vectors) + rows);
    const std::string_view cluster = has_matrices ? "icluster" : "cluster";
    EXPECT_EQ(bytes.size() - place_of(bytes, cluster), vertices * (2 + clusters.vectors)) << "the last sections";
  }
}

TEST(ClusteredTransfer, RelightsLikeItsRows) {
  const LightCoefficients light = {2, random_values<double>(27, 5)};
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected}) {
    Transfer transfer = compressed(baked_statue(*kind));
    transfer.emitted.assign(transfer.mesh.positions.size(), {0.5F, 0.25F, 0.125F});
    const Transfer rows = expanded(transfer);
    for (const LightCoefficients& lit : {light, first_bands(light, 1), white(light)}) {
      const std::vector<Eigen::Vector3f> ours = relight(transfer, lit);
      const std::vector<Eigen::Vector3f> theirs = relight(rows, lit);
      for (std::size_t v = 0; v < ours.size(); ++v) {
        EXPECT_LE((ours[v] - theirs[v]).cwiseAbs().maxCoeff(), 2e-6F) << kind->letters << ' ' << v;
      }
    }
    if (transfer.shape.holds_albedo) continue;
    const std::vector<float> gray = relight_gray(transfer, light);
    const std::vector<float> gray_of_rows = relight_gray(rows, light);
    for (std::size_t v = 0; v < gray.size(); ++v) {
      EXPECT_NEAR(gray[v], gray_of_rows[v], 2e-6) << v;
      const Eigen::Vector3f color(0.25F, 0.5F, 0.75F);
      EXPECT_EQ(relight_vertex(transfer, v, light, color), relight_vertex(rows, v, light, color));
    }
    EXPECT_LE((recolored(transfer, light, transfer.mesh.albedo)[7] - relight(rows, light)[7]).norm(), 2e-6F);
  }
}

TEST(ClusteredTransfer, BringsTheRadianceOfItsRows) {
  for (const TransferKind* kind : {&kGlossyShadowed, &kGlossyInterreflected}) {
    for (const int degree : {0, 1, 4}) {
      const LightCoefficients light = {degree, random_values<double>(3 * coefficient_count(degree), 5)};
      const Transfer transfer = compressed(baked_statue(*kind, degree));
      const Transfer rows = expanded(transfer);
      const TransferredRadiance ours(transfer, light);
      const TransferredRadiance theirs(rows, light);
      for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
        for (std::size_t i = 0; i < light.values.size(); ++i) {
          EXPECT_NEAR(ours.at(v)[i], theirs.at(v)[i], 5e-6) << kind->letters << degree << ' ' << v << ' ' << i;
        }
      }
    }
  }
}

TEST(LitClusters, MixLinearFunctionsOfRowsOfEveryWidth) {
  const std::vector<float> rows = random_values(std::size_t{40} * 30, 9);
  const Clusters clusters = clustered(rows, 30, {3, 4});
  for (std::size_t width = 1; width <= 30; ++width) {  // the first numbers of a row
    std::vector<float> lit;
    for (std::size_t row = 0; row * 30 < clusters.basis.size(); ++row) {
      lit.insert(lit.end(), clusters.basis.begin() + row * 30, clusters.basis.begin() + row * 30 + width);
    }
    const LitClusters products(clusters, lit);
    const std::vector<float> expected = clusters.rows();
    for (std::size_t r = 0; r < 40; ++r) {
      std::vector<float> out(width + 1, 2.0F);
      products.add_to(r, out.data());
      for (std::size_t i = 0; i < width; ++i) EXPECT_NEAR(out[i], 2.0F + expected[r * 30 + i], 2e-6) << width;
      EXPECT_EQ(out[width], 2.0F) << width;
    }
  }
}

TEST(ClusteredTransfer, IsBakedAsAsked) {
  Scene scene = scene_of(statue(20.0F), &kInterreflected, 64, 2);
  const Transfer plain = bake(scene);
  scene.bake.compress = {6, 4};
  const Transfer transfer = bake(scene);
  EXPECT_TRUE(is_same(transfer.clusters, compressed(plain, {6, 4}).clusters));
  EXPECT_TRUE(transfer.coefficients.empty());
  const auto storage = nlohmann::json::parse(transfer_header(transfer))["storage"];
  EXPECT_EQ(storage["element"], "half");
  EXPECT_EQ(storage["clusters"], 6);
  EXPECT_EQ(storage["vectors"], 4);
  EXPECT_EQ(storage["error"], transfer.clusters.error);
  const std::vector<float> rows = transfer.clusters.rows();
  double lost = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lost += std::pow(static_cast<double>(rows[i] - plain.coefficients[i]), 2);
    all += std::pow(static_cast<double>(plain.coefficients[i]), 2);
  }
  EXPECT_NEAR(transfer.clusters.error, std::sqrt(lost / all), 1e-6);
  EXPECT_LT(transfer.clusters.error, 0.2);
}

// The rows of a room, so many that clusters are smaller.
Scene room_to_plan(ClusterCounts counts, double error) {
  Mesh mesh = statue(20.0F);
  mesh.specular.clear();
  mesh.exponent.clear();
  refine(mesh, 0.1F);
  Scene scene = scene_of(std::move(mesh), &kInterreflected, 512, 2);
  scene.lights = {{.type = LightType::kCieOvercast}};
  scene.bake.compress = counts;
  scene.plan = {.mode = PlanMode::kLossy, .error = error, .without = {"receivers", "bounces", "bands", "symmetry"}};
  return scene;
}

const Decision& clusters_of(const Transfer& transfer) {
  const auto& all = transfer.plan.decisions;
  return *std::find_if(all.begin(), all.end(), [](const Decision& one) { return one.name == kClustersDecision; });
}

TEST(ClusteredTransfer, IsTakenByAPlanThatHasRoomForItsError) {
  const BakeJob job = planned({room_to_plan({12, 5}, 0.1)});
  const Transfer transfer = bake(job);
  ASSERT_FALSE(transfer.clusters.empty()) << clusters_of(transfer).why;
  EXPECT_TRUE(transfer.coefficients.empty());
  EXPECT_EQ(clusters_of(transfer).basis, "measured");
  EXPECT_GT(clusters_of(transfer).bytes_saved, 0);
  EXPECT_LE(transfer.plan.error, 0.1);
  // The error, by relighting: the same bake as rows, under the lights of the plan.
  BakeJob plain = job;
  plain.scene.bake.compress = {};
  plain.plan->clusters.clear();
  const Transfer rows = bake(plain);
  double worst = 0.0;
  for (const LightCoefficients& light : job.plan->lights) {
    const std::vector<Eigen::Vector3f> ours = relight(transfer, light);
    const std::vector<Eigen::Vector3f> theirs = relight(rows, light);
    double squares = 0.0;
    for (std::size_t v = 0; v < ours.size(); ++v) {
      squares += std::pow(static_cast<double>((ours[v] - theirs[v]).cwiseAbs().maxCoeff()), 2);
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(ours.size())));
  }
  EXPECT_NEAR(clusters_of(transfer).error, worst / job.plan->reference, 1e-5);
  EXPECT_GT(clusters_of(transfer).error, 1e-4);
}

TEST(ClusteredTransfer, IsNotTakenWhereItLosesMoreThanThePlanHasRoomFor) {
  const Transfer transfer = bake(room_to_plan({1, 0}, 0.1));
  EXPECT_TRUE(transfer.clusters.empty());
  EXPECT_FALSE(transfer.coefficients.empty());
  EXPECT_EQ(clusters_of(transfer).choice, "rows as they are");
  EXPECT_NE(clusters_of(transfer).why.find("1 of 0 vectors would lose"), std::string::npos);
  EXPECT_EQ(clusters_of(transfer).error, 0.0);
  EXPECT_EQ(clusters_of(transfer).bytes_saved, 0);
}

// The counts that a plan chooses from, with the error of each: the first that fits is taken.
TEST(ClusteredTransfer, HasTheFirstCountsThatAPlanHasRoomFor) {
  const auto scene_with = [](ClusterCounts counts, double error) {
    Scene scene = room_to_plan(counts, error);
    scene.plan.without.insert(scene.plan.without.end(), {"analytic", "storage", "hits", "directions"});
    scene.bake.compress_by_plan = counts.clusters == 0;
    return scene;
  };
  std::vector<double> errors;
  for (const ClusterCounts counts : {ClusterCounts{32, 4}, ClusterCounts{64, 8}, ClusterCounts{128, 8}}) {
    errors.push_back(clusters_of(bake(scene_with(counts, 1.0))).error);
  }
  ASSERT_GT(errors[0], errors[1]);
  ASSERT_GT(errors[1], errors[2]);
  const auto chosen = [&](double room) { return bake(scene_with({}, std::min(1.0, 4.0 * room))); };
  const Transfer first = chosen(1.01 * errors[0]);
  EXPECT_EQ(clusters_of(first).choice, "32 of 4 vectors");
  EXPECT_EQ(first.shape.storage.vectors, 4U);
  const Transfer third = chosen(0.99 * errors[1]);
  EXPECT_EQ(clusters_of(third).choice, "128 of 8 vectors");
  EXPECT_NEAR(clusters_of(third).error, errors[2], 1e-9);
  EXPECT_LT(clusters_of(third).bytes_saved, clusters_of(first).bytes_saved);
  const Transfer none = chosen(1e-6);
  EXPECT_EQ(clusters_of(none).choice, "rows as they are");
  EXPECT_TRUE(none.clusters.empty());
}

TEST(ClusteredTransfer, NeedsAPlanWithAnErrorToHaveItsCountsChosen) {
  Scene scene = room_to_plan({}, 0.1);
  scene.bake.compress_by_plan = true;
  scene.plan.mode = PlanMode::kExact;
  EXPECT_NE(message_of([&] { bake(scene); }).find("compress: only a plan with an error chooses counts"),
            std::string::npos);
  scene.plan.mode = PlanMode::kLossy;
  scene.bake.kind = &kGlossyUnshadowed;
  EXPECT_NE(message_of([&] { bake(scene); }).find("stores no numbers to compress"), std::string::npos);
}

TEST(ClusteredTransfer, IsNotTakenWhereItIsLargerThanRows) {
  const BakeJob job = planned({room_to_plan({4096, 30}, 0.1)});
  EXPECT_EQ(job.scene.bake.compress.clusters, 0U);
  const Transfer transfer = bake(job);
  EXPECT_TRUE(transfer.clusters.empty());
  EXPECT_NE(clusters_of(transfer).why.find("clusters take "), std::string::npos);
}

TEST(ClusteredTransfer, KeepsVisibilityInHalfBesideItsMatrices) {
  const Transfer transfer = compressed(baked_statue(kGlossyInterreflected));
  EXPECT_EQ(transfer.shape.storage.element, Element::kHalf);
  EXPECT_FALSE(transfer.shape.storage.is_clustered());
  EXPECT_TRUE(transfer.indirect.empty());
}

TEST(ClusteredTransfer, OfOneChannelForThreeKeepsThemEqual) {
  Transfer transfer = baked_statue(kInterreflected);
  const std::size_t count = transfer.shape.count();
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    for (std::size_t i = 0; i < 3 * count; ++i) transfer.row(v)[i] = transfer.row(v)[i % count];
  }
  transfer.shape.storage.one_channel = true;
  compress(transfer, kCounts);
  EXPECT_EQ(transfer.shape.stored_length(), count);
  const std::vector<float> rows = transfer.clusters.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i], rows[i / (3 * count) * 3 * count + i % count]);
}

// Where half of the columns are noise that no light needs, the others are as good as alone.
TEST(ClusteredTransfer, SpendsNothingOnColumnsThatFilesLose) {
  Transfer transfer = baked_statue(kShadowed);
  const std::vector<float> noise = random_values(transfer.coefficients.size(), 3);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    if (i % 9 >= 4) transfer.coefficients[i] = noise[i];
  }
  transfer.shape.storage.kept = {0, 1, 2, 3};
  compress(transfer, {9, 3});
  EXPECT_LT(transfer.clusters.error, 0.05);
  const std::vector<float> rows = transfer.clusters.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % 9 >= 4) {
      EXPECT_EQ(rows[i], 0.0F);
    }
  }
}

TEST(ClusteredTransfer, KeepsVectorsThatHalfCannotHoldInSingle) {
  Transfer transfer = baked_statue(kShadowed);
  for (float& number : transfer.coefficients) number *= 1e6F;
  compress(transfer, kCounts);
  EXPECT_EQ(transfer.shape.storage.element, Element::kSingle);
  EXPECT_LT(transfer.clusters.error, 0.2);
}

TEST(ClusteredTransfer, IsRefusedBeforeABakeThatCannotMakeIt) {
  const auto refusal = [](const TransferKind& kind, ClusterCounts counts) {
    Scene scene = scene_of(statue(20.0F), &kind, 64, 2);
    scene.bake.compress = counts;
    return message_of([&] { bake(scene); });
  };
  EXPECT_EQ(refusal(kShadowed, {4097, 3}), "compress: expected 1 to 4096 clusters of 0 to 64 vectors, got 4097 of 3");
  EXPECT_EQ(refusal(kShadowed, {4, 65}), "compress: expected 1 to 4096 clusters of 0 to 64 vectors, got 4 of 65");
  EXPECT_NE(refusal(kGlossyUnshadowed, {4, 3}).find("stores no numbers to compress; expected another kind"),
            std::string::npos);
}

TEST(ClusteredTransfer, IsNotWrittenWithPartsThatDisagree) {
  const TemporaryFolder folder;
  const Transfer good = compressed(baked_statue(kShadowed));
  const auto refusal = [&](const auto& change) {
    Transfer bad = good;
    change(bad);
    return message_of([&] { write_transfer(folder.file("a"), bad); });
  };
  EXPECT_NE(refusal([](Transfer& bad) { bad.clusters.cluster.pop_back(); }), "");
  EXPECT_NE(refusal([](Transfer& bad) { bad.clusters.weights.pop_back(); }), "");
  EXPECT_NE(refusal([](Transfer& bad) { bad.clusters.basis.pop_back(); }), "");
  EXPECT_NE(refusal([](Transfer& bad) { bad.clusters.basis[3] = std::numeric_limits<float>::infinity(); }), "");
  EXPECT_NE(refusal([](Transfer& bad) { ++bad.shape.storage.vectors; }), "");
  EXPECT_NE(refusal([](Transfer& bad) { bad.coefficients.assign(bad.mesh.positions.size() * 9, 0.0F); }), "");
  EXPECT_EQ(refusal([](Transfer&) {}), "");
}

class HostileClusters : public testing::Test {
 protected:
  void write(const TransferKind& kind) {
    write_transfer(file_, compressed(baked_statue(kind)));
    good_ = read_all(file_);
  }

  // What the reader says of these bytes; empty: it accepts them.
  std::string refusal(const std::string& bytes, bool sizes = false) {
    write_all(file_, with_checksums(bytes, sizes));
    const std::string said = message_of([&] { read_transfer(file_); });
    return said.empty() ? said : said.substr(file_.size() + 2);
  }

  template <class Number>
  std::string with_number(std::string_view section, Number number) {
    std::string bytes = good_;
    std::memcpy(bytes.data() + place_of(bytes, section), &number, sizeof number);
    return refusal(bytes);
  }

  std::string with_header(const std::string& from, std::string to) {
    const std::size_t place = good_.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    to.resize(from.size(), ' ');
    return refusal(std::string(good_).replace(place, from.size(), to));
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.transfer");
  std::string good_;
};

TEST_F(HostileClusters, AreRefusedWithNumbersThatNoBakeWrites) {
  for (const auto& [kind, prefix, rows] :
       {std::tuple{&kShadowed, "", "transfer"}, std::tuple{&kGlossyInterreflected, "i", "indirect"}}) {
    write(*kind);
    EXPECT_EQ(refusal(good_), "");
    const std::string cluster = std::string(prefix) + "cluster";
    const std::string weight = std::string(prefix) + "weight";
    EXPECT_EQ(with_number(cluster, std::uint16_t{4}), "");
    EXPECT_EQ(with_number(cluster, std::uint16_t{5}), "damaged transfer file: it names a cluster that is not there");
    EXPECT_EQ(with_number(cluster, std::uint16_t{65535}),
              "damaged transfer file: it names a cluster that is not there");
    EXPECT_EQ(with_number(weight, std::int8_t{-127}), "");
    EXPECT_EQ(with_number(weight, std::int8_t{-128}), "damaged transfer file: a weight is below -127");
    for (const int bad : {0x7c00, 0x7e00, 0xfc00}) {
      EXPECT_EQ(with_number(rows, static_cast<std::uint16_t>(bad)),
                "damaged transfer file: a transfer coefficient is not finite");
    }
  }
}

TEST_F(HostileClusters, AreRefusedWhereTheirSumsExceedSinglePrecision) {
  Transfer transfer = baked_statue(kShadowed);
  for (float& number : transfer.coefficients) number *= 1e6F;
  compress(transfer, kCounts);
  write_transfer(file_, transfer);
  good_ = read_all(file_);
  EXPECT_EQ(with_number("transfer", 1e38F), "");
  std::string bytes = good_;
  const float large = 3e38F;
  const std::size_t place = place_of(bytes, "transfer");
  std::memcpy(bytes.data() + place, &large, sizeof large);
  std::memcpy(bytes.data() + place + transfer.shape.row_bytes(), &large, sizeof large);  // and along a vector
  EXPECT_EQ(refusal(bytes), "damaged transfer file: a transfer coefficient is not finite");
}

TEST_F(HostileClusters, AreRefusedWithCountsThatTheirSectionsDoNotHave) {
  write(kShadowed);
  for (const char* counts : {"0", "4", "6", "-1"}) {
    EXPECT_NE(with_header("\"clusters\": 5,\n", std::string("\"clusters\":") + counts + ","), "") << counts;
  }
  EXPECT_NE(with_header("\"vectors\": 3,\n", "\"vectors\": 2,"), "");
  EXPECT_NE(with_header("\"vectors\": 3,\n", "\"vectors\":65,"), "");
  EXPECT_NE(with_header("\"vectors\": 3", "\"vectorz\": 3"), "");
  EXPECT_NE(with_header("\"clusters\": 5", "\"clusterz\": 5"), "");
  EXPECT_NE(with_header("\"element\": \"half\"", "\"element\": \"byte\""), "");
  EXPECT_NE(with_header("\"kind\": \"DS\"", "\"kind\": \"DI\""), "");
}

TEST_F(HostileClusters, HaveTheirSectionsAndOthersHaveNot) {
  write(kShadowed);
  const std::string no_weights = good_.substr(0, place_of(good_, "weight"));
  EXPECT_EQ(refusal(with_table(no_weights, [](auto& table) { table.pop_back(); }), true),
            "damaged transfer file: section weight is missing");
  const std::string no_clusters = good_.substr(0, place_of(good_, "cluster"));
  EXPECT_EQ(refusal(with_table(no_clusters, [](auto& table) { table.resize(table.size() - 2); }), true),
            "damaged transfer file: section cluster is missing");
  const std::string tail = good_.substr(place_of(good_, "cluster"));
  write_transfer(file_, baked_statue(kShadowed));
  const std::string plain = read_all(file_);
  const auto vertices = static_cast<std::uint64_t>(read_transfer(file_).mesh.positions.size());
  const auto with_section = [&](const char* name, std::uint32_t type, std::uint32_t columns) {
    const std::string bytes = plain + tail.substr(0, vertices * columns * layout::size_of(type));
    return refusal(with_table(bytes,
                              [&](auto& table) {
                                table.push_back({layout::padded(name), type, columns, columns > 0 ? vertices : 0});
                              }),
                   true);
  };
  for (const char* name : {"cluster", "icluster"}) {
    EXPECT_EQ(with_section(name, layout::kSmall, 1),
              "transfer file of kind DS with a section " + std::string(name) + ", which it does not have");
  }
  for (const std::uint32_t columns : {0U, 1U}) {
    EXPECT_EQ(with_section("weight", layout::kByte, columns),
              "transfer file of kind DS with a section weight, which it does not have");
    EXPECT_EQ(with_section("iweight", layout::kByte, columns),
              "transfer file of kind DS with a section iweight, which it does not have");
  }
}

TEST_F(HostileClusters, AreRefusedInAFileWithoutNumbers) {
  write_transfer(file_, baked_statue(kGlossyUnshadowed));
  good_ = read_all(file_);
  const auto scale = [](auto& table) { table.push_back({layout::padded("scale"), layout::kFloat, 0, 1}); };
  EXPECT_NE(refusal(with_table(good_, scale), true), "");
  const std::string holds = R"("holds": "nothing: the light itself reaches every vertex",)"
                            "\n  ";
  for (const char* storage : {R"("storage":{"element":"half","one_channel":false,"kept":[]},)",
                              R"("storage":{"element":"byte","one_channel":false,"kept":[]},)"}) {
    EXPECT_EQ(with_header(holds, storage), "transfer file whose JSON header names a storage that does not exist");
  }
}

}  // namespace
}  // namespace sh::prt::test
