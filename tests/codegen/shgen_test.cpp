// The tool from outside: the committed files, reproducibility, the differences that `check` finds, bad arguments.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "codegen/output/output_tree.hpp"
#include "tests/codegen/support.hpp"

namespace sh::codegen {
namespace {

namespace fs = std::filesystem;
using test::quoted;

const fs::path kCommitted = fs::path(SHFORGE_SOURCE_DIR) / "generated";

using test::shgen;

std::map<std::string, std::string> content_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).generic_string();
    if (entry.is_regular_file() && handwritten_files().count(name) == 0) files[name] = test::read_file(entry.path());
  }
  return files;
}

// A few files in place of all files of the generator, which take long.
const RenderedFiles kRendered{{"MANIFEST", "one line\n"},
                              {"cpp/basis_l3.hpp", "// degree 3\n// second line\n"},
                              {"cpp/basis_l4.hpp", "// degree 4\n"},
                              {"glsl/basis_l4.glsl", "// the same\n"}};

class WrittenTree : public testing::Test {
 protected:
  void SetUp() override { EXPECT_EQ(write_tree(folder(), kRendered).size(), kRendered.size()); }
  [[nodiscard]] const fs::path& folder() const { return temporary_.path(); }
  [[nodiscard]] std::vector<std::string> differences() const { return compare_tree(folder(), kRendered); }

 private:
  test::TemporaryFolder temporary_;
};

using Lines = std::vector<std::string>;

TEST_F(WrittenTree, HoldsWhatWasRenderedAndNoTemporaries) {
  EXPECT_EQ(content_of(folder()), kRendered);
  EXPECT_EQ(differences(), Lines{});
}

TEST_F(WrittenTree, ComparisonNamesAFileWithOneByteChangedAndTheLine) {
  for (const auto& [name, content] : kRendered) {
    std::string changed = content;
    changed[changed.size() - 2] = static_cast<char>(changed[changed.size() - 2] ^ 1);
    test::write_file(folder() / name, changed);
    const std::string line = name == "cpp/basis_l3.hpp" ? "2" : "1";
    EXPECT_EQ(differences(), Lines{name + ": differs from the output of the generator, first in line " + line});
    test::write_file(folder() / name, content);
  }
}

TEST_F(WrittenTree, ComparisonNamesMissingAndExtraFiles) {
  fs::remove(folder() / "cpp/basis_l3.hpp");
  test::write_file(folder() / "cpp/basis_l11.hpp", "stale");
  test::write_file(folder() / "README.md", "handwritten, never compared");
  EXPECT_EQ(differences(),
            (Lines{"cpp/basis_l3.hpp: missing", "cpp/basis_l11.hpp: extra, the generator does not write it"}));
}

TEST_F(WrittenTree, WritingAgainLeavesUnchangedFilesAlone) {
  const fs::path kept = folder() / "cpp/basis_l4.hpp";
  const auto before = fs::last_write_time(kept);
  test::write_file(folder() / "cpp/basis_l3.hpp", "old");
  EXPECT_EQ(write_tree(folder(), kRendered), Lines{"cpp/basis_l3.hpp"});
  EXPECT_EQ(fs::last_write_time(kept), before);
  EXPECT_EQ(content_of(folder()), kRendered);
}

// This is the only test that derives every kernel; it takes minutes. Each file of generated/ has to equal the
// output of the generator byte for byte, without extra files. The other tests of both commands need few kernels.
TEST(Shgen, CommittedFilesPassTheCheck) {
  const auto result = shgen("check");
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const auto files = std::to_string(content_of(kCommitted).size());
  EXPECT_NE(result.err.find("shgen: " + files + " files of "), std::string::npos) << result.err;
}

TEST(Shgen, RunsWithAddressRandomisation) {
  // Otherwise the test above would show nothing about hash order.
  const auto setting = test::run_command("cat /proc/sys/kernel/randomize_va_space");
  ASSERT_EQ(setting.exit_code, 0);
  EXPECT_NE(setting.out, "0\n");
}

TEST(Shgen, WritesTheFilesThatDifferAndNamesThem) {
  const test::TemporaryFolder folder;
  const auto first = shgen("write window_hann cap --out " + quoted(folder.path()));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const auto written = content_of(folder.path());
  EXPECT_EQ(static_cast<std::size_t>(std::count(first.out.begin(), first.out.end(), '\n')), written.size());
  EXPECT_GT(written.size(), 40U);
  for (const auto& [name, content] : written) EXPECT_EQ(content, test::read_file(kCommitted / name)) << name;
  test::write_file(folder.path() / "cpp/cap_l3.hpp", "old");
  EXPECT_EQ(shgen("write window_hann cap --out " + quoted(folder.path())).out, "cpp/cap_l3.hpp\n");
  EXPECT_EQ(content_of(folder.path()), written);
}

TEST(Shgen, CheckExitsWithOneAndALineForEachDifference) {
  const test::TemporaryFolder folder;
  fs::copy(kCommitted, folder.path(), fs::copy_options::recursive);
  const std::string check = "check cap --dir " + quoted(folder.path());
  EXPECT_EQ(shgen(check).exit_code, 0);
  fs::remove(folder.path() / "cpp/cap_l3.hpp");
  test::write_file(folder.path() / "glsl/cap_l10.glsl", "");
  const auto result = shgen(check);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out,
            "cpp/cap_l3.hpp: missing\n"
            "glsl/cap_l10.glsl: differs from the output of the generator, first in line 1\n");
}

TEST(Shgen, EmitPrintsTheCommittedFile) {
  EXPECT_EQ(shgen("emit basis --degree 4 --lang cpp").out, test::read_file(kCommitted / "cpp/basis_l4.hpp"));
  EXPECT_EQ(shgen("emit basis --degree 0 --lang glsl").out, test::read_file(kCommitted / "glsl/basis_l0.glsl"));
}

TEST(Shgen, ListPrintsTheManifestFromAnyFolder) {
  for (const std::string folder : {"/", SHFORGE_SOURCE_DIR}) {
    const auto list = test::run_command("cd " + quoted(folder) + " && " + quoted(SHFORGE_BIN_DIR "/shgen") + " list");
    EXPECT_EQ(list.out, test::read_file(kCommitted / "MANIFEST"));
  }
}

TEST(Shgen, DumpShowsEachStage) {
  for (const std::string stage : {"recipe", "share", "factor", "prune", "associate", "schedule"}) {
    const auto result = shgen("dump " + std::string(stage).append(" basis_l4"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out.find("basis_l4: "), 0U) << result.out;
  }
}

TEST(Shgen, BadArgumentsAreOneLineAndExitTwo) {
  const std::map<std::string, std::string> cases{
      {"", "expected one of: write, check, list, tune, emit, dump"},
      {"frobnicate", "frobnicate"},
      {"emit", "family"},
      {"emit basis --lang cpp", "--degree"},
      {"emit basis --degree -1 --lang cpp", "basis: expected degree 0 to 20, got -1"},
      {"emit basis --degree 21 --lang cpp", "basis: expected degree 0 to 20, got 21"},
      {"emit basis --degree four --lang cpp", "four"},
      {"emit basis --degree 99999999999 --lang cpp", "99999999999"},
      {"emit nothing --degree 1 --lang cpp", "unknown family 'nothing': expected one of: basis"},
      {"emit basis --degree 1 --lang cobol",
       "unknown language 'cobol': expected one of: cpp, glsl, glsl-es, hlsl, c99"},
      {"emit basis --degree 1 --lang c99 --scalar half", "unknown scalar 'half': expected one of: float, double"},
      {"emit basis --degree 1 --lang glsl-es --scalar double", "expected scalar float, got double"},
      {"emit basis --degree 1 --lang cpp --prefer luck", "expected one of: speed, accuracy, size"},
      {"emit product --degree 2 --degree-left 1 --lang cpp", "--degree-left requires --degree-right"},
      {"emit product --degree 4 --degree-left 1 --degree-right 2 --lang cpp",
       "product: expected degree 0 to 3 of the result, got 4"},
      {"emit product --degree 1 --degree-left 13 --degree-right 1 --lang cpp",
       "product: expected degree 0 to 12 of the left factor, got 13"},
      {"emit product --degree 1 --degree-left 1 --degree-right=-1 --lang cpp",
       "product: expected degree 0 to 12 of the right factor, got -1"},
      {"emit basis --degree 1 --degree-left 1 --degree-right 1 --lang cpp", "expected family product, got basis"},
      {"emit product_full --degree 9 --lang cpp", "expected degree 0 to 4, got 9"},
      {"dump nothing basis_l4", "expected one of: recipe, share, factor, fold, prune, associate, schedule"},
      {"dump share basis", "unknown kernel 'basis'"},
      {"dump share basis_l99", "got 99"},
      {"dump share basis_lx", "unknown kernel 'basis_lx'"},
      {"check --dir /nonexistent", "/nonexistent"},
      {"check nothing", "unknown family 'nothing': expected one of: basis"},
      {"write basis nothing --out /dev/null/here", "/dev/null/here"},
      {"write --out /dev/null/here", "/dev/null/here"},
      {"emit basis --degree 4 --lang cpp >/dev/full", "standard output"},
  };
  for (const auto& [arguments, part] : cases) {
    EXPECT_EQ(test::expect_refused(arguments, part).out, "") << arguments;
  }
}

}  // namespace
}  // namespace sh::codegen
