// Turning splats: colors, positions and covariances turn together, for every format's numbers.
#include <gtest/gtest.h>

#include <numbers>

#include "prt/splats/convert_splats.hpp"
#include "prt/splats/splat_axes.hpp"
#include "tests/prt/splats/splat_cases.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr double kColor = 1e-5;

/// The splats of in.ply after an edit, by way of a file.
Splats edited(const Splats& splats, const SplatEdit& edit) {
  const TemporaryFolder folder;
  write_all(folder.file("in.ply"), ply_of(splats));
  convert_splats(folder.file("in.ply"), folder.file("out.ply"), edit);
  return splats_of_ply(read_all(folder.file("out.ply")));
}

SplatEdit turn(const Eigen::Matrix3d& matrix) {
  SplatEdit edit;
  edit.similarity.turn = matrix;
  return edit;
}

void expect_moved(const Splats& from, const Splats& to, const Similarity& similarity) {
  ASSERT_EQ(from.size(), to.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    SCOPED_TRACE(i);
    const Eigen::Matrix3d& m = similarity.turn;
    EXPECT_LE(color_difference(from[i], to[i], m), kColor);
    const Eigen::Vector3d position = similarity.apply(from[i].position);
    EXPECT_LE((to[i].position - position).norm(), 1e-6 * (1.0 + position.norm()));
    const Eigen::Matrix3d covariance =
        similarity.scale * similarity.scale * (m * covariance_of(from[i]) * m.transpose());
    EXPECT_LE((covariance_of(to[i]) - covariance).norm(), 3e-6 * covariance.norm());
    EXPECT_EQ(to[i].opacity, from[i].opacity);
    EXPECT_EQ(to[i].coefficients.col(0), from[i].coefficients.col(0)) << "the mean color does not turn";
  }
}

TEST(SplatRotation, TurnsColorsPositionsAndCovariancesOfEveryDegree) {
  for (int degree = 0; degree <= kHighestSplatDegree; ++degree) {
    const Splats splats = random_splats(12, degree, 3);
    for (const NamedRotation& rotation : rotations()) {
      SCOPED_TRACE(testing::Message() << rotation.name << ", degree " << degree);
      expect_moved(splats, edited(splats, turn(rotation.matrix)), {rotation.matrix});
    }
  }
}

TEST(SplatRotation, ScalesTurnsAndMovesInThisOrder) {
  const Splats splats = random_splats(12, 2, 4);
  for (const NamedRotation& rotation : rotations()) {
    for (const double scale : {1e-3, 1.0, 40.0}) {
      SCOPED_TRACE(testing::Message() << rotation.name << ", times " << scale);
      const Similarity similarity{rotation.matrix, scale, Eigen::Vector3d(0.5, -20.0, 3.0)};
      SplatEdit edit;
      edit.similarity = similarity;
      expect_moved(splats, edited(splats, edit), similarity);
    }
  }
}

TEST(SplatRotation, IsUndoneByItsInverse) {
  const Splats splats = random_splats(12, 3, 5);
  for (const NamedRotation& rotation : rotations()) {
    SCOPED_TRACE(rotation.name);
    const Splats there = edited(splats, turn(rotation.matrix));
    expect_moved(splats, edited(there, turn(rotation.matrix.transpose())), {});
  }
}

TEST(SplatRotation, TwoTurnsAreTheirProduct) {
  const Splats splats = random_splats(12, 3, 6);
  const auto all = rotations();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    SCOPED_TRACE(all[i].name + ", " + all[i + 1].name);
    const Eigen::Matrix3d product = all[i + 1].matrix * all[i].matrix;
    const Splats twice = edited(edited(splats, turn(all[i].matrix)), turn(all[i + 1].matrix));
    const Splats once = edited(splats, turn(product));
    expect_moved(splats, twice, {product});
    for (std::size_t s = 0; s < splats.size(); ++s) {
      EXPECT_LE((once[s].coefficients - twice[s].coefficients).cwiseAbs().maxCoeff(), 5e-6);
    }
  }
}

// The signs that a rotation in the wrong convention gets wrong: odd orders of the published polynomials.
TEST(SplatRotation, HasTheSignsOfThePublishedPolynomials) {
  Splat splat = random_splats(1, 1, 7)[0];
  splat.coefficients.setZero();
  splat.coefficients(0, 3) = 1.0;  // -0.4886 x
  const Eigen::Matrix3d quarter = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Splats turned = edited({splat}, turn(quarter));  // x -> y
  EXPECT_NEAR(turned[0].coefficients(0, 1), 1.0, 1e-6) << "f_rest_0, of -0.4886 y";
  EXPECT_NEAR(turned[0].coefficients(0, 3), 0.0, 1e-6);
  EXPECT_NEAR(color_of(turned[0], Eigen::Vector3d::UnitY())[0], 0.5 - 0.48860251, 1e-6);
}

TEST(SplatRotation, ChangesOfAxesKeepColorsAndShapes) {
  const Splats splats = random_splats(12, 3, 8);
  int mirrored = 0;
  for (const std::string letters : {"RDF", "RUB", "LUF", "RUF", "LUB", "FLU", "BRU", "UFR", "DBL", "FRD"}) {
    SCOPED_TRACE(letters);
    SplatEdit edit;
    edit.axes_in = "RDF";
    edit.axes_out = letters;
    const Eigen::Matrix3d matrix = between_axes("RDF", letters);
    mirrored += matrix.determinant() < 0.0 ? 1 : 0;
    const Splats changed = edited(splats, edit);
    expect_moved(splats, changed, {matrix});
    SplatEdit back;
    back.axes_in = letters;
    back.axes_out = "RDF";
    expect_moved(splats, edited(changed, back), {});
  }
  EXPECT_GE(mirrored, 3);
}

// Right, up and back of the letters, in coordinates.
TEST(SplatAxes, AreWhatTheLettersSay) {
  const Eigen::Vector3d right_down_front(1.0, 2.0, 3.0);
  EXPECT_EQ(between_axes("RDF", "RUB") * right_down_front, Eigen::Vector3d(1.0, -2.0, -3.0));
  EXPECT_EQ(between_axes("RDF", "LUF") * right_down_front, Eigen::Vector3d(-1.0, -2.0, 3.0));
  EXPECT_EQ(between_axes("RDF", "FLU") * right_down_front, Eigen::Vector3d(3.0, -1.0, -2.0));
  for (const char* bad : {"", "RD", "RDFX", "RRF", "RLF", "rdf", "XYZ", "RDFB"}) {
    EXPECT_NE(message_of([&] { splat_axes(bad); }).find("expected three letters"), std::string::npos) << bad;
  }
}

TEST(SplatTransform, RefusesWhatIsNoRotation) {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  const Eigen::Matrix3d twice = 2.0 * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = 0.01;
  Eigen::Matrix3d broken = Eigen::Matrix3d::Identity();
  broken(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of([&] {
              checked_rotation(mirror, "M");
            }).find("M: expected a rotation matrix of determinant 1, got a reflection"),
            std::string::npos);
  for (const Eigen::Matrix3d& matrix : {twice, shear, broken, Eigen::Matrix3d(Eigen::Matrix3d::Zero())}) {
    EXPECT_NE(message_of([&] { checked_rotation(matrix, "M"); }).find("M: expected a rotation matrix, whose rows"),
              std::string::npos);
  }
  for (const NamedRotation& rotation : rotations()) {
    const Eigen::Matrix3d rough = rotation.matrix.cast<float>().cast<double>();
    const Eigen::Matrix3d mended = checked_rotation(rough, "M");
    EXPECT_LE((mended * mended.transpose() - Eigen::Matrix3d::Identity()).norm(), 4e-14);
    EXPECT_LE((mended - rotation.matrix).norm(), 1e-6);
    EXPECT_EQ(checked_rotation(rotation.matrix, "M"), rotation.matrix);
  }
}

TEST(SplatTransform, OtherDegreesCutOrFillBands) {
  const Splats splats = random_splats(12, 3, 9);
  for (int degree = 0; degree <= kHighestSplatDegree; ++degree) {
    SCOPED_TRACE(degree);
    SplatEdit edit;
    edit.degree = degree;
    const Splats changed = edited(splats, edit);
    const Eigen::Index size = (degree + 1) * (degree + 1);
    const Eigen::Index common = std::min<Eigen::Index>(size, 16);
    for (std::size_t i = 0; i < splats.size(); ++i) {
      ASSERT_EQ(changed[i].coefficients.cols(), size);
      EXPECT_EQ(changed[i].coefficients.leftCols(common), splats[i].coefficients.leftCols(common));
      EXPECT_TRUE(changed[i].coefficients.rightCols(size - common).isZero(0.0));
      EXPECT_EQ(changed[i].position, splats[i].position);
      EXPECT_EQ(changed[i].rotation, splats[i].rotation);
    }
  }
}

TEST(SplatTransform, CropsByTheClosedBoxOfPositions) {
  Splats splats = random_splats(60, 1, 10);
  splats[20].position = {5.0, -5.0, 2.5};
  splats[21].position = {std::nextafter(5.0F, 6.0F), -5.0, 2.5};
  SplatEdit edit;
  edit.crop = Eigen::AlignedBox3d(Eigen::Vector3d(-8.0, -5.0, -9.0), Eigen::Vector3d(5.0, 6.0, 2.5));
  edit.similarity.move = {100.0, 0.0, 0.0};
  const Splats kept = edited(splats, edit);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < splats.size(); ++i) {
    if (edit.crop->contains(splats[i].position)) expected.push_back(i);
  }
  ASSERT_GE(expected.size(), 3U);
  ASSERT_EQ(kept.size(), expected.size());
  EXPECT_TRUE(std::find(expected.begin(), expected.end(), 20U) != expected.end());
  EXPECT_TRUE(std::find(expected.begin(), expected.end(), 21U) == expected.end());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].opacity, splats[expected[i]].opacity);
    EXPECT_NEAR(kept[i].position.x(), splats[expected[i]].position.x() + 100.0, 1e-5);
  }
}

}  // namespace
}  // namespace sh::prt::test
