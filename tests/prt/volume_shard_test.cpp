// Volumes by several processes, each of a shard of the rays: their merged parts give the bytes of the single command.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

class VolumeShards : public testing::Test {
 protected:
  [[nodiscard]] Arguments volume(const Arguments& more, const std::string& output) const {
    return joined({"volume", scene_, "--counts", counts_, "--directions", directions_, "-o", output}, more);
  }
  std::string part(std::size_t index) { return folder_.file("part " + std::to_string(index)); }
  // Traces every shard; returns the files, the last one first.
  Arguments parts(std::size_t count, const Arguments& options) {
    Arguments files;
    for (std::size_t i = count; i >= 1; --i) {
      std::filesystem::remove(part(i));
      succeeded(volume(joined(options, {"--shard", std::to_string(i) + "/" + std::to_string(count)}), part(i)));
      files.push_back(part(i));
    }
    return files;
  }
  std::string merged(const Arguments& files) {
    succeeded(joined(joined({"merge"}, files), {"-o", out_}));
    return read_all(out_);
  }
  std::string single(const Arguments& options) {
    succeeded(volume(options, folder_.file("single")));
    return read_all(folder_.file("single"));
  }
  void expect_no_merge(const Arguments& files, const std::string& reason) {
    std::filesystem::remove(out_);
    expect_refused(joined(joined({"merge"}, files), {"-o", out_}), reason);
    EXPECT_FALSE(std::filesystem::exists(out_));
  }
  TemporaryFolder folder_;
  const std::string scenes_ = SHFORGE_SOURCE_DIR "/prt/scenes/";
  const std::string scene_ = scenes_ + "glider.json";
  const std::string out_ = folder_.file("merged");
  std::string counts_ = "7,6,5";
  std::string directions_ = "64";
};

TEST_F(VolumeShards, GiveTheBytesOfTheSingleVolumeForEveryOptionAndCount) {
  for (const Arguments& options : {Arguments{},
                                   {"--reflected"},
                                   {"--element", "byte", "--degree", "1", "--result-degree", "3"},
                                   {"--sampler", "random", "--seed", "7"},
                                   {"--box", "-9,-9,-9,9,9,9", "--strict", "--threads", "1"}}) {
    const std::string whole = single(options);
    for (const std::size_t count : {2U, 3U, 11U}) {  // the points are 7 chunks
      EXPECT_TRUE(merged(parts(count, options)) == whole) << testing::PrintToString(options) << " " << count;
    }
  }
}

// The surfaces, whose light the points get, are left to the merge.
TEST_F(VolumeShards, TraceTheRaysOfThePointsOnce) {
  std::uint64_t rays = 0;
  for (const char* shard : {"1/2", "2/2"}) {
    const std::string told = succeeded(volume({"--reflected", "--shard", shard}, part(1))).err;
    rays += std::stoull(told.substr(told.find("traced ") + 7));
    std::filesystem::remove(part(1));
  }
  EXPECT_EQ(rays, 7U * 6U * 5U * 64U);
}

TEST_F(VolumeShards, GoOnAfterBeingKilled) {
  counts_ = "24,24,12";
  directions_ = "1024";
  const std::string whole = single({});
  const Arguments first = volume({"--shard", "1/2", "--threads", "1", "--checkpoint-seconds", "0"}, part(1));
  const Finished stopped = signal_prt(
      first, SIGKILL, [&] { return std::filesystem::exists(part(1)) && std::filesystem::file_size(part(1)) > 60'000; });
  ASSERT_EQ(stopped.status, 128 + SIGKILL) << stopped.err;
  succeeded(volume({"--shard", "2/2"}, part(2)));
  expect_no_merge({part(1), part(2)}, "those of shard 1/2; expected complete parts of all shards: run `prt volume ");
  EXPECT_NE(succeeded(first).err.find("going on from"), std::string::npos);
  EXPECT_TRUE(merged({part(1), part(2)}) == whole);
  EXPECT_NE(succeeded(first).err.find("traced 0 rays of shard 1/2"), std::string::npos);
}

TEST_F(VolumeShards, OfOtherRaysAreRefused) {
  const Arguments files = parts(2, {});
  succeeded({"bake", scene_, "--degree", "2", "--directions", "64", "--shard", "1/2", "-o", folder_.file("bake")});
  expect_no_merge({files[0], folder_.file("bake")}, "part of another bake: ");
  expect_no_merge({folder_.file("bake"), files[0]}, "part of another bake: ");
  counts_ = "7,6,6";
  succeeded(volume({"--shard", "1/2"}, folder_.file("counts")));
  expect_no_merge({files[0], folder_.file("counts")}, "part of another bake: its points is \"7 x 6 x 6 points");
  counts_ = "7,6,5";
  succeeded(volume({"--shard", "1/2", "--box", "-9,-9,-9,9,9,9"}, folder_.file("box")));
  expect_no_merge({files[0], folder_.file("box")}, "part of another bake: its points is");
  expect_no_merge({files[0], files[0]}, "shard 2 of 2, as");
  const std::string before = read_all(files[0]);
  expect_refused(joined(joined({"merge"}, files), {"-o", files[0]}), files[0]);
  EXPECT_TRUE(read_all(files[0]) == before);
}

TEST_F(VolumeShards, RefuseWhatCannotBeShared) {
  expect_refused(volume({"--shard", "3/2"}, out_), "--shard 3/2: expected I/N");
  expect_refused(volume({"--shards", "1"}, out_), "--shards: Value 1 not in range 2 to");
  for (const Arguments& other :
       {Arguments{"--shard", "1/2"}, {"--checkpoint", folder_.file("c")}, {"--no-checkpoint"}}) {
    expect_refused(volume(joined({"--shards", "2"}, other), out_), "--shards");
  }
  for (const Arguments& option : {Arguments{"--shard", "1/2"}, {"--shards", "2"}, {"--parts", out_}}) {
    expect_refused(joined({"volume", scenes_ + "cloud.json", "-o", folder_.file("x")}, option),
                   option.front() + ": is for meshes");
  }
  expect_refused({"bake", scenes_ + "cloud.json", "-o", folder_.file("x"), "--parts", out_}, "--parts: is for meshes");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(VolumeShards, AreTheCommandsThatAreTold) {
  const Finished told =
      succeeded(volume({"--shards", "2", "--degree", "1", "--price", "3"}, folder_.file("the volume")));
  EXPECT_NE(told.err.find("2 shards of about "), std::string::npos) << told.err;
  EXPECT_NE(told.err.find("at 3 an hour"), std::string::npos) << told.err;
  write_all(folder_.file("job.sh"), "export PATH=\"" SHFORGE_BIN_DIR ":$PATH\"\nset -e\n" + told.out);
  ASSERT_EQ(std::system(("bash '" + folder_.file("job.sh") + "' 2> /dev/null").c_str()), 0) << told.out;
  EXPECT_TRUE(read_all(folder_.file("the volume")) == single({"--degree", "1"}));
  EXPECT_EQ(told.err.find("the merge also bakes"), std::string::npos);
  EXPECT_NE(succeeded(volume({"--shards", "2", "--reflected"}, out_)).err.find("the merge also bakes"),
            std::string::npos);
  const std::string slurm = succeeded(volume({"--shards", "2", "--for", "slurm"}, out_)).out;
  EXPECT_NE(slurm.find("prt volume " + scene_ + " --counts 7 6 5 --directions 64 --shard "), std::string::npos)
      << slurm;
}

}  // namespace
}  // namespace sh::prt::test
