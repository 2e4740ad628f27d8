// Rotation matrices: the convention is named, digits lost near identity are found though the matrix stays orthogonal.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "numeric/output/formatted.hpp"
#include "tests/numeric/identify_data.hpp"
#include "tests/numeric/rotation_matrix_data.hpp"

namespace sh::numeric::identify {
namespace {

bool names_preset(const RotationCheck& result, const std::string& name) {
  return std::any_of(result.readings.begin(), result.readings.end(), [&](const RotationReading& r) {
    return holds(r.presets.own, name) && !r.inverse && !r.transposed;
  });
}

double largest(const RotationCheck& result, double BandErrors::*kind) {
  double largest = 0;
  for (const auto& band : result.bands) largest = std::max(largest, band.*kind);
  return largest;
}

TEST(RotationMatrix, OfEveryPresetIsRecognized) {
  for (const Preset& preset : presets()) {
    if (preset.convention.order == IndexOrder::kCosineSineArray) continue;  // an array is no vector to multiply
    for (const int degree : {1, 2, 3}) {
      const auto result = check_rotations(make_rotations(preset.convention, degree), 1e-12);
      EXPECT_TRUE(result.passes()) << preset.name << degree;
      EXPECT_TRUE(names_preset(result, preset.name)) << preset.name << degree << result.readings[0].describe();
      EXPECT_LT(largest(result, &BandErrors::error), 1e-13) << preset.name << degree;
    }
  }
}

TEST(RotationMatrix, OfOtherAxesAndOrdersIsRecognized) {
  int wrong = 0;
  for (std::size_t i = 0; i < all_axes().size(); i += 7) {
    Convention c;
    c.axes = all_axes()[i];
    c.order = static_cast<IndexOrder>(i % 3);
    c.normalization = i % 2 == 0 ? Normalization::kOrthonormal : Normalization::kUnnormalized;
    const auto result = check_rotations(make_rotations(c, 3), 1e-12);
    const bool found = std::any_of(result.readings.begin(), result.readings.end(), [&](const RotationReading& r) {
      Axes negative = r.convention.axes;
      for (int& sign : negative.sign) sign = -sign;
      return (r.convention.axes == c.axes || negative == c.axes) && r.convention.order == c.order &&
             r.convention.normalization == c.normalization && !r.convention.condon_shortley && !r.inverse;
    });
    wrong += found && result.passes() ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}

// Exchanges rows and columns of every band.
void transpose(RotationCases& cases) {
  for (auto& one : cases.cases) {
    for (std::size_t l = 0; l < one.bands.size(); ++l) {
      const std::size_t width = 2 * l + 1;
      for (std::size_t i = 0; i < width; ++i) {
        for (std::size_t k = 0; k < i; ++k) std::swap(one.bands[l][i * width + k], one.bands[l][k * width + i]);
      }
    }
  }
}

TEST(RotationMatrix, TransposedOrOfTheInverseIsRecognized) {
  for (const char* name : {"shforge", "unity", "scipy"}) {
    auto cases = make_rotations(preset_named(name).convention, 3);
    transpose(cases);
    const auto result = check_rotations(cases, 1e-12);
    EXPECT_TRUE(result.passes()) << name;
    EXPECT_TRUE(result.readings[0].inverse || result.readings[0].transposed) << name;
    EXPECT_TRUE(holds(result.readings[0].presets.own, name));
  }
}

TEST(RotationMatrix, InFloatPassesWithItsError) {
  const auto result = check_rotations(make_float_rotations(5, false), 0);
  EXPECT_TRUE(result.passes()) << format_text(result, false);
  EXPECT_EQ(result.epsilon, 0x1p-23);
  EXPECT_GT(largest(result, &BandErrors::error), 1e-8);
  EXPECT_LT(largest(result, &BandErrors::error), 1e-6);
}

TEST(RotationMatrix, MayErrBySixteenEpsilonsTimesItsBands) {
  for (const std::size_t l : {1U, 2U, 3U}) {
    for (const double share : {0.5, 1.5}) {
      auto cases = make_float_rotations(3, false);
      cases.cases.front().bands[l][1] += share * 16 * static_cast<double>(l + 1) * 0x1p-23;
      EXPECT_EQ(check_rotations(cases, 0).passes(), share < 1) << l << ' ' << share;
    }
  }
  EXPECT_EQ(check_rotations(make_rotations({}, 2), 0).epsilon, 0x1p-52);
}

// Orthogonality does not show this.
TEST(RotationMatrix, ThatLosesDigitsNearIdentityIsFoundThoughOrthogonal) {
  const auto result = check_rotations(make_float_rotations(5, true), 0);
  EXPECT_TRUE(result.fits);
  EXPECT_FALSE(result.passes());
  EXPECT_LT(largest(result, &BandErrors::defect), 2e-6);
  EXPECT_GT(largest(result, &BandErrors::error), 1e-4);
  EXPECT_NE(result.diagnosis.find("sqrt(1 - cos^2(beta))"), std::string::npos) << result.diagnosis;
  for (const std::size_t i : result.failing) {
    EXPECT_LT(angles_of(result.cases.cases[i], Axes{}).tilt, 0.05) << i;
  }
  const auto text = format_text(result, false);
  EXPECT_NE(text.find("diagnosis: only rotations that hardly tilt"), std::string::npos) << text;
  EXPECT_EQ(nlohmann::json::parse(format_json(result)).at("passes"), false);
}

TEST(RotationMatrix, WithAFlippedSignIsNamed) {
  for (int m = -2; m <= 2; ++m) {
    auto cases = make_rotations({}, 2);
    for (auto& one : cases.cases) {
      for (int k = 0; k < 5; ++k) one.bands[2][(m + 2) * 5 + k] *= -1;
    }
    const auto result = check_rotations(cases, 1e-12);
    EXPECT_FALSE(result.passes());
    ASSERT_EQ(result.wrong.size(), 1);
    EXPECT_EQ(result.wrong[0].degree, 2);
    EXPECT_EQ(result.wrong[0].row, m);
    EXPECT_EQ(result.wrong[0].reason, "row m=" + std::to_string(m) + " has the other sign");
    EXPECT_NE(format_text(result, false).find("first wrong: line 2, band l=2, row m=" + std::to_string(m)),
              std::string::npos);
  }
  auto cases = make_rotations({}, 3);
  for (auto& one : cases.cases) one.bands[3][10] *= -1;
  const auto result = check_rotations(cases, 1e-12);
  ASSERT_EQ(result.wrong.size(), 1);
  EXPECT_EQ(result.wrong[0].row, -2);
  EXPECT_EQ(result.wrong[0].column, 0);
  EXPECT_EQ(result.wrong[0].reason, "sign flipped");
}

TEST(RotationMatrix, WrongInOneSpecialCaseOnlyIsFound) {
  auto cases = make_rotations({}, 2);
  cases.cases[4].bands[1] = {0, 0, 1, 0, 1, 0, 1, 0, 0};  // identity
  const auto result = check_rotations(cases, 1e-12);
  EXPECT_TRUE(result.fits);
  EXPECT_EQ(result.failing, std::vector<std::size_t>{4});
}

std::string row_of(const Matrix3& r, std::size_t entries) {
  std::string text;
  for (const double v : r) {
    text += output::formatted("%.17g,", v);
  }
  for (std::size_t i = 0; i < entries; ++i) text.append(i > 0 ? ",0" : "1");
  return text.append("\n");
}

void expect_refused(const std::string& text, const std::string& start, const std::string& part) {
  expect_refusal([&] { (void)read_rotation_cases(parse_table("my.csv", text)); }, start, part);
}

TEST(RotationMatrix, RefusesWhatIsNoRotation) {
  const Matrix3 good = tilted_turn<double>(0.4, 1.1, -0.9);
  Matrix3 scaled = good, mirrored = good;
  for (double& v : scaled) v *= 1.001;
  for (double& v : mirrored) v = -v;
  expect_refused(row_of(good, 10) + row_of(scaled, 10),
                 "my.csv:2: ", "expected a rotation, |R R^T - 1| at most 1e-05, got 0.002");
  expect_refused(row_of(mirrored, 10), "my.csv:1: ", "reflection");
  expect_refused(
      row_of(good, 12), "my.csv:1: ",
      "(bands^2)^2 entries (16, 81, 256, ...) or the bands' own (10, 35, 84, ...), degree 1 to 20, got 21 columns");
  expect_refused(row_of(good, 10) + row_of(good, 9), "my.csv:2: ", "expected 19 columns as on line 1, got 18");
  expect_refused("1,0,0,0,1,0,0,0\n", "my.csv:1: ", "8 columns");
  expect_refused(row_of({1, 0, 0, 0, 1, 0, 0, 0, 1}, 10), "my.csv: ", "expected a rotation by 0.2 to 2.9 radians");
  expect_refused("0.5i" + row_of(good, 10).substr(4), "my.csv:1: ", "expected a number");
}

TEST(RotationMatrix, ReadsWholeMatricesAndBands) {
  const Matrix3 good = tilted_turn<double>(0.4, 1.1, -0.9);
  EXPECT_EQ(read_rotation_cases(parse_table("t", row_of(good, 10))).cases[0].bands[1].size(), 9);
  auto table = parse_table("t", row_of(good, 81));
  for (std::size_t i = 0; i < 81; ++i) table.rows[0].cells[9 + i] = static_cast<double>(i);
  const auto whole = read_rotation_cases(table);
  EXPECT_EQ(whole.degree, 2);
  EXPECT_EQ(whole.cases[0].bands[1][3], std::complex<double>(2 * 9 + 1));
  EXPECT_EQ(whole.cases[0].bands[2][24], std::complex<double>(80));
  EXPECT_EQ(whole.cases[0].between_bands, 75);  // row 8, column 3
}

}  // namespace
}  // namespace sh::numeric::identify
