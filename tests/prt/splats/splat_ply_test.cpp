// PLY files of splats: what nobody asked to change stays, to the byte.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "prt/splats/convert_splats.hpp"
#include "tests/prt/splats/splat_cases.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

std::string converted(const std::string& bytes, const SplatEdit& edit = {}) {
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), bytes);
  convert_splats(folder.file("in.ply"), folder.file("out.ply"), edit);
  return read_all(folder.file("out.ply"));
}

SplatEdit third_turn() {
  SplatEdit edit;
  edit.similarity.turn = rotations()[7].matrix;
  return edit;
}

/// Everything that a file may have beside splats.
PlyText rich_text() {
  PlyText text;
  text.after_format = "comment made by hand\nobj_info scan 7\n";
  text.first = {"id"};
  text.last = {"label", "flags"};
  text.tail_header = "element camera 2\nproperty float focal\nproperty uchar kind\ncomment the end\n";
  text.tail = "0123456789";
  return text;
}

TEST(SplatPly, StaysTheSameWhereNothingIsAsked) {
  for (int degree = 0; degree <= kHighestSplatDegree; ++degree) {
    const Splats splats = random_splats(5000, degree, 20);
    for (const PlyText& text :
         {PlyText(), rich_text(), PlyText{.format = "ascii"}, PlyText{.format = "binary_big_endian"},
          PlyText{.normals = false}, PlyText{.doubles = true}}) {
      const std::string bytes = ply_of(splats, text);
      EXPECT_TRUE(converted(bytes) == bytes) << text.format << ", degree " << degree;
    }
  }
}

TEST(SplatPly, StaysTheSameWhereTheEditChangesNothing) {
  const std::string bytes = ply_of(random_splats(5000, 3, 21), rich_text());
  SplatEdit crop;
  crop.crop = Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-1e4), Eigen::Vector3d::Constant(1e4));
  EXPECT_TRUE(converted(bytes, crop) == bytes);
  SplatEdit drop;
  drop.flaws.drop = true;
  EXPECT_TRUE(converted(bytes, drop) == bytes);
}

TEST(SplatPly, AnEditChangesOnlyItsOwnNumbers) {
  const Splats splats = random_splats(3000, 2, 22);
  const std::string bytes = ply_of(splats, rich_text());
  SplatEdit move;
  move.similarity.move = {1.0, 2.0, 3.0};
  Splats moved = splats;
  for (Splat& splat : moved)
    splat.position = (splat.position + Eigen::Vector3d(1.0, 2.0, 3.0)).cast<float>().cast<double>();
  EXPECT_TRUE(converted(bytes, move) == ply_of(moved, rich_text()));
  const std::string turned = converted(bytes, third_turn());
  ASSERT_EQ(turned.size(), bytes.size());
  const Splats after = splats_of_ply(turned);
  EXPECT_TRUE(ply_of(after, rich_text()) == turned) << "all other bytes agree";
  for (std::size_t i = 0; i < splats.size(); ++i) {
    ASSERT_EQ(after[i].log_scale, splats[i].log_scale);
    ASSERT_EQ(after[i].opacity, splats[i].opacity);
    ASSERT_EQ(after[i].coefficients.col(0), splats[i].coefficients.col(0));
  }
}

TEST(SplatPly, KeepsHeaderPropertiesAndElementsOfACroppedFile) {
  const Splats splats = random_splats(40, 1, 23);
  SplatEdit edit;
  edit.crop = Eigen::AlignedBox3d(Eigen::Vector3d(-1e4, -1e4, -1e4), Eigen::Vector3d(0.0, 1e4, 1e4));
  const std::string cropped = converted(ply_of(splats, rich_text()), edit);
  const auto kept = static_cast<std::size_t>(
      std::count_if(splats.begin(), splats.end(), [](const Splat& s) { return s.position.x() <= 0.0; }));
  const std::string header = ply_of(splats, rich_text()).substr(0, ply_of(splats, rich_text()).find("end_header"));
  std::string expected = header;
  expected.replace(expected.find("vertex 40"), 9, fmt::format("vertex {}", kept));
  EXPECT_EQ(cropped.substr(0, cropped.find("end_header")), expected);
  EXPECT_TRUE(cropped.ends_with("0123456789"));
  EXPECT_EQ(splats_of_ply(cropped).size(), kept);
}

TEST(SplatPly, ReadsEveryEncodingAlike) {
  const Splats splats = random_splats(300, 3, 24);
  const std::string expected = converted(ply_of(splats), third_turn());
  for (const PlyText& text : {PlyText{.format = "ascii"}, PlyText{.format = "binary_big_endian"}}) {
    EXPECT_TRUE(converted(ply_of(splats, text), third_turn()) == expected) << text.format;
  }
}

TEST(SplatPly, NeedsNoNormalsAndTakesDoubles) {
  const Splats splats = random_splats(300, 3, 25);
  const Splats expected = splats_of_ply(converted(ply_of(splats), third_turn()));
  const std::string plain = converted(ply_of(splats, {.normals = false}), third_turn());
  EXPECT_EQ(plain.find("property float nx"), std::string::npos);
  const Splats without = splats_of_ply(plain);
  for (std::size_t i = 0; i < splats.size(); ++i) ASSERT_EQ(without[i].coefficients, expected[i].coefficients);
  const std::string doubles = converted(ply_of(splats, {.doubles = true}), third_turn());
  EXPECT_EQ(doubles, ply_of(expected, {.doubles = true}));
}

TEST(SplatPly, TurnsNormals) {
  const Splats splats = random_splats(1, 0, 26);
  std::string bytes = ply_of(splats);
  const std::size_t body = bytes.find("end_header\n") + 11;
  const float normal[3] = {1.0F, 0.0F, 0.0F};
  bytes.replace(body + 12, 12, std::string(reinterpret_cast<const char*>(normal), 12));
  const std::string turned = converted(bytes, third_turn());  // x -> y -> z -> x
  float now[3] = {};
  std::copy_n(turned.begin() + static_cast<std::ptrdiff_t>(body) + 12, 12, reinterpret_cast<char*>(now));
  EXPECT_NEAR(now[1], 1.0F, 1e-6F);
}

TEST(SplatPly, AnotherDegreeKeepsEverythingElse) {
  const Splats splats = random_splats(200, 3, 27);
  SplatEdit edit;
  edit.degree = 1;
  const std::string changed = converted(ply_of(splats, rich_text()), edit);
  Splats cut = splats;
  for (Splat& splat : cut) splat.coefficients = Eigen::MatrixXd(splat.coefficients.leftCols(4));
  EXPECT_TRUE(changed == ply_of(cut, rich_text()));
  edit.degree = 3;
  for (Splat& splat : cut) {
    splat.coefficients.conservativeResize(3, 16);
    splat.coefficients.rightCols(12).setZero();
  }
  const std::string filled = converted(changed, edit);
  EXPECT_EQ(filled.size(), ply_of(cut, rich_text()).size());
  const Splats after = splats_of_ply(filled);
  for (std::size_t i = 0; i < cut.size(); ++i) ASSERT_EQ(after[i].coefficients, cut[i].coefficients);
}

TEST(SplatPly, WithoutSplatsIsAFileToo) {
  const std::string bytes = ply_of({}, rich_text());
  EXPECT_EQ(converted(bytes), bytes);
  EXPECT_EQ(converted(bytes, third_turn()), bytes);
}

}  // namespace
}  // namespace sh::prt::test
