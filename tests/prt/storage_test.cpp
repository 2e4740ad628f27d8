// Storage of transfer vectors in files: every error is within its bound for numbers of every size.
#include "prt/transfer/storage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "prt/kinds/kinds.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr std::size_t kLength = 12;  // three channels of four

TransferShape shape_of(const Storage& storage) {
  TransferShape shape = kInterreflected.shape(1);
  shape.storage = storage;
  return shape;
}

std::vector<float> random_rows(std::size_t rows, float size) {
  std::vector<float> values = random_values(rows * kLength, 7);
  for (float& value : values) value *= size;
  return values;
}

/// The largest error in units of its bound, column by column.
double error_over_bound(const std::vector<float>& rows, Element element) {
  const Storage storage{element, false, {}};
  const std::vector<float> back = decode(encode(rows, shape_of(storage)), shape_of(storage));
  const std::size_t length = kLength;
  double worst = 0.0;
  for (std::size_t column = 0; column < length; ++column) {
    double largest = 0.0;
    double error = 0.0;
    for (std::size_t i = column; i < rows.size(); i += length) {
      largest = std::max(largest, std::abs(static_cast<double>(rows[i])));
      error = std::max(error, std::abs(static_cast<double>(rows[i]) - static_cast<double>(back[i])));
    }
    const double bound = encoding_error(element, largest);
    worst = std::max(worst, error == 0.0 ? 0.0 : error / bound);
  }
  return worst;
}

TEST(Storage, KeepsEveryNumberWithinItsBound) {
  for (const float size : {1.0F, 1e-3F, 6e4F, 1e-6F, 1e-7F}) {
    EXPECT_EQ(error_over_bound(random_rows(300, size), Element::kSingle), 0.0);
    EXPECT_LE(error_over_bound(random_rows(300, size), Element::kHalf), 1.0) << size;
    EXPECT_LE(error_over_bound(random_rows(300, size), Element::kByte), 1.0) << size;
    EXPECT_GT(error_over_bound(random_rows(300, size), Element::kHalf), 0.5) << "a bound far off tells nothing";
    EXPECT_GT(error_over_bound(random_rows(300, size), Element::kByte), 0.9) << "a bound far off tells nothing";
  }
}

TEST(Storage, KeepsExtremesWithinTheirBounds) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  for (const float size : {kLargest, std::numeric_limits<float>::min(), 200.0F * kDenormal, kDenormal, 0.0F}) {
    std::vector<float> rows(3 * kLength, size);
    rows[0] = -size;
    rows[1] = 0.0F;
    EXPECT_LE(error_over_bound(rows, Element::kByte), 1.0) << size;
    if (size < 6e4F) {
      EXPECT_LE(error_over_bound(rows, Element::kHalf), 1.0) << size;
    }
  }
  EXPECT_LE(error_over_bound(std::vector<float>(12, 65504.0F), Element::kHalf), 1.0);
}

TEST(Storage, RefusesWhatAnElementCannotHold) {
  const Storage half{Element::kHalf, false, {}};
  EXPECT_NE(message_of([&] { encode(std::vector<float>(12, 65520.0F), shape_of(half)); }).find("does not fit"),
            std::string::npos);
  EXPECT_EQ(encoding_error(Element::kHalf, 65520.0), std::numeric_limits<double>::infinity());
  for (const Element element : {Element::kSingle, Element::kHalf, Element::kByte}) {
    const std::vector<float> rows(12, std::numeric_limits<float>::infinity());
    EXPECT_NE(message_of([&] { encode(rows, shape_of({element, false, {}})); }), "");
  }
  EXPECT_NE(message_of([&] { encode(std::vector<float>(13), shape_of(half)); }), "");
  EXPECT_NE(message_of([&] { encode(std::vector<float>(12), shape_of({Element::kHalf, false, {0, 4}})); }), "");
  EXPECT_NE(message_of([&] { encode(std::vector<float>(12), shape_of({Element::kHalf, false, {2, 1}})); }), "");
}

TEST(Storage, KeepsTheCoefficientsItIsToldToAndOneChannelForAll) {
  const std::vector<float> rows = random_rows(5, 1.0F);
  const Storage storage{Element::kSingle, true, {0, 2}};
  const Encoded encoded = encode(rows, shape_of(storage));
  EXPECT_EQ(encoded.data.size(), 5 * 2 * sizeof(float));
  EXPECT_EQ(shape_of(storage).stored_length(), 2U);
  const std::vector<float> back = decode(encoded, shape_of(storage));
  ASSERT_EQ(back.size(), rows.size());
  for (std::size_t row = 0; row < rows.size(); row += 12) {
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(back[row + i], i % 4 % 2 == 0 ? rows[row + i % 4] : 0.0F);
    }
  }
}

}  // namespace
}  // namespace sh::prt::test
