// Emitted run times, compiled and run, against the relighting of the library.
#include "prt/emit/emit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/prt/coated_cases.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// A program that relights every case and writes NAME.out; white: under the first channel of the light alone.
std::string program(const std::vector<EmittedCase>& all) {
  std::string text = "#include <cstdio>\n#include <fstream>\n#include <iterator>\n#include <vector>\n";
  for (const EmittedCase& one : all) text += fmt::format("#include \"{}/relight.hpp\"\n", one.name);
  text += R"(
template <class T>
static std::vector<T> read(const char* name) {
  std::ifstream in(name, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}
static void write(const char* name, const std::vector<float>& values) {
  std::ofstream(name, std::ios::binary).write(reinterpret_cast<const char*>(values.data()),
                                              static_cast<std::streamsize>(values.size() * sizeof(float)));
}
int main() {
  const float eye[3] = {1.5F, -2.0F, 3.0F};
  static_cast<void>(eye);
)";
  for (const EmittedCase& one : all) {
    const bool glossy = one.transfer.kind->is_glossy();
    text += fmt::format(R"(  {{
    namespace run = sh_{0};
    const auto bytes = read<unsigned char>("{0}/relight.bin");
    if (!run::is_data(bytes.data(), bytes.size()) || run::is_data(bytes.data(), bytes.size() - 1)) return 1;
    const auto light = read<float>("{0}.light");
    std::vector<float> radiance(3 * run::kVertices);
    const auto prepared = run::prepared(run::data_of(bytes.data()), light.data());
    for (std::size_t block = 0; block < run::kBlocks; ++block) {{
      run::relight(run::data_of(bytes.data()), prepared, {1}radiance.data(), block, block + 1);
    }}
    write("{0}.out", radiance);
)",
                        one.name, glossy ? "eye, " : "");
    if (!glossy) {
      text += fmt::format(
          R"(    const auto data = run::data_of(bytes.data());
    run::relight_white(data, run::prepared_white(data, light.data()), radiance.data());
    write("{0}.white", radiance);
)",
          one.name);
    }
    text += "  }\n";
  }
  return text + "  return 0;\n}\n";
}

std::vector<Eigen::Vector3f> radiance_in(const std::string& file) {
  const std::string bytes = read_all(file);
  std::vector<Eigen::Vector3f> radiance(bytes.size() / sizeof(Eigen::Vector3f));
  std::memcpy(static_cast<void*>(radiance.data()), bytes.data(), bytes.size());
  return radiance;
}

void expect_radiance_of_relighting(const TemporaryFolder& folder, const std::vector<EmittedCase>& all,
                                   const std::string& compiler) {
  SCOPED_TRACE(compiler);
  const std::string built = fmt::format(
      "cd '{}' && {} -std=c++17 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror main.cpp -o main && ./main",
      folder.path().string(), compiler);
  ASSERT_EQ(std::system(built.c_str()), 0);  // NOLINT(cert-env33-c): a fixed command line
  for (const EmittedCase& one : all) {
    expect_near(radiance_in(folder.file(one.name + ".out")), expected(one), one.name);
    if (one.transfer.kind->is_glossy()) continue;
    const LightCoefficients light = light_of(one);
    const std::vector<double> first(light.values.begin(),
                                    light.values.begin() + static_cast<std::ptrdiff_t>(light.bands_squared()));
    expect_near(radiance_in(folder.file(one.name + ".white")), relight(one.transfer, white(first, light.degree)),
                one.name);
  }
}

// All run times are in one program, so that they do not disturb each other.
TEST(EmittedCpp, GivesTheRadianceOfRelightingByEveryCompiler) {
  const TemporaryFolder folder;
  std::vector<EmittedCase> all = emitted_cases();
  for (const std::vector<EmittedCase>& more : {clustered_cases(), coated_cases(), highest_cases()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  for (const EmittedCase& one : all) {
    std::filesystem::create_directory(folder.file(one.name));
    for (const EmittedFile& file : emit_cpp(one.transfer, {one.name, one.light}).files) {
      write_all(folder.file(one.name + "/" + file.name), file.bytes);
    }
    const LightCoefficients light = light_of(one);
    const std::vector<float> values(light.values.begin(), light.values.end());
    write_all(folder.file(one.name + ".light"),
              std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
  }
  write_all(folder.file("main.cpp"), program(all));
  for (const char* compiler : {"g++ -O1 -march=native", "g++ -O0 -DSH_EMITTED_PORTABLE", "clang++ -O1"}) {
    expect_radiance_of_relighting(folder, all, compiler);
  }
}

TEST(Emitted, CostsLessWithAMask) {
  const Transfer glossy = random_transfer(kGlossyShadowed, 4, 5);
  const EmittedCost full = emit_cpp(glossy, {"a", {}}).cost;
  const EmittedCost zonal = emit_cpp(glossy, {"a", {0, 2, 6, 12, 20}}).cost;
  EXPECT_EQ(full.operations, full.unmasked);
  EXPECT_EQ(zonal.unmasked, full.unmasked);
  EXPECT_LT(zonal.operations, full.operations / 2);
  const Transfer diffuse = random_transfer(kShadowed, 4, 5);
  const EmittedCost row = emit_cpp(diffuse, {"a", {0, 2, 6}}).cost;
  EXPECT_EQ(row.operations, 3 * 3 + 3 * 2);
  EXPECT_EQ(row.unmasked, 3 * 25 + 3 * 24);
}

TEST(Emitted, HoldsOnlyTheColumnsThatTheLightNeeds) {
  const Transfer diffuse = random_transfer(kShadowed, 4, 160);
  const auto size = [&](const std::vector<std::uint32_t>& light) {
    return emit_cpp(diffuse, {"a", light}).files[1].bytes.size();
  };
  EXPECT_EQ(size({}) - size({0, 2, 6}), 160U * 22U * 4U);
}

// 65 views of 6 numbers of 4 bytes a part, in lines of 64 bytes.
TEST(Emitted, HoldsOnlyTheBrdfsAndPartsThatItsVerticesUse) {
  const auto size = [](const Transfer& transfer) { return emit_cpp(transfer, {"a", {}}).files[1].bytes.size(); };
  const Transfer plain = random_transfer(kGlossyUnshadowed, 2, 16);
  Transfer black = plain;
  for (Eigen::Vector3f& albedo : black.mesh.albedo) albedo.setZero();
  constexpr std::size_t kNumbers = 64;  // 16 vertices, 2 bytes
  constexpr std::size_t kColors = 16 * 3 * 4;
  EXPECT_EQ(size(coated(plain, {0})), size(plain));
  EXPECT_EQ(size(coated(plain, {1})), size(plain) + 3136 + kNumbers);
  EXPECT_EQ(size(coated(plain, {3})), size(plain) + 3136 + kNumbers);
  EXPECT_EQ(size(coated(black, {1})), size(plain) - kColors + 1600 + kNumbers);
  EXPECT_EQ(size(coated(plain, {1, 2, 3})), size(plain) + 7 * 1560 + 24 + kNumbers);
  EXPECT_EQ(size(coated(plain, {0, 2})), size(plain) + 4736 + kNumbers);
}

TEST(Emitted, HasOnlyTheKernelsOfItsMaterials) {
  const auto has = [](const Transfer& transfer, const char* kernel) {
    return emit_cpp(transfer, {"a", {}}).files[0].bytes.find(kernel) != std::string::npos;
  };
  const Transfer plain = random_transfer(kGlossyUnshadowed, 2, 16);
  EXPECT_TRUE(has(plain, "zonal_l2"));
  EXPECT_FALSE(has(plain, "rotate_"));
  EXPECT_FALSE(has(coated(plain, {0}), "rotate_"));
  EXPECT_FALSE(has(coated(plain, {1}), "zonal_l2"));
  EXPECT_TRUE(has(coated(plain, {1}), "rotate_left_mirror_y_l2"));
  EXPECT_TRUE(has(coated(plain, {0, 1}), "zonal_l2"));
  EXPECT_TRUE(has(coated(plain, {0, 1}), "rotate_left_mirror_y_l2"));
  const std::string shader = emit_glsl(coated(plain, {1}), {"a", {}}, true).files[0].bytes;
  EXPECT_EQ(shader.find("zonal_l2"), std::string::npos);
  EXPECT_NE(shader.find("rotate_left_mirror_y_l2"), std::string::npos);
}

TEST(Emitted, IsTheSameEveryTime) {
  const Transfer transfer = coated(random_transfer(kGlossyShadowed, 2, 20), {0, 1, 2});
  EXPECT_EQ(emit_cpp(transfer, {"a", {}}).files[0].bytes, emit_cpp(transfer, {"a", {}}).files[0].bytes);
  EXPECT_EQ(emit_cpp(transfer, {"a", {}}).files[1].bytes, emit_cpp(transfer, {"a", {}}).files[1].bytes);
}

// What a shader captures is at most 15 vec4s, which OpenGL promises beside gl_Position. WebGL captures no arrays.
TEST(Emitted, MeetsClustersWithTheLightInAShaderOfTheirOwn) {
  const Transfer transfer = in_clusters(with_lobes(kGlossyShadowed, 4, 35), {2, 8});
  const Emitted emitted = emit_glsl(transfer, {"a", {}}, true);
  ASSERT_EQ(emitted.files.size(), 4U);
  EXPECT_EQ(emitted.files[0].bytes.find("transfer_apply_rgb_l4"), std::string::npos);
  EXPECT_EQ(emitted.files[3].name, "lit.vert");
  EXPECT_NE(emitted.files[3].bytes.find("transfer_apply_rgb_l4"), std::string::npos);
  EXPECT_EQ(emitted.files[3].bytes.find("relight_rgb_l4"), std::string::npos);
  const auto lit = nlohmann::json::parse(emitted.files[2].bytes)["lit"];
  ASSERT_EQ(lit.size(), 1U);
  EXPECT_EQ(lit[0]["rows"], transfer.clusters.count() * 9);
  EXPECT_EQ(lit[0]["parts"], 19);  // 75 numbers in vec4s
  const auto of_arrays = nlohmann::json::parse(emit_glsl(transfer, {"a", {}}, false).files[2].bytes)["lit"];
  EXPECT_EQ(of_arrays[0]["parts"], 2);
  EXPECT_EQ(emit_glsl(random_transfer(kShadowed, 2, 5), {"a", {}}, true).files.size(), 3U);
}

TEST(Emitted, RefusesATextureThatGraphicsCardsNeedNotHave) {
  const Transfer rows = random_transfer(kShadowed, kMaxDegree, 2048 * 16384 / 121 + 1);
  EXPECT_NE(message_of([&] { emit_glsl(rows, {"a", {}}, true); }).find("expected at most 33554432"), std::string::npos);
}

TEST(Emitted, RefusesWhatHasNoKernel) {
  const auto refused = [](const Transfer& transfer, const std::vector<std::uint32_t>& light,
                          const std::string& reason) {
    EXPECT_NE(message_of([&] { emit_cpp(transfer, {"a", light}); }).find(reason), std::string::npos);
  };
  refused(random_transfer(kShadowed, 1, 0), {}, "without vertices");
  refused(stored(random_transfer(kShadowed, 2, 5), Element::kHalf, {0, 2, 6}), {1},
          "no coefficient that the lights have");
}

}  // namespace
}  // namespace sh::prt::test
