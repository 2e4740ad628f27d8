// Densities: made from a seed, read from files, refused.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "numeric/output/atomic_file.hpp"
#include "prt/binary/gzip.hpp"
#include "prt/medium/density_file.hpp"
#include "prt/medium/made_density.hpp"
#include "prt/transfer/checksum.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

// The bytes are those of every machine: the checksums were computed once.
TEST(MadeDensity, HasTheSameBytesOnEveryMachine) {
  const auto sum = [](MadeDensity made, std::uint32_t seed) {
    const std::vector<float> values = make_density(made, {24, 20, 16}, seed);
    return checksum(values.data(), values.size() * sizeof(float));
  };
  EXPECT_EQ(sum(MadeDensity::kCloud, 1), 14670575674863750826U);
  EXPECT_EQ(sum(MadeDensity::kSmoke, 7), 8539383875803204116U);
  EXPECT_NE(sum(MadeDensity::kCloud, 1), sum(MadeDensity::kCloud, 2));
}

TEST(MadeDensity, StaysWithinItsGridAndItsRange) {
  for (const MadeDensity made : {MadeDensity::kCloud, MadeDensity::kSmoke}) {
    for (const std::uint32_t seed : {0U, 1U, 2147483647U}) {
      const Density density{.counts = {20, 18, 16}, .values = make_density(made, {20, 18, 16}, seed)};
      float most = 0.0F;
      for (std::size_t v = 0; v < density.size(); ++v) {
        const Counts at = density.place(v);
        bool is_outside = false;
        for (std::size_t a = 0; a < 3; ++a) is_outside = is_outside || at[a] == 0 || at[a] == density.counts[a] - 1;
        EXPECT_TRUE(!is_outside || density.values[v] == 0.0F);
        EXPECT_TRUE(density.values[v] >= 0.0F && density.values[v] <= 1.0F);
        most = std::max(most, density.values[v]);
      }
      EXPECT_GT(most, 0.5F) << seed;
    }
  }
  EXPECT_EQ(make_density(MadeDensity::kUniform, {1, 1, 1}, 3), std::vector<float>{1.0F});
  EXPECT_EQ(make_density(MadeDensity::kCloud, {1, 2, 1}, 3).size(), 2U);
}

class DensityFile : public testing::Test {
 protected:
  /// What reading a file with these bytes says; "read" if it does.
  std::string said(const std::string& name, const std::string& bytes, const std::optional<Counts>& counts = {}) {
    const std::string path = folder.file(name);
    output::write_file(path, bytes);
    try {
      read = read_density(path, counts);
      return "read";
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(path + ": ")) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return std::string(error.what()).substr(path.size() + 2);
    }
  }

  TemporaryFolder folder;
  DensityValues read;
};

template <class T>
std::string bytes_of(const std::vector<T>& values, bool big = false) {
  std::string bytes;
  for (const T value : values) {
    std::string number(reinterpret_cast<const char*>(&value), sizeof value);
    if (big) number.assign(number.rbegin(), number.rend());
    bytes += number;
  }
  return bytes;
}

std::string gzipped(const std::string& bytes) {
  std::string all;
  for (const std::string& piece : gzip({bytes})) all += piece;
  return all;
}

std::string nrrd(const std::string& lines) {
  return "NRRD0004\n# made by a test\ntype: float\ndimension: 3\nsizes: 2 1 3\nencoding: raw\nendian: little\n" +
         lines + "\n";
}

const std::vector<float> kSix = {0.0F, 0.5F, 1.0F, 2.0F, 3.5F, 1e30F};
constexpr Counts kSizes = {2, 1, 3};

TEST_F(DensityFile, HoldsRawNumbers) {
  EXPECT_EQ(said("a.raw", bytes_of(kSix), kSizes), "read");
  EXPECT_EQ(read.values, kSix);
  EXPECT_EQ(read.counts, kSizes);
  EXPECT_EQ(said("b.raw", bytes_of(kSix)), "expected `counts` beside the name of a file of raw numbers");
  EXPECT_EQ(said("c.raw", bytes_of(kSix), Counts{2, 2, 2}), "truncated: expected 8 numbers, got 6");
  EXPECT_EQ(said("d.raw", bytes_of(kSix), Counts{1, 1, 3}), "expected 3 numbers, got further bytes after them");
  EXPECT_EQ(said("e.raw", bytes_of(kSix).substr(1), kSizes), "truncated: expected 6 numbers, got 5");
  EXPECT_EQ(said("f.raw", "", Counts{1, 1, 1}), "truncated: expected 1 numbers, got 0");
}

TEST_F(DensityFile, HoldsNrrdInEveryEncodingAndOrder) {
  EXPECT_EQ(said("a.nrrd", nrrd("") + bytes_of(kSix)), "read");
  EXPECT_EQ(read.values, kSix);
  EXPECT_EQ(read.counts, kSizes);
  EXPECT_EQ(said("b.nrrd", nrrd("encoding: gzip\n") + gzipped(bytes_of(kSix))), "read");
  EXPECT_EQ(read.values, kSix);
  EXPECT_EQ(said("c.nrrd", nrrd("endian: big\nkey:=value: 3\nspacings: 1 nan 2\r\n") + bytes_of(kSix, true)), "read");
  EXPECT_EQ(read.values, kSix);
  EXPECT_EQ(said("d.nrrd", nrrd("type: uint8\n") + std::string("\x00\x01\x7f\x80\xfe\xff", 6)), "read");
  EXPECT_EQ(read.values, (std::vector<float>{0.0F, 1.0F, 127.0F, 128.0F, 254.0F, 255.0F}));
  EXPECT_EQ(said("e.nrrd", nrrd("type: double\nencoding: gz\nendian: big\n") +
                               gzipped(bytes_of(std::vector<double>{0.0, 0.25, 0.5, 1.0, 2.0, 3.0}, true))),
            "read");
  EXPECT_EQ(read.values[1], 0.25F);
  EXPECT_EQ(said("f.nrrd", nrrd("type: unsigned short\n") + bytes_of(std::vector<std::uint16_t>{0, 1, 2, 3, 4, 65535})),
            "read");
  EXPECT_EQ(read.values[5], 65535.0F);
}

TEST_F(DensityFile, RefusesWhatItCannotRead) {
  const std::string data = bytes_of(kSix);
  const auto expect_said = [&](const std::string& lines, const std::string& reason) {
    const std::string line = said("a.nrrd", nrrd(lines) + data);
    EXPECT_NE(line.find(reason), std::string::npos) << line;
  };
  expect_said("type: block\n", "expected an NRRD file with a type of numbers such as float or uint8, got `block`");
  expect_said("dimension: 4\n", "expected an NRRD file with dimension: 3, got `dimension: 4`");
  for (const char* sizes : {"0 1 3", "2 1", "2 1 3 1", "2 1 -3", "2 1 x", "4096 4096 4096", "5000 1 1", "2.5 1 3",
                            "99999999999999999999 1 1"}) {
    expect_said(std::string("sizes: ") + sizes + "\n", "three counts of voxels from 1 to 4094");
  }
  expect_said("encoding: bzip2\n", "expected an NRRD file with the encoding raw or gzip, got `bzip2`");
  expect_said("endian: middle\n", "the endian little or big");
  expect_said("data file: other.raw\n", "its data in the same file");
  expect_said("byte skip: -1\n", "data right after its header");
  expect_said("no field\n", "lines `field: value`");
  expect_said("encoding: gzip\n", "a damaged gzip stream");
  EXPECT_EQ(said("b.nrrd", "NRRX"), "not an NRRD file: it does not begin with `NRRD000`");
  EXPECT_NE(said("b.nrrd", "NRRD0004\ntype: float\n").find("expected an empty line"), std::string::npos);
  EXPECT_EQ(said("b.nrrd", "NRRD0004\n\n"), "expected an NRRD file with a field `type`");
  EXPECT_EQ(said("b.nrrd", nrrd("") + data.substr(4)), "truncated: expected 6 numbers, got 5");
  EXPECT_EQ(said("b.nrrd", nrrd("") + data + "x"), "expected 6 numbers, got further bytes after them");
  const std::string packed = gzipped(data);
  for (std::size_t size = 0; size < packed.size(); ++size) {
    EXPECT_NE(said("c.nrrd", nrrd("encoding: gzip\n") + packed.substr(0, size)), "read") << size;
  }
  EXPECT_EQ(said("c.nrrd", nrrd("encoding: gzip\n") + gzipped(data.substr(8))), "truncated: expected 6 numbers, got 4");
  EXPECT_EQ(said("c.nrrd", nrrd("") + data, Counts{3, 1, 2}),
            "expected 3 x 1 x 2 numbers as `counts` says, got 2 x 1 x 3");
}

TEST_F(DensityFile, RefusesWhatIsNoDensity) {
  for (const float bad :
       {-1.0F, -1e-30F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    std::vector<float> values = kSix;
    values[3] = bad;
    const std::string line = said("a.raw", bytes_of(values), kSizes);
    EXPECT_TRUE(line.starts_with("expected finite densities of 0 or more, got ") && line.ends_with("at voxel 1, 0, 1"))
        << line;
  }
  EXPECT_NE(said("b.nrrd", nrrd("type: double\n") + bytes_of(std::vector<double>{0, 0, 0, 0, 0, 1e300})), "read");
  EXPECT_EQ(said("c.raw", bytes_of(std::vector<float>{-0.0F, 1e-45F, 3e38F}), Counts{3, 1, 1}), "read");
}

}  // namespace
}  // namespace sh::prt::test
