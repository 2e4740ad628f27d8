// Work that is larger than memory: large arrays in files of a folder (`--scratch`), where the process may have little memory.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)  // which maps more than any limit
constexpr bool kHasLimit = false;
#else
constexpr bool kHasLimit = true;
#endif
constexpr const char* kLimit = kHasLimit ? "ulimit -d 200000" : "";  // KiB; not those of mapped files
constexpr const char* kTooLittle = "this machine has too little memory for it";

class ScratchFolder : public testing::Test {
 protected:
  // Some 600,000 receivers: 60 MB of coefficients at degree 4.
  void SetUp() override {
    write_all(scene_, R"({"meshes": [{"primitive": "hills", "max_edge": 0.0025}]})");
    std::filesystem::create_directory(scratch_);
  }
  [[nodiscard]] Arguments bake(const std::string& output, const Arguments& more) const {
    return joined({"bake", scene_, "--plan", "none", "--degree", "4", "--threads", "1", "-o", output}, more);
  }
  // The command has too little memory, but not with the folder; then `made` is what the command makes with all memory.
  void expect_needs_it(const Arguments& command, const std::string& made, const std::string& with_memory) {
    if (kHasLimit) {
      const Finished failed = run_prt(command, kLimit);
      EXPECT_EQ(failed.status, kRetry) << failed.err;
      EXPECT_NE(failed.err.find(kTooLittle), std::string::npos) << failed.err;
    }
    EXPECT_FALSE(std::filesystem::exists(made));
    const Finished run = run_prt(joined(command, {"--scratch", scratch_}), kLimit);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(read_all(made) == read_all(with_memory));
    EXPECT_TRUE(std::filesystem::is_empty(scratch_));
  }
  TemporaryFolder folder_;
  const std::string scene_ = folder_.file("hills.json");
  const std::string scratch_ = folder_.file("scratch");
  const std::string whole_ = folder_.file("whole");
  const std::string out_ = folder_.file("out");
};

TEST_F(ScratchFolder, HoldsTheArraysOfABakeThatIsLargerThanMemory) {
  succeeded(bake(whole_, {"--kind", "unshadowed"}));
  expect_needs_it(bake(out_, {"--kind", "unshadowed"}), out_, whole_);
}

TEST_F(ScratchFolder, HoldsThoseOfAMergeAndOfRelighting) {
  const Arguments rays = {"--kind", "shadowed", "--directions", "4"};
  Arguments merge = {"merge"};
  for (const char* shard : {"1/2", "2/2"}) {
    merge.push_back(folder_.file(std::string("part ") + shard[0]));
    succeeded(bake(merge.back(), joined(rays, {"--shard", shard})));
  }
  succeeded(bake(whole_, rays));
  expect_needs_it(joined(merge, {"--threads", "1", "-o", out_}), out_, whole_);
  const std::string lit = folder_.file("lit.ply");
  const std::string relit = folder_.file("relit.ply");
  succeeded({"relight", whole_, "--light", "overcast", "-o", lit});
  expect_needs_it({"relight", whole_, "--light", "overcast", "--threads", "1", "-o", relit}, relit, lit);
}

TEST_F(ScratchFolder, SaysThatItsDiskIsFull) {
  const std::string limit = "ulimit -f 20000";  // blocks of 512 bytes: 10 MB
  expect_refused(bake(out_, {"--kind", "unshadowed", "--scratch", scratch_}), "--scratch " + scratch_ + ": no ", limit,
                 kRetry);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(ScratchFolder, IsAFolderThatCanBeWritten) {
  for (const std::string& wrong : {folder_.file("none"), scene_, std::string()}) {
    expect_refused(bake(out_, {"--scratch", wrong}), "expected a folder that can be written");
  }
}

TEST_F(ScratchFolder, IsGivenToTheCommandsOfAllShards) {
  const std::string told =
      succeeded({"shards", scene_, "--degree", "1", "--directions", "4", "--scratch", scratch_, "-n", "2", "-o", out_})
          .out;
  const std::string wanted = "--scratch " + scratch_;
  std::size_t count = 0;
  for (std::size_t at = told.find(wanted); at != std::string::npos; at = told.find(wanted, at + 1)) ++count;
  EXPECT_EQ(count, 3U) << told;
  succeeded(
      {"bake", scene_, "--degree", "1", "--directions", "4", "--scratch", scratch_, "--shard", "1/2", "-o", out_});
  EXPECT_EQ(read_all(out_).find("--scratch"), std::string::npos);  // the merge may run on another machine
}

}  // namespace
}  // namespace sh::prt::test
