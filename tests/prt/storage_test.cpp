// Storage of transfer vectors in files: every error is within its bound for numbers of every size, and files give the
// stored numbers back.
#include "prt/transfer/storage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/transfer_layout.hpp"
#include "tests/prt/meshes.hpp"
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
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-size, size);
  std::vector<float> values(rows * kLength);
  for (float& value : values) value = uniform(random);
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

Transfer stored_transfer(const Storage& storage) {
  Transfer transfer = Transfer::of(kInterreflected, 1);
  transfer.scene = "stored";
  transfer.mesh = primitive_mesh("plane");
  for (std::size_t i = 0; i < transfer.mesh.positions.size() * transfer.shape.length(); ++i) {
    transfer.coefficients.push_back(0.01F * static_cast<float>(i % 4) - 0.02F);
  }
  transfer.shape.storage = storage;
  transfer.plan = {0.01, 0.002, "any", {{"storage", "half", "it is enough", 12, 3, 0.002, "bound"}}};
  return transfer;
}

const std::vector<Storage> kStorages = {{Element::kHalf, false, {}},
                                        {Element::kByte, false, {}},
                                        {Element::kByte, true, {0, 2}},
                                        {Element::kSingle, true, {}},
                                        {Element::kHalf, true, {0, 1, 3}}};

TEST(StoredFile, GivesBackWhatItsStorageKeeps) {
  const TemporaryFolder folder;
  for (const Storage& storage : kStorages) {
    const Transfer written = stored_transfer(storage);
    write_transfer(folder.file("a"), written);
    const Transfer read = read_transfer(folder.file("a"));
    EXPECT_EQ(read.coefficients, decode(encode(written.coefficients, written.shape), written.shape));
    EXPECT_EQ(read.shape.storage.element, storage.element);
    EXPECT_EQ(read.shape.storage.kept, storage.kept);
    EXPECT_EQ(read.shape.storage.one_channel, storage.one_channel);
    EXPECT_EQ(transfer_header(read), transfer_header(written));
    write_transfer(folder.file("b"), read);
    EXPECT_EQ(read_all(folder.file("b")), read_all(folder.file("a"))) << "writing again changes nothing";
  }
}

TEST(StoredFile, IsRefusedWithAnyOneByteChangedOrMissing) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a");
  for (const Storage& storage : kStorages) {
    write_transfer(file, stored_transfer(storage));
    const std::string good = read_all(file);
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t i, char value) {
      stream.seekp(static_cast<std::streamoff>(i)).put(value).flush();
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
      put(i, static_cast<char>(good[i] ^ 0x41));
      ASSERT_EQ(message_of([&] { read_transfer(file); }).find(file + ": "), 0U) << i;
      put(i, good[i]);
    }
    EXPECT_EQ(message_of([&] { read_transfer(file); }), "");
    for (std::size_t size = good.size(); size-- > 0;) {
      std::filesystem::resize_file(file, size);
      ASSERT_EQ(message_of([&] { read_transfer(file); }).find(file + ": "), 0U) << size;
    }
  }
}

/// The file with its header's text `from` replaced by `to` (of the same length) and its checksums made good.
std::string with_header(std::string bytes, const std::string& from, const std::string& to) {
  layout::Prologue prologue;
  std::memcpy(&prologue, bytes.data(), sizeof prologue);
  std::vector<layout::Section> table(prologue.sections);
  std::memcpy(table.data(), bytes.data() + sizeof prologue, table.size() * sizeof(layout::Section));
  bytes.replace(bytes.find(from), from.size(), to);
  const std::size_t header = sizeof prologue + table.size() * sizeof(layout::Section);
  prologue.header_checksum = checksum(bytes.data() + header, prologue.header_size);
  prologue.checksum = layout::front_checksum(prologue, table);
  std::memcpy(bytes.data(), &prologue, sizeof prologue);
  return bytes;
}

TEST(StoredFile, IsRefusedWhenItsHeaderDoesNotFitItsSections) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a");
  write_transfer(file, stored_transfer({Element::kByte, true, {0, 2}}));
  const std::string good = read_all(file);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    write_all(file, with_header(good, from, to));
    return message_of([&] { read_transfer(file); });
  };
  EXPECT_NE(refusal("\"byte\"", "\"half\"").find("does not fit"), std::string::npos);
  EXPECT_NE(refusal("\"byte\"", "\"bite\"").find("storage that does not exist"), std::string::npos);
  EXPECT_NE(refusal("      2\n    ]", "      9\n    ]").find("storage that does not exist"), std::string::npos);
  EXPECT_NE(refusal("\"one_channel\": true", "\"one_channel\":    1").find("wrong type"), std::string::npos);
  EXPECT_NE(refusal("\"one_channel\": true,", "\"one_channel\":false,").find("does not fit"), std::string::npos);
}

}  // namespace
}  // namespace sh::prt::test
