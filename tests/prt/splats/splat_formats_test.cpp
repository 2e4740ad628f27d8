// GLB and SPZ files of splats, read here from the texts of their specifications, and round trips between all formats.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prt/chunks.hpp"
#include "prt/splats/convert_splats.hpp"
#include "prt/splats/spz_codes.hpp"
#include "tests/prt/splats/splat_cases.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

const Eigen::Matrix3d kPlyToGlb = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();  // right down front, left up front
const Eigen::Matrix3d kPlyToSpz = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();  // right up back

/// The bytes of out.ENDING made from the splats.
std::string written(const Splats& splats, const std::string& ending, const SplatEdit& edit = {}) {
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), ply_of(splats));
  convert_splats(folder.file("in.ply"), folder.file("out" + ending), edit);
  return read_all(folder.file("out" + ending));
}

/// The splats of a file of any format, by way of a PLY file.
Splats read_back(const std::string& bytes, const SplatEdit& edit = {}) {
  const TemporaryFolder folder;
  write_all(folder.file("in"), bytes);
  convert_splats(folder.file("in"), folder.file("out.ply"), edit);
  return splats_of_ply(read_all(folder.file("out.ply")));
}

SplatEdit keeping_axes(const std::string& axes) {
  SplatEdit edit;
  edit.axes_in = edit.axes_out = axes;
  return edit;
}

/// What the text of KHR_gaussian_splatting and glTF say of a file.
class Gltf {
 public:
  explicit Gltf(std::string bytes) : bytes_(std::move(bytes)) {
    std::uint32_t size = 0;
    std::memcpy(&size, &bytes_[12], 4);
    json = nlohmann::json::parse(bytes_.substr(20, size));
    binary_ = 20 + size + 8;
  }
  std::vector<double> value(const std::string& attribute, std::size_t splat) const {
    const auto& primitive = json.at("/meshes/0/primitives/0"_json_pointer);
    const auto& accessor = json.at("accessors").at(primitive.at("attributes").at(attribute).get<std::size_t>());
    const auto& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const std::string type = accessor.at("type");
    const std::size_t count = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    EXPECT_EQ(accessor.at("componentType"), 5126);
    const std::size_t offset = binary_ + view.value("byteOffset", std::size_t{0}) +
                               accessor.value("byteOffset", std::size_t{0}) +
                               splat * view.value("byteStride", 4 * count);
    std::vector<float> numbers(count);
    std::memcpy(numbers.data(), &bytes_[offset], 4 * count);
    return {numbers.begin(), numbers.end()};
  }

  nlohmann::json json;

 private:
  std::string bytes_;
  std::size_t binary_;
};

TEST(SplatGlb, HoldsTheAttributesOfTheExtension) {
  for (int degree = 0; degree <= 3; ++degree) {
    SCOPED_TRACE(degree);
    const Splats splats = random_splats(30, degree, 40);
    const Gltf file(written(splats, ".glb", keeping_axes("LUF")));
    const auto& primitive = file.json.at("/meshes/0/primitives/0"_json_pointer);
    EXPECT_EQ(primitive.at("mode"), 0);
    EXPECT_EQ(primitive.at("extensions").at("KHR_gaussian_splatting").at("colorSpace"), "srgb_rec709_display");
    EXPECT_EQ(file.json.at("extensionsUsed").at(0), "KHR_gaussian_splatting");
    EXPECT_EQ(primitive.at("attributes").size(), 5U + static_cast<std::size_t>((degree + 1) * (degree + 1)));
    for (std::size_t i = 0; i < splats.size(); ++i) {
      const Splat& splat = splats[i];
      const Eigen::Vector4d q = splat.rotation.normalized();
      const auto rotation = file.value("KHR_gaussian_splatting:ROTATION", i);
      const auto scale = file.value("KHR_gaussian_splatting:SCALE", i);
      for (Eigen::Index k = 0; k < 3; ++k) {
        EXPECT_EQ(file.value("POSITION", i)[static_cast<std::size_t>(k)], splat.position[k]);
        EXPECT_NEAR(rotation[static_cast<std::size_t>(k)], q[k + 1], 6e-8);
        EXPECT_NEAR(scale[static_cast<std::size_t>(k)], std::exp(splat.log_scale[k]),
                    6e-8 * std::exp(splat.log_scale[k]));
      }
      EXPECT_NEAR(rotation[3], q[0], 6e-8);
      EXPECT_NEAR(file.value("KHR_gaussian_splatting:OPACITY", i)[0], 1.0 / (1.0 + std::exp(-splat.opacity)), 6e-8);
      for (int l = 0; l <= degree; ++l) {
        for (int n = 0; n <= 2 * l; ++n) {
          const auto c = file.value(fmt::format("KHR_gaussian_splatting:SH_DEGREE_{}_COEF_{}", l, n), i);
          for (int channel = 0; channel < 3; ++channel) {
            EXPECT_EQ(c[static_cast<std::size_t>(channel)], splat.coefficients(channel, l * l + n));
          }
        }
      }
    }
  }
}

TEST(SplatGlb, StatesTheBoxOfItsPositions) {
  const Splats splats = random_splats(3000, 0, 41);
  const Gltf file(written(splats, ".glb"));
  Eigen::AlignedBox3d box;
  for (const Splat& splat : splats) box.extend(Eigen::Vector3d(kPlyToGlb * splat.position));
  const auto& accessor = file.json.at("accessors").at(0);
  for (Eigen::Index k = 0; k < 3; ++k) {
    EXPECT_EQ(accessor.at("min").at(static_cast<std::size_t>(k)), box.min()[k]);
    EXPECT_EQ(accessor.at("max").at(static_cast<std::size_t>(k)), box.max()[k]);
  }
  EXPECT_EQ(accessor.at("count"), 3000);
}

TEST(SplatGlb, ComesBackWithTheSameNumbers) {
  for (int degree = 0; degree <= 3; ++degree) {
    const Splats splats = random_splats(3000, degree, 42);
    const Splats back = read_back(written(splats, ".glb"));
    ASSERT_EQ(back.size(), splats.size());
    for (std::size_t i = 0; i < splats.size(); ++i) {
      SCOPED_TRACE(i);
      ASSERT_EQ(back[i].position, splats[i].position);
      ASSERT_EQ(back[i].coefficients, splats[i].coefficients);
      const Eigen::Vector4d q = splats[i].rotation.normalized();
      ASSERT_LE(std::min((back[i].rotation - q).norm(), (back[i].rotation + q).norm()), 1.2e-7);
      // A rounding of the scale is an absolute error of its logarithm.
      ASSERT_LE((back[i].log_scale - splats[i].log_scale).cwiseAbs().maxCoeff(),
                6e-8 + 6e-8 * splats[i].log_scale.norm());
      // The logit's slope is 1 / (a (1 - a)); opacities that round to 1 come back as such.
      const double a = 1.0 / (1.0 + std::exp(-splats[i].opacity));
      if (std::abs(splats[i].opacity) < 10.0) {
        ASSERT_NEAR(back[i].opacity, splats[i].opacity, 6e-8 * (8.0 + 1.0 / (1.0 - a)));
      }
      ASSERT_EQ(static_cast<float>(1.0 / (1.0 + std::exp(-back[i].opacity))), static_cast<float>(a));
    }
  }
}

TEST(SplatGlb, HoldsFlatOpaqueAndTransparentSplats) {
  const double infinity = std::numeric_limits<double>::infinity();
  Splats splats = random_splats(3, 0, 43);
  splats[0].opacity = infinity;
  splats[1].opacity = -infinity;
  splats[2].log_scale[1] = -infinity;
  const std::string bytes = written(splats, ".glb");
  const Gltf file(bytes);
  EXPECT_EQ(file.value("KHR_gaussian_splatting:OPACITY", 0)[0], 1.0);
  EXPECT_EQ(file.value("KHR_gaussian_splatting:OPACITY", 1)[0], 0.0);
  EXPECT_EQ(file.value("KHR_gaussian_splatting:SCALE", 2)[1], 0.0);
  const Splats back = read_back(bytes);
  EXPECT_TRUE(std::isfinite(back[0].opacity) && std::isfinite(back[1].opacity) && std::isfinite(back[2].log_scale[1]));
  const Gltf again(written(back, ".glb"));
  EXPECT_EQ(again.value("KHR_gaussian_splatting:OPACITY", 0)[0], 1.0);
  EXPECT_EQ(again.value("KHR_gaussian_splatting:OPACITY", 1)[0], 0.0);
  EXPECT_EQ(again.value("KHR_gaussian_splatting:SCALE", 2)[1], 0.0);
}

/// A GLB file of one splat with attributes of these component types, and a node.
std::string small_glb(const nlohmann::json& node, bool quantized) {
  std::string binary;
  nlohmann::json accessors = nlohmann::json::array();
  nlohmann::json views = nlohmann::json::array();
  nlohmann::json attributes;
  const auto add = [&](const std::string& name, int type, bool normalized, const std::string& shape,
                       const auto& values) {
    attributes[name] = accessors.size();
    accessors.push_back({{"bufferView", views.size()}, {"componentType", type}, {"count", 1}, {"type", shape}});
    if (normalized) accessors.back()["normalized"] = true;
    const std::size_t size = values.size() * sizeof values[0];
    views.push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", size}});
    binary.append(reinterpret_cast<const char*>(values.data()), size);
    binary.resize((binary.size() + 3) / 4 * 4);
  };
  const std::string prefix = "KHR_gaussian_splatting:";
  add("POSITION", 5126, false, "VEC3", std::array{1.0F, 2.0F, 3.0F});
  if (quantized) {
    add(prefix + "ROTATION", 5122, true, "VEC4", std::array<std::int16_t, 4>{0, 0, 23170, 23170});
    add(prefix + "SCALE", 5123, true, "VEC3", std::array<std::uint16_t, 3>{65535, 6554, 0});
    add(prefix + "OPACITY", 5121, true, "SCALAR", std::array<std::uint8_t, 1>{51});
  } else {
    const float root = std::sqrt(0.5F);
    add(prefix + "ROTATION", 5126, false, "VEC4", std::array{0.0F, 0.0F, root, root});
    add(prefix + "SCALE", 5126, false, "VEC3", std::array{1.0F, 0.1F, 0.0F});
    add(prefix + "OPACITY", 5126, false, "SCALAR", std::array{0.2F});
  }
  add(prefix + "SH_DEGREE_0_COEF_0", 5126, false, "VEC3", std::array{0.1F, 0.2F, 0.3F});
  for (int n = 0; n < 3; ++n) {
    add(fmt::format("{}SH_DEGREE_1_COEF_{}", prefix, n), 5126, false, "VEC3", std::array{float(n), 0.0F, -0.5F});
  }
  const nlohmann::json extension = {{"kernel", "ellipse"}, {"colorSpace", "srgb_rec709_display"}};
  const nlohmann::json document = {
      {"asset", {{"version", "2.0"}}},
      {"extensionsUsed", {"KHR_gaussian_splatting"}},
      {"nodes", {{{"children", {1}}, {"translation", {10, 0, 0}}}, node}},
      {"meshes",
       {{{"primitives",
          {{{"attributes", attributes}, {"mode", 0}, {"extensions", {{"KHR_gaussian_splatting", extension}}}}}}}}},
      {"accessors", accessors},
      {"bufferViews", views},
      {"buffers", {{{"byteLength", binary.size()}}}}};
  std::string json = document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t value) {
    const auto small = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&small), 4);
  };
  return "glTF" + number(2) + number(28 + json.size() + binary.size()) + number(json.size()) + "JSON" + json +
         number(binary.size()) + std::string("BIN\0", 4) + binary;
}

TEST(SplatGlb, ReadsEveryComponentTypeOfTheExtension) {
  const nlohmann::json node = {{"mesh", 0}};
  const Splat whole = read_back(small_glb(node, false)).at(0);
  const Splat quantized = read_back(small_glb(node, true)).at(0);
  EXPECT_LE((whole.rotation - quantized.rotation).norm(), 1e-4);
  EXPECT_LE((whole.log_scale.array().exp() - quantized.log_scale.array().exp()).matrix().norm(), 1e-5);
  EXPECT_NEAR(whole.opacity, quantized.opacity, 1e-6);
  EXPECT_EQ(whole.coefficients, quantized.coefficients);
}

TEST(SplatGlb, PlacesSplatsAsItsNodesSay) {
  const Splat still = read_back(small_glb({{"mesh", 0}}, false)).at(0);
  EXPECT_EQ(still.position, kPlyToGlb * Eigen::Vector3d(11.0, 2.0, 3.0));
  const double root = std::sqrt(0.5);
  const Splat placed =
      read_back(
          small_glb({{"mesh", 0}, {"rotation", {root, 0, 0, root}}, {"scale", {2, 2, 2}}, {"translation", {0, 5, 0}}},
                    false))
          .at(0);
  const Eigen::Matrix3d quarter = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Vector3d position = 2.0 * (quarter * Eigen::Vector3d(1.0, 2.0, 3.0)) + Eigen::Vector3d(10.0, 5.0, 0.0);
  EXPECT_LE((placed.position - kPlyToGlb * position).norm(), 1e-5);
  EXPECT_LE(color_difference(still, placed, kPlyToGlb * quarter * kPlyToGlb.transpose()), 1e-5);
  SplatEdit edit;
  edit.similarity = {Eigen::Matrix3d::Identity(), 3.0, Eigen::Vector3d(1.0, 0.0, 0.0)};
  const Splat edited = read_back(small_glb({{"mesh", 0}}, false), edit).at(0);
  EXPECT_LE((edited.position - kPlyToGlb * Eigen::Vector3d(34.0, 6.0, 9.0)).norm(), 1e-5) << "the edit moves the scene";
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = 2.0 * quarter;
  matrix.topRightCorner<3, 1>() = Eigen::Vector3d(0.0, 5.0, 0.0);
  const nlohmann::json node = {{"mesh", 0}, {"matrix", std::vector<double>(matrix.data(), matrix.data() + 16)}};
  const Splat by_matrix = read_back(small_glb(node, false)).at(0);
  EXPECT_LE((by_matrix.position - placed.position).norm(), 1e-5);
  EXPECT_LE((by_matrix.coefficients - placed.coefficients).norm(), 1e-6);
}

TEST(SplatGlb, RefusesNodesThatStretchOrMirror) {
  for (const auto& scale : {nlohmann::json{2, 1, 2}, nlohmann::json{-1, 1, 1}, nlohmann::json{0, 0, 0}}) {
    EXPECT_NE(message_of([&] {
                read_back(small_glb({{"mesh", 0}, {"scale", scale}}, false));
              }).find("stretches or mirrors"),
              std::string::npos)
        << scale;
  }
}

std::string unzipped(const std::string& bytes) {
  const TemporaryFolder folder;
  write_all(folder.file("a.gz"), bytes);
  gzFile file = gzopen(folder.file("a.gz").c_str(), "rb");
  std::string all;
  std::array<char, 4096> part;
  for (int got = 1; got > 0;) {
    got = gzread(file, part.data(), part.size());
    EXPECT_GE(got, 0);
    all.append(part.data(), static_cast<std::size_t>(std::max(got, 0)));
  }
  gzclose(file);
  return all;
}

/// A splat of an SPZ file of version 2 or 3, by the words of its description.
Splat splat_of_spz(const std::string& file, std::size_t splat) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(file[at]); };
  std::uint32_t version = 0;
  std::uint32_t count = 0;
  std::memcpy(&version, &file[4], 4);
  std::memcpy(&count, &file[8], 4);
  const Eigen::Index size = (byte(12) + 1) * (byte(12) + 1);
  std::size_t at = 16;
  const auto part = [&](std::size_t bytes) {
    const std::size_t start = at + bytes * splat;
    at += bytes * count;
    return start;
  };
  Splat s;
  const std::size_t position = part(9);
  for (std::size_t k = 0; k < 3; ++k) {
    std::int32_t fixed = byte(position + 3 * k) | byte(position + 3 * k + 1) << 8 | byte(position + 3 * k + 2) << 16;
    if (fixed >= 1 << 23) fixed -= 1 << 24;
    s.position[static_cast<Eigen::Index>(k)] = fixed / std::exp2(byte(13));
  }
  const double alpha = byte(part(1)) / 255.0;
  s.opacity = std::log(alpha / (1.0 - alpha));
  s.coefficients.resize(3, size);
  const std::size_t color = part(3);
  for (std::size_t k = 0; k < 3; ++k)
    s.coefficients(static_cast<Eigen::Index>(k), 0) = (byte(color + k) / 255.0 - 0.5) / 0.15;
  const std::size_t scale = part(3);
  for (std::size_t k = 0; k < 3; ++k) s.log_scale[static_cast<Eigen::Index>(k)] = byte(scale + k) / 16.0 - 10.0;
  const std::size_t rotation = part(version == 2 ? 3 : 4);
  Eigen::Vector4d xyzw = Eigen::Vector4d::Zero();
  if (version == 2) {
    for (std::size_t k = 0; k < 3; ++k) xyzw[static_cast<Eigen::Index>(k)] = byte(rotation + k) / 127.5 - 1.0;
    xyzw[3] = std::sqrt(std::max(0.0, 1.0 - xyzw.squaredNorm()));
  } else {
    std::uint32_t code = 0;
    std::memcpy(&code, &file[rotation], 4);
    const auto largest = static_cast<Eigen::Index>(code / (1U << 30U));
    for (Eigen::Index k = 3; k >= 0; --k) {
      if (k == largest) continue;
      const double magnitude = code % 512 / 511.0 * std::sqrt(0.5);
      xyzw[k] = code / 512 % 2 == 1 ? -magnitude : magnitude;
      code /= 1024;
    }
    xyzw[largest] = std::sqrt(1.0 - xyzw.squaredNorm());
  }
  s.rotation = {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
  const std::size_t rest = part(3 * static_cast<std::size_t>(size - 1));
  for (Eigen::Index k = 1; k < size; ++k) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      s.coefficients(c, k) = (byte(rest + static_cast<std::size_t>(3 * (k - 1) + c)) - 128.0) / 128.0;
    }
  }
  EXPECT_EQ(at, file.size());
  return s;
}

SplatEdit spz_edit(int version, int first_bits = 5, int higher_bits = 4) {
  SplatEdit edit = keeping_axes("RUB");
  edit.spz = {version, first_bits, higher_bits};
  return edit;
}

/// Within half of every step of the format; `bits` of coefficients.
void expect_near(const Splat& from, const Splat& to, double position_step, int version, int first_bits,
                 int higher_bits) {
  EXPECT_LE((from.position - to.position).cwiseAbs().maxCoeff(), 0.5 * position_step + 1e-7);
  EXPECT_LE((from.log_scale - to.log_scale).cwiseAbs().maxCoeff(), 0.5 / 16.0 + 1e-6);
  const auto alpha = [](double logit) { return 1.0 / (1.0 + std::exp(-logit)); };
  EXPECT_NEAR(alpha(from.opacity), alpha(to.opacity), 0.5 / 255.0 + 1e-6);
  EXPECT_LE((from.coefficients.col(0) - to.coefficients.col(0)).cwiseAbs().maxCoeff(), 0.5 / (0.15 * 255.0) + 1e-6);
  for (Eigen::Index k = 1; k < from.coefficients.cols(); ++k) {
    const double step = std::exp2(1.0 - (k < 4 ? first_bits : higher_bits));
    EXPECT_LE((from.coefficients.col(k) - to.coefficients.col(k)).cwiseAbs().maxCoeff(), 0.5 * step + 1e-6) << k;
  }
  const double cosine = std::abs(from.rotation.normalized().dot(to.rotation.normalized()));
  const double step = version == 2 ? 1.0 / 127.5 : std::sqrt(0.5) / 511.0;
  // Three components are half a step off; in version 2 w may be small, and then carries the most of it.
  const double chord = std::sqrt(std::max(0.0, 2.0 - 2.0 * cosine));
  EXPECT_LE(chord, version == 2 ? std::sqrt(2.0 * step) : 2.0 * step);
}

TEST(SplatSpz, HoldsWhatItsDescriptionSays) {
  for (const int version : {2, 3}) {
    for (int degree = 0; degree <= 3; ++degree) {
      SCOPED_TRACE(testing::Message() << "version " << version << ", degree " << degree);
      const Splats splats = random_splats(300, degree, 50);
      const std::string bytes = unzipped(written(splats, ".spz", spz_edit(version)));
      EXPECT_EQ(bytes.substr(0, 4), "NGSP");
      EXPECT_EQ(bytes[4], version);
      EXPECT_EQ(bytes[13], 12);
      for (std::size_t i = 0; i < splats.size(); ++i) {
        expect_near(splats[i], splat_of_spz(bytes, i), 1.0 / 4096.0, version, 5, 4);
      }
    }
  }
}

TEST(SplatSpz, ComesBackWithinItsSteps) {
  for (const int version : {2, 3, 4}) {
    for (const int bits : {1, 4, 8}) {
      SCOPED_TRACE(testing::Message() << "version " << version << ", bits " << bits);
      const Splats splats = random_splats(3000, version == 4 ? 4 : 3, 51);
      SplatEdit edit;
      edit.spz = {version, bits, bits};
      const std::string bytes = written(splats, ".spz", edit);
      const Splats back = read_back(bytes);
      ASSERT_EQ(back.size(), splats.size());
      for (std::size_t i = 0; i < splats.size(); ++i) {
        expect_near(splats[i], back[i], 1.0 / 4096.0, version, bits, bits);
      }
      const Splats again = read_back(written(back, ".spz", edit));
      for (std::size_t i = 0; i < splats.size(); ++i) {
        ASSERT_EQ(again[i].position, back[i].position);
        ASSERT_EQ(again[i].coefficients, back[i].coefficients) << "rounded numbers stay";
        ASSERT_EQ(again[i].log_scale, back[i].log_scale);
        ASSERT_EQ(again[i].opacity, back[i].opacity);
      }
    }
  }
}

TEST(SplatSpz, TurnsAxesRightUpBack) {
  const Splats splats = random_splats(8, 3, 52);
  SplatEdit edit;
  edit.spz = {3, 8, 8};
  const std::string bytes = unzipped(written(splats, ".spz", edit));
  for (std::size_t i = 0; i < splats.size(); ++i) {
    const Splat splat = splat_of_spz(bytes, i);
    EXPECT_LE((splat.position - kPlyToSpz * splats[i].position).cwiseAbs().maxCoeff(), 1.0 / 4096.0);
    EXPECT_LE(color_difference(splats[i], splat, kPlyToSpz), 0.1);
    const Eigen::Matrix3d covariance = kPlyToSpz * covariance_of(splats[i]) * kPlyToSpz.transpose();
    EXPECT_LE((covariance_of(splat) - covariance).norm(), 0.1 * covariance.norm());
  }
}

TEST(SplatSpz, TakesFewerFractionalBitsForLargeScenes) {
  Splats splats = random_splats(20, 0, 53);
  for (const double reach : {2047.875, 2048.0, 30000.0, 8388607.0}) {
    SCOPED_TRACE(reach);
    splats[9].position = {reach, -reach, 0.5};
    const std::string bytes = unzipped(written(splats, ".spz", spz_edit(3)));
    const double step = std::exp2(-bytes[13]);
    EXPECT_TRUE(bytes[13] == 12 || 2.0 * reach / step > (1 << 23) - 1) << "as many bits as fit";
    for (std::size_t i = 0; i < splats.size(); ++i) {
      EXPECT_LE((splat_of_spz(bytes, i).position - splats[i].position).cwiseAbs().maxCoeff(), 0.5 * step + 1e-6);
    }
  }
  splats[9].position = {0.0, 9e6, 0.0};
  EXPECT_NE(message_of([&] { written(splats, ".spz"); }).find("beyond the range of SPZ"), std::string::npos);
}

TEST(SplatSpz, SaysWhatItClamps) {
  Splats splats = random_splats(20, 1, 54);
  const auto losses = [&] {
    const TemporaryFolder folder;
    write_all(folder.file("in.ply"), ply_of(splats));
    return convert_splats(folder.file("in.ply"), folder.file("out.spz"), {}).losses;
  };
  EXPECT_EQ(losses(), "");
  splats[3].coefficients(1, 2) = 1.4;
  splats[5].log_scale[0] = -11.0;
  splats[6].coefficients(0, 0) = -5.0;
  EXPECT_EQ(losses(), "3 splats have numbers beyond the ranges of SPZ, which were clamped");
}

TEST(SplatSpz, RoundsEveryQuaternionWithinItsStep) {
  const Splats random = random_splats(2000, 0, 55);
  std::vector<Eigen::Vector4d> all = {{1, 0, 0, 0},   {0, 1, 0, 0},  {0, 0, 0, -1},   {1, 1, 1, 1},
                                      {-1, 1, -1, 1}, {1, -1, 0, 0}, {1e-9, 1, 0, 0}, {-1e-30, 0, 0, 1}};
  for (const Splat& splat : random) all.push_back(splat.rotation);
  for (const Eigen::Vector4d& q : all) {
    for (const int version : {2, 3}) {
      const Eigen::Vector4f wanted = q.normalized().cast<float>();
      std::array<char, 4> code{};
      Eigen::Vector4f got;
      encode_spz_rotation(wanted.data(), version, code.data());
      decode_spz_rotation(code.data(), version, got.data());
      EXPECT_NEAR(got.norm(), 1.0F, version == 2 ? 2e-2F : 1e-6F) << q.transpose();
      const float chord = std::min((got - wanted).norm(), (got + wanted).norm());
      EXPECT_LE(chord, version == 2 ? 0.126F : 2.8e-3F) << q.transpose();
    }
  }
}

TEST(SplatFormats, WriteTheSameBytesWithAnyNumberOfThreads) {
  const Splats splats = random_splats(30000, 3, 56);
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), ply_of(splats));
  SplatEdit edit;
  edit.similarity.turn = rotations().back().matrix;
  for (const std::string ending : {".ply", ".glb", ".spz"}) {
    convert_splats(folder.file("in.ply"), folder.file("many" + ending), edit);
    on_threads(1, [&] { convert_splats(folder.file("in.ply"), folder.file("one" + ending), edit); });
    EXPECT_TRUE(read_all(folder.file("many" + ending)) == read_all(folder.file("one" + ending))) << ending;
  }
}

TEST(SplatFormats, ColorsSurviveEveryPathWithoutRounding) {
  const Splats splats = random_splats(50, 3, 57);
  const TemporaryFolder folder;
  write_all(folder.file("a.ply"), ply_of(splats));
  SplatEdit turn;
  turn.similarity.turn = rotations()[7].matrix;
  convert_splats(folder.file("a.ply"), folder.file("a.glb"), {});
  turn.similarity.turn = kPlyToGlb * turn.similarity.turn * kPlyToGlb.transpose();  // the same turn in the axes of GLB
  convert_splats(folder.file("a.glb"), folder.file("b.glb"), turn);
  convert_splats(folder.file("b.glb"), folder.file("b.ply"), {});
  const Splats turned = splats_of_ply(read_all(folder.file("b.ply")));
  for (std::size_t i = 0; i < splats.size(); ++i) {
    EXPECT_LE(color_difference(splats[i], turned[i], rotations()[7].matrix), 1e-5);
  }
}

TEST(SplatFormats, CopiesWhereNothingIsAsked) {
  const Splats splats = random_splats(3000, 3, 58);
  for (const std::string ending : {".ply", ".glb", ".spz"}) {
    const TemporaryFolder folder;
    write_all(folder.file("in" + ending), written(splats, ending));
    const SplatResult result = convert_splats(folder.file("in" + ending), folder.file("out" + ending), {});
    EXPECT_TRUE(result.is_copy);
    EXPECT_EQ(result.count, splats.size());
    EXPECT_TRUE(read_all(folder.file("out" + ending)) == read_all(folder.file("in" + ending))) << ending;
  }
}

TEST(SplatFormats, HoldNoSplatsWhereTheyCan) {
  for (const std::string ending : {".ply", ".spz"}) EXPECT_EQ(read_back(written({}, ending)).size(), 0U);
  EXPECT_NE(message_of([] { written({}, ".glb"); }).find("expected one splat at least"), std::string::npos);
}

TEST(SplatFormats, RefuseDegreesThatTheyDoNotHold) {
  const Splats splats = random_splats(2, 4, 59);
  EXPECT_NE(message_of([&] { written(splats, ".glb"); }).find("expected --degree 3"), std::string::npos);
  EXPECT_NE(message_of([&] { written(splats, ".spz"); }).find("expected --spz-version 4 or --degree 3"),
            std::string::npos);
  SplatEdit edit;
  edit.degree = 3;
  EXPECT_EQ(read_back(written(splats, ".glb", edit)).at(0).coefficients, splats[0].coefficients.leftCols(16));
}

}  // namespace
}  // namespace sh::prt::test
