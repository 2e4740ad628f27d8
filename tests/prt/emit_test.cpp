// Emitted run times, compiled and run, against the relighting of the library.
#include "prt/emit/emit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/storage.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const Eigen::Vector3d kEye(1.5, -2.0, 3.0);

struct Case {
  std::string name;
  Transfer transfer;
  std::vector<std::uint32_t> light = {};  // the coefficients that the light has; empty: all
};

// As a file holds it.
Transfer stored(Transfer transfer, Element element, std::vector<std::uint32_t> kept = {}, bool one_channel = false) {
  transfer.shape.storage = {element, one_channel, std::move(kept)};
  transfer.coefficients = decode(encode(transfer.coefficients, transfer.shape), transfer.shape);
  return transfer;
}

Transfer with_lobes(const TransferKind& kind, int degree, std::size_t vertices, const TransferShape& indirect = {}) {
  Transfer transfer = random_transfer(kind, degree, vertices);
  transfer.mesh.specular = transfer.mesh.albedo;
  for (std::size_t v = 0; v < vertices; ++v) {
    transfer.mesh.specular[v] *= 0.5F;
    transfer.mesh.exponent.push_back(static_cast<float>(v) * 7.5F);
    transfer.mesh.normals[v] = Eigen::Vector3f(0.1F * static_cast<float>(v % 7), -0.3F, 0.8F).normalized();
  }
  if (kind.indirect != nullptr) {
    transfer.indirect_shape = indirect;
    transfer.indirect = random_values(vertices * indirect.length(), 91);
    transfer.indirect = decode(encode(transfer.indirect, indirect), indirect);
  }
  return transfer;
}

TransferShape matrices(int degree, std::size_t channels, Element element) {
  TransferShape shape = kGlossyInterreflected.indirect(degree);
  shape.channels = channels;
  shape.storage.element = element;
  return shape;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"one_vertex", random_transfer(kShadowed, 0, 1)});
  all.push_back({"single", random_transfer(kShadowed, 4, 32)});
  all.push_back({"half", stored(random_transfer(kShadowed, 4, 37), Element::kHalf)});
  all.push_back({"byte_kept", stored(random_transfer(kShadowed, 4, 37), Element::kByte, {0, 2, 6, 12, 20})});
  all.push_back({"normals", stored(random_transfer(kUnshadowed, kMaxDegree, 17), Element::kHalf)});
  all.push_back({"colored_byte", stored(random_transfer(kInterreflected, 4, 33), Element::kByte)});
  all.push_back({"gray_bounces", stored(random_transfer(kInterreflected, 2, 16), Element::kHalf, {}, true)});
  Transfer emitting = random_transfer(kInterreflected, 2, 15);
  emitting.emitted = emitting.mesh.albedo;
  all.push_back({"emitting_masked", emitting, {0, 2, 6}});
  all.push_back({"glossy_unshadowed", with_lobes(kGlossyUnshadowed, 3, 18)});
  all.push_back({"glossy", with_lobes(kGlossyShadowed, 4, 35)});
  all.push_back({"glossy_constant", with_lobes(kGlossyShadowed, 0, 5)});
  all.push_back({"glossy_half", stored(with_lobes(kGlossyShadowed, 2, 16), Element::kHalf)});
  all.push_back({"glossy_zonal", with_lobes(kGlossyShadowed, 4, 16), {0, 2, 6, 12, 20}});
  Transfer dull = with_lobes(kGlossyShadowed, 1, 9);
  dull.mesh.specular.clear();
  dull.mesh.exponent.clear();
  all.push_back({"dull", dull});
  Transfer black = with_lobes(kGlossyShadowed, 3, 9);
  for (Eigen::Vector3f& albedo : black.mesh.albedo) albedo.setZero();
  all.push_back({"mirror_like", black});
  all.push_back({"bounces", with_lobes(kGlossyInterreflected, 1, 17, matrices(1, 3, Element::kSingle))});
  all.push_back(
      {"bounces_gray_zonal", with_lobes(kGlossyInterreflected, 2, 17, matrices(2, 1, Element::kHalf)), {0, 2, 6}});
  return all;
}

LightCoefficients light_of(const Case& one) {
  LightCoefficients light = random_light(one.transfer.degree(), 77);
  const std::vector<std::uint32_t>& kept = one.light.empty() ? one.transfer.shape.storage.kept : one.light;
  for (std::size_t i = 0; !kept.empty() && i < light.values.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i % light.bands_squared());
    if (std::find(kept.begin(), kept.end(), index) == kept.end()) light.values[i] = 0.0;
  }
  return light;
}

std::vector<Eigen::Vector3f> expected(const Case& one) {
  const LightCoefficients light = light_of(one);
  if (!one.transfer.kind->is_glossy()) return relight(one.transfer, light);
  return exit_radiance(one.transfer, TransferredRadiance(one.transfer, light), kEye, one.transfer.mesh.albedo);
}

// A program that relights every case and writes NAME.out; white: under the first channel of the light alone.
std::string program(const std::vector<Case>& all) {
  std::string text = "#include <cstdio>\n#include <fstream>\n#include <iterator>\n#include <vector>\n";
  for (const Case& one : all) text += fmt::format("#include \"{}/relight.hpp\"\n", one.name);
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
  for (const Case& one : all) {
    const bool glossy = one.transfer.kind->is_glossy();
    text += fmt::format(R"(  {{
    namespace run = sh_{0};
    const auto bytes = read<unsigned char>("{0}/relight.bin");
    if (!run::is_data(bytes.data(), bytes.size()) || run::is_data(bytes.data(), bytes.size() - 1)) return 1;
    const auto light = read<float>("{0}.light");
    std::vector<float> radiance(3 * run::kVertices);
    const auto prepared = run::prepared(light.data());
    for (std::size_t block = 0; block < run::kBlocks; ++block) {{
      run::relight(run::data_of(bytes.data()), prepared, {1}radiance.data(), block, block + 1);
    }}
    write("{0}.out", radiance);
)",
                        one.name, glossy ? "eye, " : "");
    if (!glossy) {
      text += fmt::format(
          R"(    run::relight_white(run::data_of(bytes.data()), run::prepared_white(light.data()), radiance.data());
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

void expect_near(const std::vector<Eigen::Vector3f>& got, const std::vector<Eigen::Vector3f>& wanted,
                 const std::string& name) {
  ASSERT_EQ(got.size(), wanted.size()) << name;
  float largest = 1e-3F;
  for (const Eigen::Vector3f& value : wanted) largest = std::max(largest, value.cwiseAbs().maxCoeff());
  for (std::size_t v = 0; v < got.size(); ++v) {
    EXPECT_LT((got[v] - wanted[v]).cwiseAbs().maxCoeff(), 4e-6F * largest) << name << " " << v;
  }
}

void expect_radiance_of_relighting(const TemporaryFolder& folder, const std::vector<Case>& all,
                                   const std::string& compiler) {
  SCOPED_TRACE(compiler);
  const std::string built = fmt::format(
      "cd '{}' && {} -std=c++17 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror main.cpp -o main && ./main",
      folder.path().string(), compiler);
  ASSERT_EQ(std::system(built.c_str()), 0);  // NOLINT(cert-env33-c): a fixed command line
  for (const Case& one : all) {
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
  const std::vector<Case> all = cases();
  for (const Case& one : all) {
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

TEST(Emitted, IsTheSameEveryTime) {
  const Transfer transfer = random_transfer(kGlossyShadowed, 2, 20);
  EXPECT_EQ(emit_cpp(transfer, {"a", {}}).files[0].bytes, emit_cpp(transfer, {"a", {}}).files[0].bytes);
  EXPECT_EQ(emit_cpp(transfer, {"a", {}}).files[1].bytes, emit_cpp(transfer, {"a", {}}).files[1].bytes);
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
