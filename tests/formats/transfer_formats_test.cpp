// Transfer as glTF, PLY and NumPy arrays, read by three.js, Khronos' validator and NumPy: the numbers that come back
// give the exit radiance of prt, or are the numbers of the file to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "prt/formats/formats.hpp"
#include "prt/kinds/kinds.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/formats/readers.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/meshes.hpp"

namespace sh::prt::test {
namespace {

using Numbers = std::vector<float>;

// Random rows on a small mesh, of any kind.
Transfer random_transfer(const TransferKind& kind, int degree) {
  Transfer transfer = Transfer::of(kind, degree);
  transfer.mesh = primitive_mesh("sphere", 8);
  const std::size_t vertices = transfer.mesh.positions.size();
  const Numbers colors = random_values<float>(6 * vertices, 3);
  transfer.mesh.albedo.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (int k = 0; k < 3; ++k) transfer.mesh.albedo[v][k] = 0.5F + 0.5F * colors[3 * v + static_cast<std::size_t>(k)];
  }
  transfer.coefficients = random_values<float>(vertices * transfer.shape.length(), 5);
  if (kind.is_glossy()) {
    transfer.mesh.specular.assign(vertices, {0.25F, 0.5F, 0.75F});
    transfer.mesh.exponent.assign(vertices, 12.0F);
  }
  if (kind.stores_matrices()) {
    transfer.indirect_shape = kind.indirect(degree);
    transfer.indirect = random_values<float>(vertices * transfer.indirect_shape.length(), 7);
  }
  return transfer;
}

// The frame of glTF: x right, y up, z towards the viewer; ours is z up.
Eigen::Vector3d y_up(const Eigen::Vector3d& d) { return {d.x(), d.z(), -d.y()}; }
Eigen::Matrix3d turn_to_y_up() {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return turn;
}

class TransferFormats : public testing::Test {
 protected:
  TemporaryFolder folder;

  std::string written(const std::string& name, const Transfer& transfer) {
    write_all(folder.file("t." + name), formats::find_transfer_format(name)->write(transfer));
    return folder.file("t." + name);
  }
};

// A row of vertex v from the attributes _SH_TRANSFER_0, ... as three.js names them.
Numbers row_of(const nlohmann::json& attributes, std::size_t v, std::size_t length) {
  Numbers row;
  for (std::size_t i = 0; i < length; ++i) {
    row.push_back(attributes.at("_sh_transfer_" + std::to_string(i / 4))[4 * v + i % 4].get<float>());
  }
  return row;
}

double dot(const float* row, const double* light, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += static_cast<double>(row[i]) * light[i];
  return sum;
}

// In the axes of glTF the light's coefficients are those of the light turned with them, by the generated rotation.
TEST_F(TransferFormats, OfGltfGiveTheExitRadianceInTheAxesOfGltf) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  for (const auto& [kind, degree] :
       {std::pair(&kShadowed, 0), {&kShadowed, 4}, {&kInterreflected, 1}, {&kInterreflected, 4}, {&kShadowed, 10}}) {
    const Transfer transfer = random_transfer(*kind, degree);
    const auto read = read_by("glb", written("glb", transfer));
    const LightCoefficients light = random_light(degree, 11);
    const LightCoefficients in_gltf = turned(light, turn_to_y_up());
    const std::size_t count = transfer.shape.count();
    for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
      const Numbers row = row_of(read["attributes"], v, transfer.shape.length());
      for (std::size_t c = 0; c < transfer.shape.channels; ++c) {
        EXPECT_NEAR(dot(row.data() + c * count, &in_gltf.at(c, 0), count),
                    dot(transfer.row(v) + c * count, &light.at(c, 0), count), 5e-6)
            << kind->letters << " " << degree;
      }
    }
  }
}

// The visibility of glossy kinds is a function of direction: the same value in the same direction.
TEST_F(TransferFormats, OfGltfKeepVisibilityAndLobes) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  const Transfer transfer = random_transfer(kGlossyShadowed, 4);
  const auto read = read_by("glb", written("glb", transfer));
  ASSERT_EQ(transfer.shape.length(), 81U);
  LightCoefficients ours = LightCoefficients::zero(8);
  LightCoefficients theirs = ours;
  const Numbers row = row_of(read["attributes"], 3, 81);
  std::copy_n(transfer.row(3), 81, &ours.at(0, 0));
  std::copy_n(row.data(), 81, &theirs.at(0, 0));
  for (const Eigen::Vector3d& d : {Eigen::Vector3d(0, 0, 1), kSlanted, Eigen::Vector3d(-0.6, 0, 0.8)}) {
    EXPECT_NEAR(radiance(theirs, y_up(d)).x(), radiance(ours, d).x(), 1e-5);
  }
  EXPECT_EQ(read["attributes"]["_exponent"][3], 12);
  EXPECT_EQ(read["attributes"]["_specular"][10], 0.5);
}

TEST_F(TransferFormats, OfGltfKeepTheMesh) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  Transfer transfer = random_transfer(kUnshadowed, 2);
  transfer.mesh.frame = {{1e6, -2e6, 3e6}, 0.25};
  transfer.emitted.assign(transfer.mesh.positions.size(), {1, 2, 3});
  const auto read = read_by("glb", written("glb", transfer));
  const auto& attributes = read["attributes"];
  const auto matrix = read["matrix"].get<std::vector<double>>();  // column by column
  for (std::size_t v = 0; v < transfer.mesh.positions.size(); ++v) {
    const Eigen::Vector3d expected = y_up(transfer.mesh.point(v));
    const Eigen::Vector3d normal = y_up(transfer.mesh.normals[v].cast<double>());
    for (std::size_t k = 0; k < 3; ++k) {
      const double local = attributes["position"][3 * v + k].get<double>();
      EXPECT_NEAR(matrix[5 * k] * local + matrix[12 + k], expected[static_cast<int>(k)], 1e-6);
      EXPECT_EQ(attributes["normal"][3 * v + k].get<double>(), normal[static_cast<int>(k)]);
      EXPECT_EQ(attributes["color"][3 * v + k].get<float>(), transfer.mesh.albedo[v][static_cast<int>(k)]);
      EXPECT_EQ(attributes["_emitted"][3 * v + k], k + 1);
    }
  }
  ASSERT_EQ(read["indices"].size(), 3 * transfer.mesh.faces.size());
  EXPECT_EQ(read["indices"][4], transfer.mesh.faces[1][1]);
}

TEST_F(TransferFormats, OfGltfAreValid) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  for (const TransferKind* kind : {&kUnshadowed, &kShadowed, &kInterreflected, &kGlossyUnshadowed, &kGlossyShadowed}) {
    const auto found = read_by("validate", written("glb", random_transfer(*kind, 3)));
    EXPECT_EQ(found["errors"], 0) << found;
    EXPECT_EQ(found["warnings"], 0) << found;
    for (const auto& message : found["messages"]) EXPECT_EQ(message["code"], "UNSUPPORTED_EXTENSION") << message;
  }
}

TEST_F(TransferFormats, OfPlyHaveTheNumbersToTheBit) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  for (const auto& [kind, degree] : {std::pair(&kShadowed, 4), {&kInterreflected, 2}, {&kGlossyShadowed, 2}}) {
    const Transfer transfer = random_transfer(*kind, degree);
    const auto read = read_by("ply", written("ply", transfer));
    EXPECT_EQ(read["width"], transfer.shape.length());
    EXPECT_EQ(read["transfer"].get<Numbers>(), transfer.coefficients);
    const std::size_t last = transfer.mesh.positions.size() - 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = static_cast<int>(k);
      EXPECT_EQ(read["positions"][3 * last + k].get<float>(), transfer.mesh.positions[last][i]);
      EXPECT_EQ(read["normals"][3 * last + k].get<float>(), transfer.mesh.normals[last][i]);
      EXPECT_EQ(read["albedo"][3 * last + k].get<float>(), transfer.mesh.albedo[last][i]);
    }
    EXPECT_EQ(read["indices"].size(), 3 * transfer.mesh.faces.size());
  }
}

TEST_F(TransferFormats, OfNumPyHaveEveryArray) {
  if (const std::string why = no_numpy(); !why.empty()) GTEST_SKIP() << why;
  for (const TransferKind* kind : transfer_kinds()) {
    Transfer transfer = random_transfer(*kind, 2);
    transfer.scene = "sphère";
    transfer.emitted.assign(transfer.mesh.positions.size(), {1, 2, 3});
    const auto read = printed_by(std::string(kPython) + " " SHFORGE_SOURCE_DIR "/tests/formats/read_npz.py " +
                                 written("npz", transfer));
    const std::size_t vertices = transfer.mesh.positions.size();
    using Sizes = std::vector<std::size_t>;
    EXPECT_EQ(read["positions"]["dtype"], "float64");
    EXPECT_EQ(read["faces"]["shape"], (Sizes{transfer.mesh.faces.size(), 3}));
    EXPECT_EQ(read["faces"]["values"][4], transfer.mesh.faces[1][1]);
    EXPECT_EQ(read["albedo"]["values"][4].get<float>(), transfer.mesh.albedo[1][1]);
    EXPECT_EQ(read["emitted"]["values"][5], 3);
    const auto header = nlohmann::json::parse(read["header"]["values"][0].get<std::string>());
    EXPECT_EQ(header["scene"], "sphère");
    EXPECT_EQ(read.contains("transfer"), kind->stores_numbers());
    if (kind->stores_numbers()) {
      EXPECT_EQ(read["transfer"]["shape"],
                (Sizes{vertices, transfer.shape.channels, transfer.shape.rows(), transfer.shape.columns()}));
      EXPECT_EQ(read["transfer"]["values"].get<Numbers>(), transfer.coefficients);
    }
    EXPECT_EQ(read.contains("indirect"), kind->stores_matrices());
    if (kind->stores_matrices()) {
      EXPECT_EQ(read["indirect"]["values"].get<Numbers>(), transfer.indirect);
    }
  }
}

TEST_F(TransferFormats, AreTheSameBytesEveryTime) {
  const Transfer transfer = random_transfer(kShadowed, 4);
  for (const formats::TransferFormat& format : formats::transfer_formats()) {
    EXPECT_EQ(format.write(transfer), format.write(transfer)) << format.name;
  }
}

TEST_F(TransferFormats, OfVerticesRefuseMatrices) {
  const Transfer transfer = random_transfer(kGlossyInterreflected, 2);
  for (const char* name : {"glb", "ply"}) {
    const std::string message = message_of([&] { formats::find_transfer_format(name)->write(transfer); });
    EXPECT_NE(message.find("no matrices of light between surfaces (kind GI); expected another kind, or the format npz"),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace sh::prt::test
