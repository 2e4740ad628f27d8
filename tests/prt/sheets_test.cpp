// Pairs of faces that coincide with opposite orientation.
#include "prt/rays/sheets.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sh::prt::test {
namespace {

// Two triangles side by side; the last three positions are those of the first, one of them with negative zeros.
const std::vector<Eigen::Vector3f> kPositions = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F},   {0.0F, 1.0F, 0.0F},
                                                 {1.0F, 1.0F, 0.0F}, {-0.0F, 0.0F, -0.0F}, {1.0F, 0.0F, 0.0F},
                                                 {0.0F, 1.0F, 0.0F}};

std::size_t tested(const std::vector<Face>& faces) { return Sheets(kPositions, faces).without_backs(faces).size(); }

TEST(Sheets, PairFacesThatCoincideTheOtherWayRound) {
  EXPECT_FALSE(Sheets(kPositions, {{0, 1, 2}, {1, 3, 2}}).any()) << "side by side";
  EXPECT_FALSE(Sheets(kPositions, {{0, 1, 2}, {1, 2, 0}, {4, 5, 6}}).any()) << "the same way round";
  EXPECT_FALSE(Sheets(kPositions, {}).any());
  for (const Face& back : {Face{0, 2, 1}, {2, 1, 0}, {1, 0, 2}, {4, 6, 5}, {6, 5, 4}, {0, 6, 5}}) {
    EXPECT_EQ(tested({{0, 1, 2}, back}), 1U);
    EXPECT_EQ(tested({{1, 3, 2}, back, {2, 0, 1}}), 2U);
  }
  EXPECT_EQ(tested({{0, 1, 2}, {1, 3, 2}}), 2U);
  EXPECT_EQ(tested({{0, 1, 2}, {0, 2, 1}, {4, 5, 6}}), 2U) << "a face belongs to one pair";
  EXPECT_EQ(tested({{0, 1, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 5}}), 2U);
}

TEST(Sheets, PairEachFaceOnceWhereSeveralCoincide) {
  const std::vector<Face> faces = {{0, 1, 2}, {4, 5, 6}, {0, 2, 1}, {4, 6, 5}};
  const Sheets sheets(kPositions, faces);
  ASSERT_EQ(sheets.without_backs(faces).size(), 2U);
  for (std::uint32_t f = 0; f < 2; ++f) {
    Hit hit{f, 0.2F, 0.3F, 1.0F, true};
    sheets.face_ray(hit);
    EXPECT_EQ(hit.face, f + 2);
    EXPECT_FALSE(hit.from_behind);
  }
}

TEST(Sheets, TellWhichSideARayMeets) {
  for (const Face& back : {Face{0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
    const std::vector<Face> faces = {{1, 3, 2}, back, {0, 1, 2}, {1, 2, 3}, {3, 1, 0}};
    const Sheets sheets(kPositions, faces);
    const std::vector<Face> fronts = sheets.without_backs(faces);
    ASSERT_EQ(fronts.size(), 3U);
    const std::array<std::uint32_t, 3> first = {0, 1, 4};
    const std::array<std::uint32_t, 3> other = {3, 2, 4};
    for (std::uint32_t f = 0; f < 3; ++f) {
      EXPECT_EQ(fronts[f], faces[first[f]]);
      EXPECT_EQ(sheets.count_before(first[f]), f);
      for (const bool from_behind : {false, true}) {
        Hit hit{f, 0.2F, 0.3F, 1.0F, from_behind};
        sheets.face_ray(hit);
        EXPECT_EQ(hit.face, from_behind ? other[f] : first[f]);
        EXPECT_EQ(hit.from_behind, from_behind && f == 2) << "only a face without a back is met from behind";
        const auto place = [&](const Face& face, const Hit& at) {
          const auto [a, b, c] = at.parts();
          return (a * kPositions[face[0]] + b * kPositions[face[1]] + c * kPositions[face[2]]).eval();
        };
        EXPECT_LT((place(faces[hit.face], hit) - place(fronts[f], {f, 0.2F, 0.3F})).norm(), 1e-6F);
      }
    }
    EXPECT_EQ(sheets.count_before(5), 3U);
  }
}

}  // namespace
}  // namespace sh::prt::test
