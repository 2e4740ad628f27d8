// Transfer files whose receivers are the points of a grid: round trips are exact, bad content is refused in one line, and
// commands for surfaces do not take them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "prt/transfer/point_grid.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/lights.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/transfer_bytes.hpp"

namespace sh::prt::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

PointGrid small_grid() { return {{Eigen::Vector3d(-1.5, 0.25, 2.0), Eigen::Vector3d(0.5, 1.25, 6.0)}, {3, 2, 5}, 4}; }

Transfer small_volume(int degree = 1, int result_degree = 2) {
  Transfer volume = Transfer::of(kNeighborhood, degree);
  volume.scene = "space";
  volume.shape.result_degree = result_degree;
  volume.grid = small_grid();
  volume.directions = 64;
  volume.instruction_set = "avx2";
  volume.coefficients = random_values(volume.receivers() * volume.shape.length(), 3);
  return volume;
}

TEST(PointGrid, CountsItsPointsXFastestFromCornerToCorner) {
  const PointGrid grid = small_grid();
  EXPECT_EQ(grid.points(), 30U);
  EXPECT_EQ(grid.spacing(), Eigen::Vector3d(1.0, 1.0, 1.0));
  std::size_t index = 0;
  for (std::uint32_t k = 0; k < 5; ++k) {
    for (std::uint32_t j = 0; j < 2; ++j) {
      for (std::uint32_t i = 0; i < 3; ++i, ++index) {
        EXPECT_EQ(grid.index({i, j, k}), index);
        EXPECT_EQ(grid.place(index), (std::array<std::uint32_t, 3>{i, j, k}));
        EXPECT_EQ(grid.point(index), Eigen::Vector3d(i - 1.5, j + 0.25, k + 2.0));
      }
    }
  }
  EXPECT_EQ(grid.point(29), grid.box.max());
}

TEST(PointGrid, SaysWhatIsWrongWithItsBoxAndCounts) {
  const auto flaw = [](const auto& change) {
    PointGrid grid = small_grid();
    change(grid);
    return flaw_of(grid);
  };
  EXPECT_EQ(flaw([](PointGrid&) {}), "");
  for (const double bad : {kNan, kInfinity, -kInfinity, 1.1e30}) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NE(flaw([&](PointGrid& g) { g.box.max()[axis] = bad; }).find("three sides above 0"), std::string::npos)
          << bad;
      EXPECT_NE(flaw([&](PointGrid& g) { g.box.min()[axis] = bad; }).find("three sides above 0"), std::string::npos)
          << bad;
    }
  }
  EXPECT_NE(flaw([](PointGrid& g) { g.box.max().y() = g.box.min().y(); }), "");
  EXPECT_NE(flaw([](PointGrid& g) { g.box.setEmpty(); }), "");
  for (const std::uint32_t bad : {0U, 1U, kMostAlong + 1, std::numeric_limits<std::uint32_t>::max()}) {
    EXPECT_NE(flaw([&](PointGrid& g) { g.counts[1] = bad; }).find("along an axis"), std::string::npos) << bad;
  }
  EXPECT_EQ(flaw([](PointGrid& g) { g.counts = {kMostAlong, kMostAlong, 8}; }), "") << "all that are allowed";
  EXPECT_NE(flaw([](PointGrid& g) { g.counts = {kMostAlong, kMostAlong, 9}; }), "");
  EXPECT_EQ(flaw([](PointGrid& g) { g.filled = 30; }), "");
  EXPECT_EQ(flaw([](PointGrid& g) { g.filled = 31; }), "31 points of its grid are filled, expected at most 30");
}

class GridFile : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal(TransferKinds kinds = file_kinds()) const {
    std::string said = message_of([&] { read_transfer(file_, kinds); });
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  }

  // What the reader says of a header in which `from` is replaced by `to`, which is no longer.
  std::string with_header(const std::string& from, std::string to) {
    std::string bytes = read_all(file_);
    const std::string good = bytes;
    const std::size_t place = bytes.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    EXPECT_LE(to.size(), from.size());
    to.resize(from.size(), ' ');
    write_all(file_, with_checksums(bytes.replace(place, from.size(), to)));
    std::string said = refusal();
    write_all(file_, good);
    return said;
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.transfer");
};

TEST_F(GridFile, GivesBackWhatWasWrittenWhateverTheDegreesAndTheStorage) {
  for (const auto& [degree, result] : {std::pair{0, 0}, {1, 2}, {2, 4}, {0, 5}, {4, 4}, {5, 5}}) {
    const Transfer written = small_volume(degree, result);
    write_transfer(file_, written);
    const Transfer read = read_transfer(file_, volume_kinds());
    EXPECT_EQ(read.kind, &kNeighborhood);
    ASSERT_TRUE(read.grid);
    EXPECT_EQ(read.grid->box.min(), written.grid->box.min());
    EXPECT_EQ(read.grid->box.max(), written.grid->box.max());
    EXPECT_EQ(read.grid->counts, written.grid->counts);
    EXPECT_EQ(read.grid->filled, written.grid->filled);
    EXPECT_TRUE(is_alike(read.shape, written.shape));
    EXPECT_EQ(read.shape.columns(), coefficient_count(degree + result));
    EXPECT_EQ(read.coefficients, written.coefficients);
    EXPECT_TRUE(read.mesh.positions.empty());
    EXPECT_EQ(transfer_header(read), transfer_header(written));
  }
  Transfer half = small_volume();
  half.shape.storage.element = Element::kHalf;
  write_transfer(file_, half);
  const Transfer read = read_transfer(file_, file_kinds());
  EXPECT_TRUE(read.coefficients.empty());  // they stay as they are stored
  const std::vector<float> numbers = read.rows().all();
  ASSERT_EQ(numbers.size(), half.coefficients.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_NEAR(numbers[i], half.coefficients[i], 0x1p-11F);
  }
}

TEST_F(GridFile, IsNoFileOfASurface) {
  write_transfer(file_, small_volume());
  EXPECT_EQ(message_of([&] { read_transfer(file_); }),
            file_ + ": transfer of kind N, expected one of DU, DS, DI, GU, GS, GI, DT");
  write_transfer(file_, baked(primitive_mesh("plane"), &kShadowed, 64, 1));
  EXPECT_EQ(refusal(volume_kinds()), file_ + ": transfer of kind DS, expected one of N, NI");
  EXPECT_EQ(refusal(), "");
}

TEST_F(GridFile, IsNotWrittenWithAGridThatDoesNotFit) {
  const auto refused = [&](const auto& change) {
    Transfer volume = small_volume();
    change(volume);
    std::string said = message_of([&] { write_transfer(file_, volume); });
    EXPECT_EQ(folder_.entries(), 0U) << said;
    return said;
  };
  EXPECT_NE(refused([](Transfer& v) { v.grid.reset(); }).find("a grid and no mesh"), std::string::npos);
  EXPECT_NE(refused([](Transfer& v) { v.mesh = primitive_mesh("plane"); }).find("a grid and no mesh"),
            std::string::npos);
  EXPECT_NE(refused([](Transfer& v) { v.kind = &kGlossyShadowed; }).find("no grid"), std::string::npos);
  EXPECT_NE(refused([](Transfer& v) { v.coefficients.pop_back(); }).find("differ in length"), std::string::npos);
  EXPECT_NE(refused([](Transfer& v) { v.grid->box.max().x() = kNan; }).find("three sides"), std::string::npos);
  EXPECT_NE(refused([](Transfer& v) { v.coefficients[7] = std::numeric_limits<float>::infinity(); }).find("not finite"),
            std::string::npos);
}

TEST_F(GridFile, IsRefusedWithAHeaderThatIsNoGrid) {
  write_transfer(file_, small_volume());
  const std::string counts = "    \"counts\": [\n      3,\n      2,\n      5\n    ]";
  EXPECT_EQ(with_header(counts, counts), "");
  EXPECT_EQ(with_header(counts, "\"counts\":[2,3,5]"), "") << "as many points";
  EXPECT_EQ(with_header(counts, "\"counts\":[3,2,4]"),
            file_ + ": damaged transfer file: section transfer does not fit");
  for (const char* bad : {"[0,2,5]", "[30,1,1]", "[3,2,4097]", "[4096,4096,9]"}) {
    EXPECT_NE(with_header(counts, std::string("\"counts\":") + bad).find("along an axis"), std::string::npos) << bad;
  }
  for (const char* bad : {"[3,2]", "[]", "[3,2,5,1]", "[3,2.5,5]", "[3,-2,5]", "[3,2,\"5\"]", "3", "null"}) {
    EXPECT_NE(with_header(counts, std::string("\"counts\":") + bad), "") << bad;
  }
  EXPECT_NE(with_header("-1.5,", "1e31,").find("three sides"), std::string::npos);
  EXPECT_NE(with_header("-1.5,", "0.5,").find("three sides"), std::string::npos);
  EXPECT_NE(with_header("-1.5,", "null,"), "");
  EXPECT_NE(with_header("\"filled\": 4", "\"filled\":31").find("at most 30"), std::string::npos);
  EXPECT_NE(with_header("\"filled\": 4", "\"filled\":-1"), "");
  EXPECT_NE(with_header("\"grid\"", "\"grip\""), "");
  EXPECT_NE(with_header("\"result_degree\": 2", "\"result_degree\": 1"), "");
  EXPECT_NE(with_header("\"result_degree\": 2", "\"result_degree\": 9"), "");
}

TEST_F(GridFile, IsRefusedWithSectionsOfAMesh) {
  write_transfer(file_, small_volume());
  const std::string good = read_all(file_);
  write_all(file_, with_checksums(with_table(good,
                                             [](auto& table) {
                                               table.insert(table.begin(), table.front());
                                               table.front().name = layout::padded("position");
                                               table.front().columns = 3;
                                               table.front().rows = 0;
                                             }),
                                  true));
  EXPECT_EQ(refusal(), file_ + ": transfer file of kind N with a section position, which it does not have");
  write_all(file_, with_checksums(with_table(good, [](auto& table) { table.clear(); }), true));
  EXPECT_NE(refusal(), "");
  std::string bytes = good;
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + place_of(bytes, "transfer"), &bad, sizeof bad);
  write_all(file_, with_checksums(bytes));
  EXPECT_EQ(refusal(), file_ + ": damaged transfer file: a transfer coefficient is not finite");
}

TEST_F(GridFile, IsRefusedWithNumbersThatAreNoVisibility) {
  Transfer volume = small_volume();
  for (const float limit : {4.0F, -4.0F}) {
    volume.coefficients[11] = limit;
    write_transfer(file_, volume);
    EXPECT_EQ(refusal(), "");
    std::string bytes = read_all(file_);
    const float beyond = std::nextafter(limit, 9.0F * limit);
    std::memcpy(bytes.data() + place_of(bytes, "transfer"), &beyond, sizeof beyond);
    write_all(file_, with_checksums(bytes));
    EXPECT_EQ(refusal(), file_ + ": damaged transfer file: a coefficient of a visibility is not from -4 to 4");
  }
}

TEST_F(GridFile, IsRefusedInOneLineWithAnyOneByteChangedOrMissing) {
  write_transfer(file_, small_volume(0, 1));
  const std::string good = read_all(file_);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bytes = good;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x41);
    write_all(file_, bytes);
    ASSERT_EQ(refusal().find(file_ + ": "), 0U) << "byte " << i;
    write_all(file_, good.substr(0, i));
    ASSERT_EQ(refusal().find(file_ + ": "), 0U) << i << " bytes";
  }
}

}  // namespace
}  // namespace sh::prt::test
