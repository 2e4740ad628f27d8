// Lights in engines' formats: each file is read by the engine's own package or by a reader written here from its
// specification, and gives the same radiance or irradiance at 100 directions; `import` gives the coefficients back.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "numeric/oracle/zonal.hpp"
#include "numeric/sampling/directions.hpp"
#include "prt/formats/formats.hpp"
#include "tests/formats/readers.hpp"
#include "tests/prt/lights.hpp"

namespace sh::prt::test {
namespace {

using formats::LightFormat;
using Rgb = Eigen::Vector3d;
using Row = std::vector<double>;

constexpr double kPi = std::numbers::pi;

std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const auto& d : numeric::random_directions(94, 23)) all.emplace_back(d.x, d.y, d.z);
  return all;
}

// Irradiance by its bands, with the oracle's A_l.
Rgb irradiance(const LightCoefficients& light, const Eigen::Vector3d& normal) {
  LightCoefficients gathered = light;
  for (int l = 0; l <= light.degree; ++l) {
    gathered.matrix().middleRows(l * l, 2 * l + 1) *= numeric::clamped_cosine_factor<double>(l);
  }
  return radiance(gathered, normal);
}

std::string bytes_of(const std::string& name, const LightCoefficients& light) {
  const LightFormat& format = *formats::find_light_format(name);
  return format.write({format.convention.to(light), &format.convention, &light});
}

// Our world (x right, y forward, z up) in the axes of engines.
Eigen::Vector3d y_up(const Eigen::Vector3d& d) { return {d.x(), d.z(), -d.y()}; }
Eigen::Vector3d y_up_left_handed(const Eigen::Vector3d& d) { return {d.x(), d.z(), d.y()}; }
Eigen::Vector3d x_forward(const Eigen::Vector3d& d) { return {d.y(), d.x(), d.z()}; }

using Triples = std::vector<Rgb>;

Triples triples_of(const nlohmann::json& json) {
  Triples triples;
  for (const auto& t : json) triples.emplace_back(t[0].get<double>(), t[1].get<double>(), t[2].get<double>());
  return triples;
}

Triples triples_of_channels(const nlohmann::json& r, const nlohmann::json& g, const nlohmann::json& b) {
  Triples triples;
  for (std::size_t i = 0; i < r.size(); ++i) {
    triples.emplace_back(r[i].get<double>(), g[i].get<double>(), b[i].get<double>());
  }
  return triples;
}

// Filament's Irradiance_SphericalHarmonics (light_indirect.fs): irradiance over pi at a normal.
Rgb filament(const Triples& sh, const Eigen::Vector3d& n) {
  return sh[0] + sh[1] * n.y() + sh[2] * n.z() + sh[3] * n.x() + sh[4] * (n.y() * n.x()) + sh[5] * (n.y() * n.z()) +
         sh[6] * (3.0 * n.z() * n.z() - 1.0) + sh[7] * (n.z() * n.x()) + sh[8] * (n.x() * n.x() - n.y() * n.y());
}

// The lines "( r, g, b); // ..." of sh.txt as sscanf reads them.
Triples lines_of(const std::string& text) {
  Triples triples;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    Rgb rgb;
    EXPECT_EQ(std::sscanf(line.c_str(), "( %lf , %lf , %lf ) ;", &rgb[0], &rgb[1], &rgb[2]), 3) << line;
    triples.push_back(rgb);
  }
  return triples;
}

struct Ktx {
  std::uint32_t size = 0, levels = 0;
  Triples sh;
  std::string faces;  // of level 0
};

// [KTX 1.0]: header of 64 bytes, metadata entries padded to four, then imageSize and six faces for each level.
Ktx ktx_of(const std::string& bytes) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
  };
  EXPECT_EQ(bytes.substr(1, 6), "KTX 11");
  EXPECT_EQ(word(12), 0x04030201U);
  EXPECT_EQ(word(52), 6U);
  Ktx ktx{word(36), word(56), {}, {}};
  EXPECT_EQ(word(64 + 4) & 0xFFFFFFU, 0x006873U);  // "sh\0"
  std::istringstream text(bytes.substr(64 + 7, word(64) - 3));
  for (Rgb rgb; text >> rgb[0] >> rgb[1] >> rgb[2];) ktx.sh.push_back(rgb);
  std::size_t at = 64 + word(60);
  for (std::uint32_t level = 0; level < ktx.levels; ++level) {
    const std::size_t face = word(at);
    EXPECT_EQ(face, (ktx.size >> level) * (ktx.size >> level) * 8U);
    if (level == 0) ktx.faces = bytes.substr(at + 4, 6 * face);
    at += 4 + 6 * face;
  }
  EXPECT_EQ(at, bytes.size());
  return ktx;
}

// ShadeSH9 of UnityCG.cginc: irradiance over pi.
Rgb shade_sh9(const nlohmann::json& constants, const Eigen::Vector3d& n) {
  Rgb sum;
  for (int k = 0; k < 3; ++k) {
    const auto a = constants.at(std::string("unity_SHA") + "rgb"[k]).get<Row>();
    const auto b = constants.at(std::string("unity_SHB") + "rgb"[k]).get<Row>();
    sum[k] = a[0] * n.x() + a[1] * n.y() + a[2] * n.z() + a[3] + b[0] * n.x() * n.y() + b[1] * n.y() * n.z() +
             b[2] * n.z() * n.z() + b[3] * n.z() * n.x() +
             constants.at("unity_SHC")[static_cast<std::size_t>(k)].get<double>() * (n.x() * n.x() - n.y() * n.y());
  }
  return sum;
}

// SHBasisFunction of Unreal's SHMath.h.
Rgb unreal(const Triples& v, const Eigen::Vector3d& d) {
  const double x = d.x(), y = d.y(), z = d.z();
  const double basis[] = {0.282095,
                          -0.488603 * y,
                          0.488603 * z,
                          -0.488603 * x,
                          1.092548 * x * y,
                          -1.092548 * y * z,
                          0.315392 * (3 * z * z - 1),
                          -1.092548 * x * z,
                          0.546274 * (x * x - y * y)};
  Rgb sum = Rgb::Zero();
  for (std::size_t i = 0; i < 9; ++i) sum += basis[i] * v[i];
  return sum;
}

// What Godot's scene shader adds to ambient_light for a light probe: irradiance over pi.
Rgb godot(const Triples& sh, const Eigen::Vector3d& n) {
  return 0.886227 * sh[0] + 1.023327 * (sh[1] * n.y() + sh[2] * n.z() + sh[3] * n.x()) +
         0.858086 * (sh[4] * n.x() * n.y() + sh[5] * n.y() * n.z() + sh[7] * n.x() * n.z()) +
         0.247708 * sh[6] * (3.0 * n.z() * n.z() - 1.0) + 0.429043 * sh[8] * (n.x() * n.x() - n.y() * n.y());
}

constexpr double kSixDigits = 5e-6;  // the engines' constants have six digits, the light's values are about 3

class LightFormats : public testing::Test {
 protected:
  LightCoefficients light = random_light(2, 41);
  TemporaryFolder folder;

  std::string written(const std::string& name) {
    std::string file = folder.file("light" + std::string(formats::find_light_format(name)->ending));
    write_all(file, bytes_of(name, light));
    return file;
  }
  /// A JSON file of the directions in an engine's axes.
  template <class Map>
  std::string directions_in(const Map& axes) {
    nlohmann::json json;
    for (const auto& d : directions()) json.push_back(Row{axes(d).x(), axes(d).y(), axes(d).z()});
    write_all(folder.file("directions.json"), json.dump());
    return folder.file("directions.json");
  }
  template <class Value, class Expected>
  void expect_equal(const Value& value, const Expected& expected, double limit) {
    double largest = 0;
    for (std::size_t i = 0; i < directions().size(); ++i) {
      largest = std::max(largest, (value(i) - expected(directions()[i])).cwiseAbs().maxCoeff());
    }
    EXPECT_LE(largest, limit);
    RecordProperty("largest_difference", fmt::format("{:.2g}", largest));
  }
  auto exact_radiance() {
    return [this](const Eigen::Vector3d& d) { return radiance(light, d); };
  }
  auto exact_irradiance() {
    return [this](const Eigen::Vector3d& d) { return irradiance(light, d); };
  }
};

TEST_F(LightFormats, AreReadByTheLightProbeOfThreejs) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  const auto read = read_by("threejs", written("threejs"), directions_in(y_up));
  EXPECT_EQ(read["intensity"], 1);
  const auto radiances = triples_of(read["radiance"]);
  const auto irradiances = triples_of(read["irradiance"]);
  expect_equal([&](std::size_t i) { return radiances[i]; }, exact_radiance(), kSixDigits);
  expect_equal([&](std::size_t i) { return irradiances[i]; }, exact_irradiance(), kSixDigits);
}

TEST_F(LightFormats, AreReadByBabylonFromImageBasedLights) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  const auto read = triples_of(read_by("babylon", written("gltf"), directions_in(y_up))["irradiance"]);
  expect_equal([&](std::size_t i) { return read[i]; }, exact_irradiance(), 1e-12);
}

TEST_F(LightFormats, AreValidGltfWithSixPicturesALevel) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  const std::string file = written("gltf");
  const auto found = read_by("validate", file);
  EXPECT_EQ(found["errors"], 0) << found;
  EXPECT_EQ(found["warnings"], 0) << found;
  const auto images = read_by("images", file);
  EXPECT_EQ(images["size"], 64);
  ASSERT_EQ(images["sizes"].size(), 3U);
  for (std::size_t level = 0; level < 3; ++level) {
    ASSERT_EQ(images["sizes"][level].size(), 6U);
    for (const auto& size : images["sizes"][level]) EXPECT_EQ(size, (Row{64.0 / (1 << level), 64.0 / (1 << level), 6}));
  }
}

// A light brighter than RGBD holds: the pictures are scaled, and intensity brings both back.
TEST_F(LightFormats, BrightImageBasedLightsKeepTheirCoefficients) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  for (double& value : light.values) value *= 1e5;
  const auto read = triples_of(read_by("babylon", written("gltf"), directions_in(y_up))["irradiance"]);
  expect_equal([&](std::size_t i) { return read[i]; }, exact_irradiance(), 1e-7);
}

TEST_F(LightFormats, GiveFilamentItsText) {
  const auto sh = lines_of(bytes_of("filament", light));
  ASSERT_EQ(sh.size(), 9U);
  expect_equal([&](std::size_t i) { return Rgb(kPi * filament(sh, y_up(directions()[i]))); }, exact_irradiance(),
               1e-13);
  EXPECT_NE(bytes_of("filament", light).find("); // L2-1, irradiance, pre-scaled base\n"), std::string::npos);
}

TEST_F(LightFormats, GiveFilamentItsMetadataAndReflections) {
  const Ktx ktx = ktx_of(bytes_of("filament-ktx", light));
  ASSERT_EQ(ktx.sh.size(), 9U);
  expect_equal([&](std::size_t i) { return Rgb(kPi * filament(ktx.sh, y_up(directions()[i]))); }, exact_irradiance(),
               1e-13);
  // The corner pixel of each face, by the direction in which OpenGL samples it: top left of +x is (1, 1, 1), ...
  const double c = 1.0 - 1.0 / ktx.size;
  const Eigen::Vector3d corners[] = {{1, c, c}, {-1, c, -c}, {-c, 1, -c}, {-c, -1, c}, {-c, c, 1}, {c, c, -1}};
  for (std::size_t face = 0; face < 6; ++face) {
    const Eigen::Vector3d d = corners[face].normalized();
    const Rgb expected = radiance(light, {d.x(), -d.z(), d.y()}).cwiseMax(0.0);
    for (int k = 0; k < 3; ++k) {
      std::uint16_t half = 0;
      std::memcpy(&half, ktx.faces.data() + face * ktx.size * ktx.size * 8 + static_cast<std::size_t>(2 * k), 2);
      const auto value = static_cast<float>(Eigen::half(Eigen::half_impl::raw_uint16_to_half(half)));
      EXPECT_NEAR(static_cast<double>(value), expected[k], 1e-3 * (1 + expected[k])) << face;
    }
  }
}

TEST_F(LightFormats, AreCubeMapsOfKtxWithThreeLevels) {
  if (const std::string why = no_engines(); !why.empty()) GTEST_SKIP() << why;
  const auto read = read_by("ktx", written("filament-ktx"));
  EXPECT_EQ(read["cube"], true);
  EXPECT_EQ(read["levels"], 3);
  ASSERT_EQ(read["sizes"].size(), 18U);
  for (std::size_t i = 0; i < 18; ++i) {
    const std::size_t size = 64U >> (i / 6);
    EXPECT_EQ(read["sizes"][i], (std::vector<std::size_t>{size, size, 8 * size * size}));
  }
}

TEST_F(LightFormats, GiveUnityItsHarmonicsAndShaderConstants) {
  const auto json = nlohmann::json::parse(bytes_of("unity", light));
  expect_equal(
      [&](std::size_t i) { return Rgb(kPi * shade_sh9(json["shader_constants"], y_up_left_handed(directions()[i]))); },
      exact_irradiance(), 1e-13);
  const auto& sh = json["SphericalHarmonicsL2"];
  const auto all = triples_of_channels(sh["r"], sh["g"], sh["b"]);  // SphericalHarmonicsL2.Evaluate is the same sum
  expect_equal([&](std::size_t i) { return Rgb(kPi * filament(all, y_up_left_handed(directions()[i]))); },
               exact_irradiance(), 1e-13);
}

TEST_F(LightFormats, GiveUnrealItsVectors) {
  const auto json = nlohmann::json::parse(bytes_of("unreal", light))["FSHVectorRGB3"];
  const auto v = triples_of_channels(json["R"]["V"], json["G"]["V"], json["B"]["V"]);
  expect_equal([&](std::size_t i) { return unreal(v, x_forward(directions()[i])); }, exact_radiance(), kSixDigits);
}

TEST_F(LightFormats, GiveGodotItsProbe) {
  const auto sh = triples_of(nlohmann::json::parse(bytes_of("godot", light))["probe_sh"]);
  expect_equal([&](std::size_t i) { return Rgb(kPi * godot(sh, y_up(directions()[i]))); }, exact_irradiance(),
               kSixDigits);
}

TEST_F(LightFormats, GiveUsdTheCoefficientsInItsAxes) {
  light = random_light(10, 43);
  std::string text = bytes_of("usd", light);
  EXPECT_NE(text.find("int shforge:radiance:sphericalHarmonicsDegree = 10\n"), std::string::npos);
  EXPECT_NE(text.find("upAxis = \"Z\""), std::string::npos);
  const std::string array = text.substr(text.find("Coefficients = [") + 15);
  std::string bracketed = std::regex_replace(array.substr(0, array.find(']') + 1), std::regex("\\("), "[");
  const auto triples = triples_of(nlohmann::json::parse(std::regex_replace(bracketed, std::regex("\\)"), "]")));
  ASSERT_EQ(triples.size(), 121U);
  for (std::size_t i = 0; i < triples.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(triples[i][static_cast<int>(k)], light.at(k, i));
  }
}

// All numbers of a text that have a decimal point.
Row decimals_in(const std::string& text) {
  const std::regex number(R"(-?\d+\.\d*(e[-+]?\d+)?)");
  Row values;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
    values.push_back(std::stod(i->str()));
  return values;
}

TEST_F(LightFormats, CodeHasTheNumbersOfTheData) {
  const auto data = [&](const char* name) {
    const LightFormat& format = *formats::find_light_format(name);
    formats::Document document;
    document.json.emplace(nlohmann::json::parse(bytes_of(name, light)));
    return format.read(document).value();
  };
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-8 * (1 + std::abs(b)); };
  const auto unreal_data = data("unreal");
  const Row unreal_code = decimals_in(bytes_of("unreal-code", light));
  ASSERT_EQ(unreal_code.size(), 27U);
  for (std::size_t i = 0; i < 27; ++i) EXPECT_TRUE(near(unreal_code[i], unreal_data[i % 9][i / 9])) << i;
  const auto unity_data = data("unity");
  const Row unity_code = decimals_in(bytes_of("unity-code", light));
  ASSERT_GE(unity_code.size(), 27U);
  for (std::size_t i = 0; i < 27; ++i) EXPECT_TRUE(near(unity_code[i], unity_data[i % 9][i / 9])) << i;
  const auto godot_data = data("godot");
  const std::string shader = bytes_of("godot-code", light);
  const Row godot_code = decimals_in(shader.substr(shader.find("probe_sh[9]")));
  for (std::size_t i = 0; i < 27; ++i) EXPECT_TRUE(near(godot_code[i], godot_data[i / 3][i % 3])) << i;
}

TEST_F(LightFormats, ComeBackByImport) {
  int readers = 0;
  for (const LightFormat& format : formats::light_formats()) {
    if (format.read == nullptr) continue;
    ++readers;
    light = random_light(format.degree, 47);
    const auto imported = formats::import_light(written(std::string(format.name)));
    EXPECT_EQ(imported.format->name, format.name);
    ASSERT_EQ(imported.light.degree, format.degree) << format.name;
    for (std::size_t i = 0; i < light.values.size(); ++i) {
      EXPECT_NEAR(imported.light.values[i], light.values[i], 4e-15) << format.name << " " << i;
    }
  }
  EXPECT_EQ(readers, 8);
}

TEST_F(LightFormats, AreScaledByTheirIntensity) {
  auto json = nlohmann::json::parse(bytes_of("threejs", light));
  json["object"]["intensity"] = 2.5;
  write_all(folder.file("a.json"), json.dump());
  const auto probe = formats::import_light(folder.file("a.json")).light;
  for (double& value : light.values) value *= 1e5;  // beyond RGBD: the writer puts a part of it into the intensity
  const auto bright = formats::import_light(written("gltf")).light;
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    EXPECT_NEAR(probe.values[i], 2.5e-5 * light.values[i], 1e-14);
    EXPECT_NEAR(bright.values[i], light.values[i], 1e-9);
  }
}

TEST_F(LightFormats, OfUnityComeBackFromShaderConstantsAlone) {
  auto json = nlohmann::json::parse(bytes_of("unity", light));
  json.erase("SphericalHarmonicsL2");
  write_all(folder.file("a.json"), json.dump());
  const auto imported = formats::import_light(folder.file("a.json")).light;
  for (std::size_t i = 0; i < light.values.size(); ++i) EXPECT_NEAR(imported.values[i], light.values[i], 4e-15);
}

TEST_F(LightFormats, HoldExtremesAndAreTheSameBytesEveryTime) {
  for (const double scale : {0.0, 1e-300, 1e-30, 1e30}) {
    LightCoefficients scaled = light;
    for (double& value : scaled.values) value *= scale;
    for (const LightFormat& format : formats::light_formats()) {
      const std::string bytes = bytes_of(std::string(format.name), scaled);
      EXPECT_EQ(bytes, bytes_of(std::string(format.name), scaled)) << format.name;
      EXPECT_EQ(bytes.find("nan"), std::string::npos) << format.name;
      EXPECT_EQ(bytes.find("inf"), std::string::npos) << format.name;
      if (format.read == nullptr) continue;
      write_all(folder.file("a"), bytes);
      const auto back = formats::import_light(folder.file("a")).light;
      for (std::size_t i = 0; i < scaled.values.size(); ++i) {
        EXPECT_NEAR(back.values[i], scaled.values[i], 4e-15 * scale) << format.name;
      }
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
