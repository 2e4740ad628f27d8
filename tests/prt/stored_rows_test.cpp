// Rows as files store them: complete again in pieces, and relit with the bits of complete rows, for every kind of
// transfer, element, choice of columns and count of vertices.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "prt/runtime/glossy.hpp"
#include "prt/runtime/relight.hpp"
#include "prt/transfer/rows.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "prt/transfer/widen.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr const TransferKind* kDiffuse[] = {&kUnshadowed, &kShadowed, &kInterreflected};
constexpr std::size_t kCounts[] = {0, 1, 15, 16, 17, 700};  // the last: several pieces
constexpr int kDegree = 2;

// Single precision without all columns is stored, too.
std::vector<Storage> storages(const TransferShape& shape) {
  std::vector<Storage> all;
  for (const Element element : {Element::kSingle, Element::kHalf, Element::kByte}) {
    for (const bool one_channel : {false, true}) {
      if (one_channel && shape.channels == 1) continue;
      for (const auto& kept : {std::vector<std::uint32_t>{}, {0}, {0, 2, 6}, {1, 3, 4, 5, 7, 8}}) {
        all.push_back({element, one_channel, kept});
      }
    }
  }
  return all;
}

std::string name_of(const Transfer& transfer) {
  const Storage& storage = transfer.shape.storage;
  return fmt::format("{} {}{} {} of {}", transfer.kind->letters, word_of(storage.element, kElementNames),
                     storage.one_channel ? " gray" : "", storage.kept.size(), transfer.mesh.positions.size());
}

// A number of a file, one at a time, by the definition of its type (IEEE 754 binary16 by its value).
double number_of(const Encoded& encoded, Element element, std::size_t i, std::size_t column) {
  const std::byte* at = encoded.data.data() + i * bytes_of(element);
  if (element == Element::kByte) {
    return static_cast<double>(static_cast<std::int8_t>(*at)) * static_cast<double>(encoded.scale[column]);
  }
  if (element == Element::kSingle) {
    float value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  }
  std::uint16_t bits;
  std::memcpy(&bits, at, sizeof bits);
  const int exponent = bits >> 10 & 31;
  const double size = exponent == 0 ? std::ldexp(bits & 1023, -24) : std::ldexp(1024 + (bits & 1023), exponent - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

// Complete rows, one number at a time.
std::vector<float> plain_rows(const Encoded& encoded, const TransferShape& shape, std::size_t rows) {
  const Storage& storage = shape.storage;
  const std::vector<std::uint32_t>& kept = storage.kept;
  const std::size_t of_channel = shape.rows() * (kept.empty() ? shape.columns() : kept.size());
  const std::size_t of_row = of_channel * (storage.one_channel ? 1 : shape.channels);
  std::vector<float> numbers;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t channel = 0; channel < shape.channels; ++channel) {
      std::size_t column = storage.one_channel ? 0 : channel * of_channel;
      for (std::size_t k = 0; k < shape.count(); ++k) {
        const auto index = static_cast<std::uint32_t>(k % shape.columns());
        const bool is_there = kept.empty() || std::find(kept.begin(), kept.end(), index) != kept.end();
        numbers.push_back(
            is_there ? static_cast<float>(number_of(encoded, storage.element, row * of_row + column, column)) : 0.0F);
        column += is_there ? 1U : 0U;
      }
    }
  }
  return numbers;
}

struct Pair {
  Transfer stored;    // as read from a file
  Transfer complete;  // the same numbers in single precision
};

Pair pair_of(const TransferKind& kind, std::size_t vertices, const Storage& storage) {
  Transfer complete = random_transfer(kind, kDegree, vertices);
  complete.shape.storage = storage;
  Transfer stored = complete;
  stored.stored = encode(complete.coefficients, complete.shape);
  stored.coefficients.clear();
  complete.coefficients = plain_rows(stored.stored, stored.shape, vertices);
  return {std::move(stored), std::move(complete)};
}

// Diffuse rows in blocks, too, as a reader arranges them.
template <class Check>
void for_pairs(const TransferKind& kind, const Check& check) {
  for (const std::size_t vertices : kCounts) {
    for (const Storage& storage : storages(kind.shape(kDegree))) {
      Pair pair = pair_of(kind, vertices, storage);
      SCOPED_TRACE(name_of(pair.stored));
      check(pair);
      if (kind.is_glossy()) continue;
      SCOPED_TRACE("in blocks");
      to_blocks(pair.stored.stored, pair.stored.shape);
      check(pair);
    }
  }
}

LightCoefficients light_for(const Transfer& transfer, bool is_white) {
  LightCoefficients light = random_light(transfer.degree(), 3);
  if (is_white) light = white(light);
  const std::vector<std::uint32_t>& kept = transfer.shape.storage.kept;
  for (std::size_t i = 0; !kept.empty() && i < light.values.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i % light.bands_squared());
    if (std::find(kept.begin(), kept.end(), index) == kept.end()) light.values[i] = 0.0;
  }
  return light;
}

TEST(StoredRows, AreCompleteInPiecesOfAnySize) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected, &kGlossyShadowed}) {
    for_pairs(*kind, [](const Pair& pair) {
      const Rows rows = pair.stored.rows();
      const std::size_t length = pair.stored.shape.length();
      ASSERT_EQ(rows.count(), pair.stored.mesh.positions.size());
      EXPECT_EQ(rows.all(), pair.complete.coefficients);
      std::vector<float> room(7, 1.0F);  // used before
      for (std::size_t first = 0, count = 1; first + count <= rows.count(); first += count, count = count % 5 + 1) {
        const float* some = rows.some(first, count, room);
        for (std::size_t i = 0; i < count * length; ++i) {
          ASSERT_EQ(some[i], pair.complete.coefficients[first * length + i]) << first << ' ' << i;
        }
      }
    });
  }
}

TEST(StoredRows, GiveTheRadianceOfCompleteRows) {
  for (const TransferKind* kind : kDiffuse) {
    for_pairs(*kind, [](const Pair& pair) {
      for (const bool is_white : {false, true}) {
        const LightCoefficients light = light_for(pair.stored, is_white);
        EXPECT_EQ(relight(pair.stored, light), relight(pair.complete, light));
        if (pair.stored.shape.holds_albedo) continue;
        EXPECT_EQ(relight_gray(pair.stored, light), relight_gray(pair.complete, light));
        for (std::size_t v = 0; v < pair.stored.mesh.positions.size(); v += 6) {
          EXPECT_EQ(relight_vertex(pair.stored, v, light, {1.0F, 2.0F, 3.0F}),
                    relight_vertex(pair.complete, v, light, {1.0F, 2.0F, 3.0F}));
        }
      }
    });
  }
}

// More rows than the caches hold go past them.
TEST(StoredRows, ThatOutgrowTheCachesGiveTheRadianceOfCompleteRows) {
  for (const TransferKind* kind : {&kShadowed, &kInterreflected}) {
    const std::size_t vertices =
        (std::size_t{33} << 20U) / (2 * std::max<std::size_t>(1, kind->shape(kDegree).length()));
    Transfer complete = random_transfer(*kind, kDegree, vertices);
    complete.shape.storage.element = Element::kHalf;
    Transfer stored = complete;
    stored.stored = encode(complete.coefficients, complete.shape);
    stored.coefficients.clear();
    complete.coefficients = stored.rows().all();
    const LightCoefficients light = light_for(stored, false);
    EXPECT_EQ(relight(stored, light), relight(complete, light)) << kind->letters;
    to_blocks(stored.stored, stored.shape);
    EXPECT_EQ(relight(stored, light), relight(complete, light)) << kind->letters << " in blocks";
  }
}

TEST(StoredRows, OfVisibilityGiveTheRadianceOfCompleteRows) {
  for_pairs(kGlossyShadowed, [](const Pair& pair) {
    for (const bool is_white : {false, true}) {
      const LightCoefficients light = is_white ? white(random_light(kDegree, 5)) : random_light(kDegree, 5);
      const TransferredRadiance stored(pair.stored, light);
      const TransferredRadiance complete(pair.complete, light);
      for (std::size_t v = 0; v < pair.stored.mesh.positions.size(); ++v) {
        for (std::size_t i = 0; i < 3 * coefficient_count(kDegree); ++i) ASSERT_EQ(stored.at(v)[i], complete.at(v)[i]);
      }
    }
  });
}

TEST(StoredRows, OfMatricesGiveTheRadianceOfCompleteRows) {
  for (const std::size_t channels : {1U, 3U}) {
    for (const std::size_t vertices : kCounts) {
      Transfer complete = random_transfer(kGlossyInterreflected, kDegree, vertices);
      complete.indirect_shape = kGlossyInterreflected.indirect(kDegree);
      complete.indirect_shape.channels = channels;
      complete.indirect = random_values(vertices * complete.indirect_shape.length(), 8);
      Transfer stored = complete;
      stored.stored_indirect = encode(complete.indirect, complete.indirect_shape);
      stored.indirect.clear();
      complete.indirect = plain_rows(stored.stored_indirect, stored.indirect_shape, vertices);
      const LightCoefficients light = random_light(kDegree, 5);
      const TransferredRadiance from_stored(stored, light);
      const TransferredRadiance from_complete(complete, light);
      for (std::size_t v = 0; v < vertices; ++v) {
        for (std::size_t i = 0; i < 3 * coefficient_count(kDegree); ++i) {
          ASSERT_EQ(from_stored.at(v)[i], from_complete.at(v)[i]) << channels << ' ' << v;
        }
      }
    }
  }
}

TEST(StoredRows, OfAFileStayAsTheyAreAndAreWrittenAgainUnchanged) {
  const TemporaryFolder folder;
  for (const TransferKind* kind : {&kShadowed, &kInterreflected, &kGlossyShadowed}) {
    for (const Storage& storage : storages(kind->shape(kDegree))) {
      Transfer written = pair_of(*kind, 17, storage).complete;
      written.mesh.geometric_normals = written.mesh.normals;
      for (Eigen::Vector3f& albedo : written.mesh.albedo) albedo = albedo.cwiseAbs();
      write_transfer(folder.file("a"), written);
      const Transfer read = read_transfer(folder.file("a"));
      SCOPED_TRACE(name_of(read));
      if (storage.is_plain()) {
        EXPECT_EQ(read.coefficients, written.coefficients);
        EXPECT_TRUE(read.stored.empty());
      } else {
        EXPECT_TRUE(read.coefficients.empty());
        EXPECT_EQ(read.rows().bytes(), read.shape.stored_bytes(17));
        EXPECT_EQ(read.stored.data.size(), 17 * read.shape.row_bytes());
        EXPECT_EQ(read.stored.in_blocks, kind->is_diffuse());
      }
      write_transfer(folder.file("b"), read);
      EXPECT_EQ(read_all(folder.file("b")), read_all(folder.file("a")));
    }
  }
}

// Number k of receiver i of a block lies at 16 k + i; receivers after the last whole block stay rows.
TEST(StoredRows, LieInBlocksOfSixteenReceivers) {
  for (const Storage& storage : storages(kInterreflected.shape(kDegree))) {
    const Pair pair = pair_of(kInterreflected, 35, storage);
    const Encoded& rows = pair.stored.stored;
    Encoded blocks = rows;
    to_blocks(blocks, pair.stored.shape);
    const std::size_t size = bytes_of(storage.element);
    const std::size_t columns = pair.stored.shape.stored_length();
    for (std::size_t i = 0; i < 35; ++i) {
      for (std::size_t k = 0; k < columns; ++k) {
        const std::size_t place = i < 32 ? i / 16 * 16 * columns + 16 * k + i % 16 : i * columns + k;
        ASSERT_EQ(std::memcmp(&blocks.data[place * size], &rows.data[(i * columns + k) * size], size), 0)
            << i << ' ' << k;
      }
    }
    EXPECT_EQ(in_rows(blocks, pair.stored.shape).data, rows.data);
    EXPECT_EQ(blocks.scale, rows.scale);
  }
}

TEST(Columns, OfStoredRowsMayBeLeftOutWithoutRounding) {
  for (const Storage& storage : storages(kInterreflected.shape(kDegree))) {
    if (storage.kept.size() == 1) continue;
    const Pair pair = pair_of(kInterreflected, 5, storage);
    const std::vector<std::uint32_t> few =
        storage.kept.size() == 3 ? std::vector<std::uint32_t>{2, 6} : std::vector<std::uint32_t>{1, 4, 8};
    const Encoded some = with_columns(pair.stored.stored, pair.stored.shape, few);
    TransferShape shape = pair.stored.shape;
    shape.storage.kept = few;
    std::vector<float> expected = pair.complete.coefficients;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto column = static_cast<std::uint32_t>(i % shape.columns());
      if (std::find(few.begin(), few.end(), column) == few.end()) expected[i] = 0.0F;
    }
    EXPECT_EQ(decode(some, shape), expected) << name_of(pair.stored);
  }
}

TEST(Widening, GivesEveryHalfExactly) {
  std::vector<std::uint16_t> halves;
  for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
    if ((bits & 0x7c00U) != 0x7c00U) halves.push_back(static_cast<std::uint16_t>(bits));
  }
  Encoded encoded;
  encoded.data.resize(2 * halves.size());
  std::memcpy(encoded.data.data(), halves.data(), encoded.data.size());
  for (const std::size_t skipped : {0U, 1U, 5U}) {  // each as a lane of a register, and one by one at the end
    std::vector<float> wide(halves.size() - skipped);
    widen_halves(halves.data() + skipped, wide.size(), wide.data());
    for (std::size_t i = 0; i < wide.size(); ++i) {
      const auto expected = static_cast<float>(number_of(encoded, Element::kHalf, i + skipped, 0));
      ASSERT_EQ(std::bit_cast<std::uint32_t>(wide[i]), std::bit_cast<std::uint32_t>(expected)) << halves[i + skipped];
    }
  }
}

TEST(Widening, GivesEveryByteTimesItsScale) {
  std::vector<std::int8_t> bytes;
  for (int q = -128; q < 128; ++q) bytes.push_back(static_cast<std::int8_t>(q));
  for (const std::size_t columns : {1U, 2U, 3U, 16U, 25U, 64U, 256U, 400U}) {
    std::vector<float> scale;
    for (std::size_t i = 0; i < columns; ++i) scale.push_back(0.1F + static_cast<float>(i));
    std::vector<float> wide(bytes.size());
    widen_bytes(bytes.data(), bytes.size(), scale, wide.data());
    for (std::size_t i = 0; i < wide.size(); ++i) {
      ASSERT_EQ(wide[i], static_cast<float>(bytes[i]) * scale[i % columns]) << columns;
    }
  }
}

TEST(StoredRows, AreRefusedWithoutAScaleForEachColumn) {
  Transfer transfer = pair_of(kShadowed, 3, {Element::kByte, false, {}}).stored;
  transfer.stored.scale.pop_back();
  EXPECT_EQ(message_of([&] { static_cast<void>(transfer.rows()); }), "8 scales: expected 9, one a column");
}

}  // namespace
}  // namespace sh::prt::test
