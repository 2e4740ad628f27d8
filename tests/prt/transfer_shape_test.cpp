// Transfer shapes and their sizes, files of version 1, and a kind of transfer that this test adds.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "prt/bake/steps.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/shape.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

TEST(TransferShape, CountsTheNumbersOfVectorsMatricesAndOperators) {
  EXPECT_EQ(kShadowed.shape(4).length(), 25U);
  EXPECT_EQ(kInterreflected.shape(4).length(), 75U);
  TransferShape matrix = {.degree = 2, .result_degree = 4};
  EXPECT_EQ(matrix.rows(), 25U);
  EXPECT_EQ(matrix.columns(), 9U);
  EXPECT_EQ(matrix.length(), 225U);
  const TransferShape glossy = {.degree = 4, .result_degree = 4, .meets = Meets::kOperator, .holds_cosine = false};
  EXPECT_EQ(glossy.length(), 81U);
  matrix.storage.element = Element::kHalf;
  matrix.storage.kept = {0, 6};
  EXPECT_EQ(matrix.stored_length(), 50U);
  EXPECT_EQ(matrix.row_bytes(), 100U);
}

TEST(TransferShape, KeepsColumnsInEveryRowOfAMatrixWhenItIsStored) {
  TransferShape matrix = {.channels = 3, .degree = 1, .result_degree = 1};
  matrix.storage.kept = {0, 2};
  matrix.storage.one_channel = true;
  std::vector<float> numbers(2 * matrix.length());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t row = i / matrix.length(), place = i % matrix.count();
    numbers[i] = static_cast<float>(100 * row + place);
  }
  const Encoded encoded = encode(numbers, matrix);
  EXPECT_EQ(encoded.data.size(), 2 * 4 * 2 * sizeof(float));
  const std::vector<float> back = decode(encoded, matrix);
  ASSERT_EQ(back.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(back[i], i % 2 == 0 ? numbers[i] : 0.0F) << i;
  }
}

// Their light and radiance were written by the program that wrote the files; bits are compared.
TEST(VersionOne, TransferFilesKeptInTestsDataAreReadAndRelitToTheSameBits) {
  for (const std::string name : {"shadowed", "kept_half", "byte_emitted_mirror"}) {
    const std::string stem = std::string(SHFORGE_SOURCE_DIR "/tests/data/transfer_v1/") + name;
    ASSERT_EQ(read_all(stem + ".transfer")[8], 1) << name;
    const Transfer transfer = read_transfer(stem + ".transfer");
    const std::vector<std::uint32_t>& kept = transfer.shape.storage.kept;
    LightCoefficients light = LightCoefficients::zero(transfer.degree());
    for (std::size_t i = 0; i < light.values.size(); ++i) {
      const bool has = kept.empty() || std::binary_search(kept.begin(), kept.end(), i % light.bands_squared());
      light.values[i] = has ? 1.0 / (1.0 + static_cast<double>(i)) : 0.0;
    }
    std::ifstream expected(stem + ".radiance");
    std::string number;
    for (const Eigen::Vector3f& radiance : relight(transfer, light)) {
      for (const float value : radiance) {
        ASSERT_TRUE(expected >> number) << name;
        EXPECT_EQ(value, std::strtof(number.c_str(), nullptr)) << name;
      }
    }
    EXPECT_FALSE(expected >> number) << name << ": more vertices";
  }
}

TEST(VersionOne, FilesBecomeVersionTwoWhenWrittenAgain) {
  const TemporaryFolder folder;
  const Transfer old = read_transfer(SHFORGE_SOURCE_DIR "/tests/data/transfer_v1/kept_half.transfer");
  EXPECT_EQ(old.kind, &kInterreflected);
  EXPECT_TRUE(is_alike(old.shape, kInterreflected.shape(2)));
  EXPECT_EQ(old.shape.storage.element, Element::kHalf);
  write_transfer(folder.file("new"), old);
  EXPECT_EQ(read_all(folder.file("new"))[8], 2);
  const Transfer read = read_transfer(folder.file("new"));
  EXPECT_EQ(read.rows().all(), old.rows().all());
  EXPECT_TRUE(is_alike(read.shape, old.shape));
}

TEST(VersionTwo, CarriesTheShapeInItsHeader) {
  const Transfer transfer = baked(primitive_mesh("box"), &kInterreflected, 64, 1);
  const nlohmann::json header = nlohmann::json::parse(transfer_header(transfer));
  EXPECT_EQ(header["meets"], "dot");
  EXPECT_EQ(header["degree"], 1);
  EXPECT_EQ(header["result_degree"], 0);
  EXPECT_EQ(header["channels"], 3);
  EXPECT_EQ(header["rows"], 1);
  EXPECT_EQ(header["columns"], 4);
  EXPECT_EQ(header["holds_cosine"], true);
  EXPECT_EQ(header["holds_albedo"], true);
}

// Shadowed transfer times the albedo, in three channels: a kind of one file and one line.
void color(BakeRun& run) {
  Transfer& transfer = run.transfer;
  const std::vector<float> gray = transfer.coefficients;
  const std::size_t count = transfer.shape.count();
  transfer.shape = transfer.kind->shape(transfer.degree());
  transfer.coefficients.clear();
  for (std::size_t v = 0; v < run.scene.mesh.positions.size(); ++v) {
    for (std::size_t i = 0; i < transfer.shape.length(); ++i) {
      const float albedo = run.scene.mesh.albedo[v][i / count];
      transfer.coefficients.push_back(albedo * gray[v * count + i % count]);
    }
  }
}

constexpr std::array kColoredSteps = {kUnshadowedStep, kShadowStep, BakeStep{color}};
constexpr TransferKind kColored = {
    "DC", "colored", [](int degree) { return TransferShape{.channels = 3, .degree = degree, .holds_albedo = true}; },
    kColoredSteps};

TEST(TransferKind, IsAddedByItsShapeAndItsSteps) {
  const TemporaryFolder folder;
  const std::string file = folder.file("colored");
  Mesh mesh = hollow_sphere(12, 0.3F);
  paint(mesh, {0.75F, 0.5F, 0.25F});
  const Transfer colored = baked(mesh, &kColored);
  write_transfer(file, colored);
  EXPECT_EQ(message_of([&] { read_transfer(file); }),
            file + ": transfer of kind DC, expected one of DU, DS, DI, GU, GS, GI, DT");
  const std::array<const TransferKind*, 2> kinds = {&kShadowed, &kColored};
  const Transfer read = read_transfer(file, kinds);
  EXPECT_EQ(read.kind, &kColored);
  EXPECT_EQ(read.coefficients, colored.coefficients);
  EXPECT_EQ(nlohmann::json::parse(transfer_header(read))["kind"], "DC");
  const LightCoefficients light = random_light(2, 1);
  const std::vector<Eigen::Vector3f> expected = relight(baked(mesh, &kShadowed), light);
  const std::vector<Eigen::Vector3f> radiance = relight(read, light);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    EXPECT_LT((radiance[v] - expected[v]).norm(), 1e-6F * (1.0F + expected[v].norm())) << v;
  }
  EXPECT_THROW(static_cast<void>(recolored(read, light, mesh.albedo)), std::invalid_argument);
}

TEST(TransferKind, IsFoundByItsNamesOrNot) {
  EXPECT_EQ(find_kind(&TransferKind::word, "shadowed"), &kShadowed);
  EXPECT_EQ(find_kind(&TransferKind::letters, "DI"), &kInterreflected);
  EXPECT_EQ(find_kind(&TransferKind::word, "DI"), nullptr);
  EXPECT_EQ(kind_names(&TransferKind::word),
            (std::vector<std::string_view>{"unshadowed", "shadowed", "interreflected", "glossy_unshadowed",
                                           "glossy_shadowed", "glossy_interreflected"}));
}

}  // namespace
}  // namespace sh::prt::test
