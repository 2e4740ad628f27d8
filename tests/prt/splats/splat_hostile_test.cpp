// Files of splats that are not what they say: one line, and nothing written.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "prt/splats/convert_splats.hpp"
#include "tests/prt/splats/splat_cases.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

/// Converts bytes to every format: refused with one line that has the file's name and `reason`, and no file is left.
void expect_unreadable(const std::string& bytes, const std::string& reason, const SplatEdit& edit = {}) {
  const TemporaryFolder folder;
  const std::string file = folder.file("bad");
  write_all(file, bytes);
  for (const std::string ending : {".ply", ".glb", ".spz"}) {
    const std::string message = message_of([&] { convert_splats(file, folder.file("out" + ending), edit); });
    EXPECT_TRUE(message.starts_with(file + ": ")) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(folder.entries(), 1U);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string in_format(const std::string& ply, const std::string& ending, const SplatEdit& edit = {}) {
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), ply);
  convert_splats(folder.file("in.ply"), folder.file("out" + ending), edit);
  return read_all(folder.file("out" + ending));
}

std::string good_ply(int degree = 1) { return ply_of(random_splats(20, degree, 70)); }

TEST(HostileSplats, PlyHeaders) {
  const std::string ply = good_ply();
  expect_unreadable("", "the file is empty");
  expect_unreadable("obj v 1 2 3", "expected Gaussian splats");
  expect_unreadable("ply", "expected `end_header`");
  expect_unreadable("plywood\nend_header\n", "expected `ply` in the first line");
  expect_unreadable("ply\nformat ascii 1.0\n", "expected `end_header`");
  expect_unreadable("ply\nend_header\n", "expected a line `format`");
  expect_unreadable("ply\nformat ascii 1.0\nend_header\n", "expected a line `element vertex N`");
  expect_unreadable(replaced(ply, "little_endian 1.0", "little_endian 2.0"),
                    "line 2 of the PLY header: expected `format");
  expect_unreadable(replaced(ply, "binary_little_endian", "binary_middle_endian"), "line 2");
  expect_unreadable(replaced(ply, "vertex 20", "vertex -1"), "line 3 of the PLY header: expected `element NAME COUNT`");
  expect_unreadable(replaced(ply, "vertex 20", "vertex 2e1"), "line 3");
  expect_unreadable(replaced(ply, "vertex 20", "vertex 99999999999999999999"), "line 3");
  expect_unreadable(replaced(ply, "property float x", "property list uchar int x"), "got the list `x`");
  expect_unreadable(replaced(ply, "property float x", "property quad x"), "expected `property TYPE NAME`");
  expect_unreadable(replaced(ply, "property float y", "property float x"), "the property `x` stands there twice");
  expect_unreadable(replaced(ply, "property float x", "property int x"),
                    "expected the property `x` of type float or double");
  expect_unreadable(replaced(ply, "element vertex", "element face 0\nelement vertex"),
                    "expected the vertices first, got the element `face`");
  expect_unreadable(replaced(ply, "property float x", "\x1b[2J\x1c 1"), R"(got `\x1b[2J\x1c`)");
  expect_unreadable(replaced(ply, "property float x", std::string(100000, 'w')),
                    "got `" + std::string(60, 'w') + "...`");
  std::string umlauts = "w";
  for (int i = 0; i < 99; ++i) umlauts += "\xc3\xa4";
  expect_unreadable(replaced(ply, "property float x", umlauts), "got `" + umlauts.substr(0, 59) + "...`");
  expect_unreadable(replaced(ply, "end_header", "element vertex 3\nend_header"), "got a second");
  expect_unreadable(replaced(ply, "property float x", "vertices float x"), "got `vertices`");
}

TEST(HostileSplats, PlyPropertiesThatAreMissing) {
  for (const std::string name : {"x", "z", "f_dc_0", "f_dc_2", "opacity", "scale_1", "rot_0", "rot_3"}) {
    expect_unreadable(replaced(good_ply(), "property float " + name + "\n", "property float other\n"),
                      "expected the property `" + name + "` of a Gaussian splat, which is missing");
  }
  expect_unreadable(
      replaced(good_ply(), "property float f_rest_4\n", "property float other\n"),
      "`f_rest_4` of a Gaussian splat, which is missing; 8 properties f_rest_ are there, expected 0, 9, 24, 45 or 72");
  expect_unreadable(replaced(good_ply(), "property float f_rest_4\n", "property float f_rest_9\n"), "`f_rest_4`");
  expect_unreadable(replaced(good_ply(), "property float x\n", "property float packed_position\n"),
                    "a compressed PLY file");
}

TEST(HostileSplats, PlyCountsThatDoNotAgree) {
  const std::string ply = good_ply();
  expect_unreadable(ply.substr(0, ply.size() - 1),
                    "truncated: the header announces 20 splats of 104 bytes, the file has 19");
  expect_unreadable(ply + "x", "the file has 2081");
  expect_unreadable(replaced(ply, "vertex 20", "vertex 19"),
                    "the header announces 1976 bytes of data (19 splats of 104 bytes), the file has 2080");
  expect_unreadable(replaced(ply, "vertex 20", "vertex 21"), "truncated: the header announces 21 splats");
  expect_unreadable(replaced(ply, "vertex 20", "vertex 18446744073709551615"),
                    "truncated: the header announces 18446744073709551615 splats");
  expect_unreadable(replaced(ply, "end_header", "element camera 3\nproperty float f\nend_header"),
                    "20 splats of 104 bytes and camera");
  expect_unreadable(replaced(ply, "end_header", "element camera 18446744073709551615\nproperty double f\nend_header"),
                    "and camera");
  for (std::size_t size = 4; size < ply.size(); size += 97) {
    const TemporaryFolder folder;
    write_all(folder.file("a"), ply.substr(0, size));
    EXPECT_NE(message_of([&] { convert_splats(folder.file("a"), folder.file("b.ply"), {}); }), "") << size;
    EXPECT_EQ(folder.entries(), 1U);
  }
}

TEST(HostileSplats, PlyTexts) {
  const std::string ply = ply_of(random_splats(3, 0, 71), {.format = "ascii"});
  expect_unreadable(ply.substr(0, ply.size() - 12), "truncated: the header announces 3 splats, the file has 2");
  expect_unreadable(ply + "7", "the file has more numbers");
  expect_unreadable(ply.substr(0, ply.size() - 3) + "x \n", "splat 2: expected a number of rot_3");
  expect_unreadable(replaced(ply, "end_header\n", "end_header\n1e99 "), "splat 0: expected a number of x, got `1e99`");
  expect_unreadable(replaced(ply, "end_header\n", "element a 1\nproperty int b\nend_header\n"),
                    "expected binary_little_endian");
}

TEST(HostileSplats, NumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto with = [](const auto& change) {
    Splats splats = random_splats(5000, 1, 72);
    change(splats[4321]);
    return ply_of(splats);
  };
  const auto what = [](const std::string& name) {
    return "splat 4321: " + name + " is not finite or not in its range";
  };
  expect_unreadable(with([&](Splat& s) { s.position[1] = nan; }), what("y"));
  expect_unreadable(with([&](Splat& s) { s.position[2] = -infinity; }), what("z"));
  expect_unreadable(with([&](Splat& s) { s.rotation[3] = nan; }), what("rot_3"));
  expect_unreadable(with([&](Splat& s) { s.log_scale[1] = infinity; }), what("scale_1"));
  expect_unreadable(with([&](Splat& s) { s.opacity = nan; }), what("opacity"));
  expect_unreadable(with([&](Splat& s) { s.coefficients(2, 0) = infinity; }), what("f_dc_2"));
  expect_unreadable(with([&](Splat& s) { s.coefficients(1, 2) = nan; }), what("f_rest_4"));
  expect_unreadable(with([&](Splat& s) { s.coefficients(1, 2) = nan; }), "--drop-invalid");
}

TEST(HostileSplats, AreLeftOutOnRequest) {
  Splats splats = random_splats(5000, 1, 73);
  splats[0].opacity = std::numeric_limits<double>::quiet_NaN();
  splats[2500].position[0] = std::numeric_limits<double>::infinity();
  splats[4999].coefficients(0, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const std::string ending : {".ply", ".glb", ".spz"}) {
    const TemporaryFolder folder;
    write_all(folder.file("in.ply"), ply_of(splats));
    SplatEdit edit;
    edit.flaws.drop = true;
    const SplatResult result = convert_splats(folder.file("in.ply"), folder.file("out" + ending), edit);
    EXPECT_EQ(result.dropped, 3U);
    EXPECT_EQ(result.count, 4997U);
    convert_splats(folder.file("out" + ending), folder.file("back.ply"), {});
    EXPECT_EQ(splats_of_ply(read_all(folder.file("back.ply"))).size(), 4997U) << ending;
  }
}

TEST(HostileSplats, QuaternionsOfZeroCountAsTheIdentity) {
  Splats splats = random_splats(20, 1, 74);
  splats[11].rotation.setZero();
  const std::string bytes = ply_of(splats);
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), bytes);
  SplatEdit edit;
  const SplatResult copied = convert_splats(folder.file("in.ply"), folder.file("same.ply"), edit);
  EXPECT_EQ(copied.mended, 1U);
  EXPECT_EQ(read_all(folder.file("same.ply")), bytes);
  edit.similarity.turn = rotations()[7].matrix;
  EXPECT_EQ(convert_splats(folder.file("in.ply"), folder.file("out.ply"), edit).mended, 1U);
  const Splat turned = splats_of_ply(read_all(folder.file("out.ply"))).at(11);
  EXPECT_LE((turned.rotation - Eigen::Vector4d::Constant(0.5)).norm(), 1e-6) << "120 degrees about 1 1 1";
  edit.flaws.strict = true;
  expect_unreadable(bytes, "splat 11: its quaternion is 0", edit);
}

TEST(HostileSplats, EditsThatExceedSinglePrecision) {
  const Splats splats = random_splats(20, 1, 75);
  SplatEdit edit;
  edit.similarity.move = {3e38, 0.0, 0.0};
  Splats far = splats;
  far[3].position[0] = 3e38;
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), ply_of(far));
  EXPECT_NE(message_of([&] {
              convert_splats(folder.file("in.ply"), folder.file("out.ply"), edit);
            }).find("after the edit x of a splat exceeds single precision"),
            std::string::npos);
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(HostileSplats, ScalesThatOnlyTheirLogarithmsHold) {
  Splats splats = random_splats(20, 1, 77);
  splats[3].log_scale[1] = 89.0;
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), ply_of(splats));
  EXPECT_NE(message_of([&] {
              convert_splats(folder.file("in.ply"), folder.file("out.glb"), {});
            }).find("out.glb: the scale e^89 of a splat exceeds single precision"),
            std::string::npos);
  EXPECT_EQ(folder.entries(), 1U);
  EXPECT_EQ(in_format(ply_of(splats), ".ply"), ply_of(splats));
}

TEST(HostileSplats, DoublesBeyondSinglePrecision) {
  Splats splats = random_splats(20, 1, 78);
  splats[3].position[1] = 1e300;
  expect_unreadable(ply_of(splats, {.doubles = true}), "splat 3: y is not finite or not in its range (inf)");
}

TEST(HostileSplats, GlbFiles) {
  const std::string glb = in_format(good_ply(), ".glb");
  expect_unreadable(glb.substr(0, 11), "not a GLB file");
  expect_unreadable(glb.substr(0, glb.size() - 1), "truncated: expected");
  expect_unreadable(glb + "x", "the header announces");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string padded = to;
    padded.resize(from.size(), ' ');
    return replaced(glb, from, padded);
  };
  std::string version = glb;
  version[4] = 1;
  expect_unreadable(version, "GLB of version 1: expected version 2");
  expect_unreadable(changed(R"("asset":)", R"("asset";)"), "not JSON");
  expect_unreadable(changed(R"("extensions":{"KHR_gaussian_splatting")", R"("extensions":{"KHR_gaussian_splattinG")"),
                    "a primitive with the extension KHR_gaussian_splatting, got none");
  expect_unreadable(changed(R"("mode":0)", R"("mode":4)"), "expected points (mode 0)");
  expect_unreadable(changed(R"("ellipse")", R"("ellipso")"), "expected the kernel `ellipse`");
  expect_unreadable(changed("KHR_gaussian_splatting:OPACITY", "KHR_gaussian_splatting:OPACITE"),
                    "expected the attribute KHR_gaussian_splatting:OPACITY, which is missing");
  expect_unreadable(changed("SH_DEGREE_1_COEF_2", "SH_DEGREE_1_COEF_X"),
                    "expected the attribute KHR_gaussian_splatting:SH_DEGREE_1_COEF_2, which is missing");
  expect_unreadable(changed("SH_DEGREE_1_COEF_0", "SH_DEGREE_1_COEF_X"), "expected all coefficients of a degree");
  expect_unreadable(changed(R"("count":20,"type":"VEC4")", R"("count":21,"type":"VEC4")"),
                    "/accessors/1: expected 21 splats");
  expect_unreadable(changed(R"("count":20,"type":"VEC4")", R"("count":19,"type":"VEC4")"),
                    "an accessor of 20 splats, as POSITION has, not of 19");
  expect_unreadable(changed(R"("count":20,"type":"VEC4")", R"("count":20,"type":"VEC3")"), "expected the type VEC4");
  expect_unreadable(changed(R"("count":20,"type":"VEC4")", R"("count":2.5,"type":"VEC")"), "expected");
  expect_unreadable(changed(R"("componentType":5126)", R"("componentType":5125)"), "expected a component type");
  expect_unreadable(changed(R"("bufferView":0,)", R"("bufferView":9,)"), "expected one of the 1 bufferViews");
  expect_unreadable(changed(R"("byteOffset":0,)", R"("byteOffset":-,)"), "not JSON");
  expect_unreadable(changed(R"("byteLength":)", R"("byteLengtH":)"), "byteLength");
  std::string chunk = glb;
  chunk[16] = 'X';
  expect_unreadable(chunk, "expected a JSON chunk first");
}

TEST(HostileSplats, GlbNumbersOutOfRange) {
  Splats splats = random_splats(20, 0, 76);
  std::string glb = in_format(ply_of(splats), ".glb");
  const std::size_t size = 12 + 16 + 12 + 4 + 12 + 4;
  const std::size_t third = glb.size() - 17 * size;
  const float wrong = -0.5F;
  std::string opacity = glb;
  std::memcpy(&opacity[third + 40], &wrong, 4);
  expect_unreadable(opacity,
                    "splat 3: component 0 of KHR_gaussian_splatting:OPACITY is not finite or not in its range");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::string rotation = glb;
  std::memcpy(&rotation[third + 12], &nan, 4);
  expect_unreadable(rotation, "splat 3: component 0 of KHR_gaussian_splatting:ROTATION");
  std::string scale = glb;
  std::memcpy(&scale[third + 32], &wrong, 4);
  expect_unreadable(scale, "splat 3: component 1 of KHR_gaussian_splatting:SCALE");
}

std::string gzipped(const std::string& bytes) {
  const TemporaryFolder folder;
  gzFile file = gzopen(folder.file("a").c_str(), "wb");
  EXPECT_EQ(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())), static_cast<int>(bytes.size()));
  gzclose(file);
  return read_all(folder.file("a"));
}

std::string spz_header(int version, unsigned count, int degree, int bits = 12, int flags = 0) {
  std::string bytes = "NGSP";
  bytes += {static_cast<char>(version), 0, 0, 0};
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  bytes += {static_cast<char>(degree), static_cast<char>(bits), static_cast<char>(flags), 0};
  return bytes;
}

TEST(HostileSplats, SpzFiles) {
  const std::string spz = in_format(good_ply(), ".spz");
  expect_unreadable(spz.substr(0, spz.size() - 1), "truncated: the gzip stream does not end");
  expect_unreadable(spz.substr(0, 2), "truncated");
  expect_unreadable(spz + "x", "further bytes");
  std::string damaged = spz;
  damaged[damaged.size() - 8] ^= 1;  // the checksum
  expect_unreadable(damaged, "a damaged gzip stream");
  expect_unreadable(gzipped("hello"), "not an SPZ file");
  expect_unreadable(gzipped(std::string(40, 'N')), "not an SPZ file");
  for (const int version : {0, 1, 5}) {
    expect_unreadable(gzipped(spz_header(version, 0, 0)),
                      fmt::format("SPZ of version {}: expected version 2, 3 or 4", version));
  }
  expect_unreadable(gzipped(spz_header(4, 0, 0)), "SPZ of version 4 in a gzip stream");
  expect_unreadable(gzipped(spz_header(3, 0, 5)), "SPZ of degree 5: expected 0 to 4");
  expect_unreadable(gzipped(spz_header(3, 0, 0, 24)), "24 fractional bits");
  expect_unreadable(gzipped(spz_header(3, 1, 0) + std::string(19, 'a')),
                    "truncated: the header announces 1 splats of degree 0, whose part 4 has 4 bytes; got 3");
  expect_unreadable(gzipped(spz_header(3, 1, 0) + std::string(21, 'a')), "the file has more bytes");
  expect_unreadable(gzipped(spz_header(3, 4294967295U, 3)), "truncated: the header announces 4294967295 splats");
}

TEST(HostileSplats, SpzFilesOfVersion4) {
  SplatEdit edit;
  edit.spz.version = 4;
  const std::string spz = in_format(good_ply(), ".spz", edit);
  const auto changed = [&](std::size_t at, char byte) {
    std::string bytes = spz;
    bytes[at] = byte;
    return bytes;
  };
  expect_unreadable(spz.substr(0, 31), "expected an SPZ header of 32 bytes");
  expect_unreadable(spz.substr(0, 60), "expected a table of streams");
  expect_unreadable(spz.substr(0, spz.size() - 1), "a zstd stream ends after the file");
  expect_unreadable(spz + "x", "expected nothing after the zstd streams");
  expect_unreadable(changed(4, 3), "SPZ of version 3 without gzip");
  expect_unreadable(changed(4, 9), "SPZ of version 9");
  expect_unreadable(changed(8, 21), "truncated: the header announces 21 splats");
  expect_unreadable(changed(15, 5), "SPZ with 5 streams");
  expect_unreadable(changed(16, 7), "expected a table of streams");
  expect_unreadable(changed(32 + 6 * 16, 0), "a damaged zstd stream");
  expect_unreadable(changed(32 + 8, 1), "whose part 0 has 180 bytes; got 1");
}

TEST(HostileSplats, ExtensionsOfSpzAreLeftOutWithAWarning) {
  const TemporaryFolder folder;
  write_all(folder.file("a.spz"), gzipped(spz_header(3, 1, 0, 12, 2) + std::string(20, 'a') + "extension"));
  EXPECT_EQ(convert_splats(folder.file("a.spz"), folder.file("b.ply"), {}).left_out, "9 bytes of SPZ extensions");
}

TEST(HostileSplats, AreNoDevicesOrFolders) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of([&] {
              convert_splats(folder.path().string(), folder.file("out.ply"), {});
            }).find("expected a file, got a folder"),
            std::string::npos);
  EXPECT_NE(message_of([&] { convert_splats("/dev/null", folder.file("out.ply"), {}); }).find("expected a file"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              convert_splats(folder.file("none.ply"), folder.file("out.ply"), {});
            }).find("cannot read: No such file"),
            std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
