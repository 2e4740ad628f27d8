// Instructions of the drivers on AVX2, counted by callgrind: the same on every machine, unlike times.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "generated/batch/batch.hpp"
#include "tests/temporary_folder.hpp"

namespace sh::test {
namespace {

namespace fs = std::filesystem;

// A driver at a degree with so many records.
struct Case {
  std::string family;
  std::string scalar;
  int degree = 0;
  long records = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads a defaulted <=>
  auto operator<=>(const Case&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.family << " " << c.scalar << " " << c.degree << ", " << c.records << " records";
}

struct Instructions {
  double batch = 0;
  double loop = 0;
};

// Adds what one dump of callgrind says: a line "desc: Trigger: Client Request: NAME", and the count of its end.
// Without callgrind nobody calls it.
[[maybe_unused]] void add_dump(const fs::path& dump, std::map<Case, Instructions>& counts) {
  const std::string mark = "Client Request: ";
  std::ifstream file(dump);
  std::string name;
  double total = 0;
  for (std::string line; std::getline(file, line);) {
    if (const auto at = line.find(mark); at != std::string::npos) name = line.substr(at + mark.size());
    if (line.starts_with("totals: ")) total = std::stod(line.substr(8));
  }
  std::istringstream words(name);
  Case of;
  std::string way;
  if (!(words >> of.family >> of.scalar >> of.degree >> of.records >> way)) return;  // the dump of the end
  (way == "batch" ? counts[of].batch : counts[of].loop) = total;
}

class InstructionCounts : public testing::Test {
 protected:
  static void SetUpTestSuite() {
#if defined(SHFORGE_VALGRIND)
    if (!batch::available(batch::InstructionSet::kAvx2)) return;
    const TemporaryFolder folder;
    const std::string command = std::string("'" SHFORGE_VALGRIND "' --tool=callgrind --callgrind-out-file='") +
                                (folder.path() / "dump").string() +
                                "' '" SHFORGE_BIN_DIR "/instruction_probe' >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    for (const auto& entry : fs::directory_iterator(folder.path())) add_dump(entry.path(), counts());
    ASSERT_GE(counts().size(), 3U * 2 * 11 * 4);
    for (const auto& [of, count] : counts()) ASSERT_TRUE(count.batch > 0 && count.loop > 0) << of;
#endif
  }
  void SetUp() override {
    if (counts().empty()) GTEST_SKIP() << "needs valgrind, a machine with AVX2 and a build without sanitizers";
  }
  static std::map<Case, Instructions>& counts() {
    static std::map<Case, Instructions> counts;
    return counts;
  }
};

#if defined(__clang__)
constexpr bool kClang = true;
#else
constexpr bool kClang = false;
#endif

// Degrees from which moving records to registers and back costs less than registers save, counted in instructions.
int first_degree(const Case& of) {
  if (of.scalar == "double") return kClang ? 6 : 5;
  return of.family == "basis" ? 4 : kClang ? 3 : 2;
}

constexpr double kCall = 60;  // for the call itself

TEST_F(InstructionCounts, OfPlainBatchesAreNoMoreThanThoseOfALoopOverTheHeader) {
  for (const auto& [of, count] : counts()) {
    if (of.records < 100 || of.degree < first_degree(of)) continue;
    EXPECT_LE(count.batch, count.loop + kCall) << of;
  }
}

// The header's kernel is contracted by the compiler, the driver's by its types: that may be some instructions more.
TEST_F(InstructionCounts, OfOneRecordAreThoseOfTheHeaderAndOfOneCall) {
  for (const auto& [of, count] : counts()) {
    if (of.records != 1) continue;
    EXPECT_LE(count.batch, count.loop + kCall) << of;
  }
}

}  // namespace
}  // namespace sh::test
