// Bakes by several processes, each of a shard of the rays: their merged parts give the bytes of the single bake, whatever
// the kind, the count and the order; killed shards go on; what is no complete set of parts is refused with what to do.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

constexpr const char* kScene = R"({"meshes": [{"primitive": "stairs", "max_edge": 0.2},
    {"primitive": "torus", "segments": 12, "transform": {"translate": [0, 0, 0.9]}, TORUS}]})";

class Shards : public testing::Test {
 protected:
  void SetUp() override { scene(R"("albedo": [0.25, 0.5, 0.75])"); }
  void scene(const std::string& torus) {
    std::string text = kScene;
    write_all(file_, text.replace(text.find("TORUS"), 5, torus));
  }
  [[nodiscard]] Arguments bake(const Arguments& more, const std::string& output) const {
    return joined({"bake", file_, "--degree", "2", "--directions", directions_, "-o", output}, more);
  }
  std::string part(std::size_t index) { return folder_.file("part " + std::to_string(index)); }
  // Bakes every shard with the options; returns the files.
  Arguments parts(std::size_t count, const Arguments& options) {
    Arguments files;
    for (std::size_t i = 1; i <= count; ++i) {
      std::filesystem::remove(part(i));
      succeeded(bake(joined(options, {"--shard", std::to_string(i) + "/" + std::to_string(count)}), part(i)));
      files.push_back(part(i));
    }
    return files;
  }
  std::string merged(const Arguments& files, const Arguments& more = {}) {
    succeeded(joined(joined({"merge"}, files), joined({"-o", out_}, more)));
    return read_all(out_);
  }
  std::string single(const Arguments& options) {
    succeeded(bake(options, folder_.file("single")));
    return read_all(folder_.file("single"));
  }
  void expect_no_merge(const Arguments& files, const std::string& reason, int status = 2) {
    expect_refused(joined(joined({"merge"}, files), {"-o", out_}), reason, {}, status);
    EXPECT_FALSE(std::filesystem::exists(out_));
  }
  TemporaryFolder folder_;
  const std::string file_ = folder_.file("scene's.json");  // a name that a shell must quote
  const std::string out_ = folder_.file("merged");
  std::string directions_ = "128";
};

TEST_F(Shards, GiveTheBytesOfTheSingleBakeForEveryKindAndCount) {
  for (const char* kind : {"shadowed", "interreflected", "glossy_shadowed", "glossy_interreflected"}) {
    const Arguments options = {"--kind", kind};
    const std::string whole = single(options);
    for (const std::size_t count : {2U, 5U}) {
      Arguments files = parts(count, options);
      std::reverse(files.begin(), files.end());
      EXPECT_TRUE(merged(files) == whole) << kind << " " << count;
    }
  }
}

TEST_F(Shards, GiveThemWithMoreShardsThanChunks) {
  EXPECT_TRUE(merged(parts(40, {"--plan", "none"})) == single({"--plan", "none"}));
}

TEST_F(Shards, GiveThemForEveryOptionOfABake) {
  const Arguments cases[] = {{"--kind", "interreflected", "--bounce-memory", "0"},
                             {"--kind", "interreflected", "--bounce-directions", "16"},
                             {"--sampler", "random", "--seed", "7", "--strict"},
                             {"--plan", "lossy", "--error", "0.05", "--light-turns", "any"},
                             {"--plan", "exact", "--without", "analytic,channels"},
                             {"--compress", "8", "2"},
                             {"--kind", "glossy_shadowed", "--fit-lobes"},
                             {"--sampler", "cosine"}};
  for (const Arguments& options : cases) EXPECT_TRUE(merged(parts(3, options)) == single(options)) << options[1];
}

TEST_F(Shards, GiveThemByAPlanThatWasMadeOnce) {
  const Arguments decided = {"--kind", "interreflected", "--error", "0.1"};
  const std::string plan = folder_.file("plan.json");
  succeeded(joined({"plan", file_, "--degree", "2", "--directions", directions_, "-o", plan}, decided));
  const std::string whole = single(decided);
  Arguments files;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    files.push_back(folder_.file(std::string("by plan ") + shard[0]));
    succeeded({"bake", file_, "--plan", plan, "--shard", shard, "-o", files.back()});
  }
  EXPECT_TRUE(merged(files) == whole);
  const std::string told = succeeded({"shards", file_, "-n", "2", "--plan", plan, "-o", out_}).out;
  EXPECT_NE(told.find("prt bake '"), std::string::npos) << told;
  EXPECT_NE(told.find(" --plan " + plan + " --shard 1/2 -o "), std::string::npos) << told;
  std::filesystem::remove(out_);
  std::filesystem::remove(plan);
  expect_no_merge(files, "--plan " + plan + ": no such file");
}

TEST_F(Shards, GiveThemForMirrorsEmissionAndTexels) {
  scene(R"("mirror": [0.5, 0.5, 0.5])");
  EXPECT_TRUE(merged(parts(3, {"--kind", "interreflected"})) == single({"--kind", "interreflected"}));
  scene(R"("mirror": [0.5, 0.25, 0.7])");
  EXPECT_TRUE(merged(parts(3, {"--kind", "interreflected"})) == single({"--kind", "interreflected"}));
  scene(R"("emission": [1, 2, 3])");
  EXPECT_TRUE(merged(parts(3, {"--kind", "interreflected"})) == single({"--kind", "interreflected"}));
  scene(R"("texels": 16)");
  EXPECT_TRUE(merged(parts(3, {"--kind", "interreflected"})) == single({"--kind", "interreflected"}));
}

TEST_F(Shards, GiveThemForAnyNumberOfThreads) {
  Arguments files = parts(2, {"--kind", "interreflected", "--threads", "1"});
  EXPECT_TRUE(merged(files, {"--threads", "1"}) == single({"--kind", "interreflected"}));
}

TEST_F(Shards, GoOnAfterBeingKilled) {
  directions_ = "2048";
  const Arguments options = {"--kind", "interreflected", "--checkpoint-seconds", "0"};
  const std::string whole = single(options);
  Arguments files = {part(1), part(2)};
  succeeded(bake(joined(options, {"--shard", "2/2"}), part(2)));
  const Arguments first = bake(joined(options, {"--shard", "1/2"}), part(1));
  for (int kill = 0; kill < 3; ++kill) {
    std::uint64_t before = std::filesystem::exists(part(1)) ? std::filesystem::file_size(part(1)) : 0;
    signal_prt(first, SIGKILL, [&] {
      std::error_code error;
      return std::filesystem::file_size(part(1), error) > before && !error;
    });
  }
  succeeded(first);
  EXPECT_TRUE(merged(files) == whole);
  expect_refused(bake(joined(options, {"--shard", "1/3"}), part(1)), "holds shard 1/2; expected another output");
  const Finished again = succeeded(first);
  EXPECT_NE(again.err.find("traced 0 rays of shard 1/2"), std::string::npos) << again.err;
  EXPECT_TRUE(merged(files) == whole) << "a finished shard that runs again changes nothing";
}

TEST_F(Shards, OfWhichOneOfFourIsKilledAndRunsAgainGiveTheBytesOfTheSingleBake) {
  constexpr std::uintmax_t kBegun = 1500;  // bytes: the part has, or gets, its first chunk
  directions_ = "65536";
  for (const char* kind : {"shadowed", "interreflected", "glossy_shadowed"}) {
    const Arguments options = {"--kind", kind, "--checkpoint-seconds", "0"};
    const std::string whole = single(options);
    const Arguments files = parts(4, options);
    std::filesystem::remove(part(3));
    const Arguments third = bake(joined(options, {"--shard", "3/4"}), part(3));
    signal_prt(third, SIGKILL, [&] {
      std::error_code error;
      return std::filesystem::file_size(part(3), error) > kBegun && !error;
    });
    const Finished refused = run_prt(joined(joined({"merge"}, files), {"-o", out_}));
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("those of shard 3/4;"), std::string::npos) << kind << ": " << refused.err;
    EXPECT_FALSE(std::filesystem::exists(out_)) << kind;
    succeeded(third);
    EXPECT_TRUE(merged(files) == whole) << kind;
    std::filesystem::remove(out_);
  }
}

TEST_F(Shards, ThatAreMissingAreNamedWithTheCommandThatMakesThem) {
  const Arguments files = parts(3, {"--kind", "shadowed"});
  const std::string missing = "missing, those of shard 2/3; expected complete parts of all shards: run `prt bake '" +
                              folder_.file("scene'\\''s.json") +
                              "' --degree 2 --directions 128 --kind shadowed --shard 2/3 -o FILE`";
  expect_no_merge({files[0], files[2]}, missing);
  expect_no_merge({files[1]}, "those of the shards 1/3, 3/3;");
  // Cut off, or changed in a byte of its last record.
  std::filesystem::resize_file(files[1], std::filesystem::file_size(files[1]) - 5);
  expect_no_merge(files, "--shard 2/3 -o '" + files[1]);
  std::string bytes = read_all(files[0]);
  bytes[bytes.size() - 3] = static_cast<char>(bytes[bytes.size() - 3] + 1);
  write_all(files[0], bytes);
  expect_no_merge(files, "those of the shards 1/3, 2/3;");
}

TEST_F(Shards, OfDifferentBakesAreRefused) {
  const Arguments files = parts(2, {"--kind", "shadowed"});
  succeeded(bake({"--kind", "shadowed", "--shard", "1/3"}, folder_.file("third")));
  expect_no_merge({files[0], folder_.file("third")}, "shard 1 of 3, but");
  expect_no_merge({files[0], files[0]}, "shard 1 of 2, as");
  succeeded(bake({"--kind", "shadowed", "--seed", "3", "--shard", "2/2"}, folder_.file("seed")));
  expect_no_merge({files[0], folder_.file("seed")}, "part of another bake: its seed is 3, here it is 0;");
  scene(R"("segments": 14)");
  expect_no_merge(files, "part of another bake: its vertices is");
}

TEST_F(Shards, DoNotDependOnTheirLog) {
  const Arguments options = {"--kind", "shadowed"};
  const Arguments files = parts(2, options);
  std::filesystem::remove(files[1]);
  succeeded(bake(joined(options, {"--shard", "2/2", "--log", "json"}), files[1]));
  EXPECT_TRUE(merged(files, {"--log", "json"}) == single(options));
}

TEST_F(Shards, OfNoBakeAreRefused) {
  const Arguments files = parts(2, {"--kind", "shadowed"});
  write_all(folder_.file("text"), "no part at all");
  write_all(folder_.file("empty"), "");
  for (const std::string& name : {folder_.file("text"), folder_.file("empty"), folder_.file(""), file_}) {
    expect_no_merge({files[0], name}, "expected a part that `--shard` made");
    expect_no_merge({name, files[0]}, "expected a part that `--shard` made");
  }
  expect_no_merge({folder_.file("none")}, "cannot open: No such file or directory");
  signal_prt(bake({"--kind", "shadowed", "--directions", "4096", "--checkpoint-seconds", "0", "--checkpoint",
                   folder_.file("whole")},
                  folder_.file("x")),
             SIGKILL, [&] { return std::filesystem::exists(folder_.file("whole")); });
  if (std::filesystem::exists(folder_.file("whole"))) {
    expect_no_merge({folder_.file("whole")}, "expected a part that `--shard` made");
  }
}

TEST_F(Shards, InUseAreRefused) {
  const Arguments files = parts(2, {"--kind", "shadowed"});
  const int descriptor = open(files[0].c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
  expect_no_merge(files, "in use by another bake; wait for it", kRetry);
  expect_refused(bake({"--kind", "shadowed", "--shard", "1/2"}, files[0]), "in use by another bake", {}, kRetry);
  close(descriptor);
}

TEST_F(Shards, RefuseWhatCannotBeShared) {
  for (const char* shard : {"0/2", "3/2", "1/1", "1", "1/", "/2", "a/2", "1/2x", "-1/2", "1/65537", "1.5/2", ""}) {
    if (*shard == '\0') continue;
    expect_refused(bake({"--shard", shard}, out_), std::string("--shard ") + shard + ": expected I/N");
  }
  expect_refused(bake({"--kind", "unshadowed", "--shard", "1/2"}, out_), "traces no rays");
  scene(R"("mirror": [0.5, 0.25, 0.5])");
  expect_refused(bake({"--kind", "shadowed", "--shard", "1/2"}, out_), "its mirrors have colors");
  for (const Arguments& other : {Arguments{"--estimate"},
                                 {"--budget-seconds", "3"},
                                 {"--no-checkpoint"},
                                 {"--checkpoint", folder_.file("c")},
                                 {"--vectors", folder_.file("v")}}) {
    expect_refused(bake(joined({"--shard", "1/2"}, other), out_), "--shard");
  }
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(Shards, AreNeverOverwrittenByTheirMerge) {
  const Arguments files = parts(2, {"--kind", "shadowed"});
  const std::string before = read_all(files[0]);
  expect_refused(joined(joined({"merge"}, files), {"-o", files[0]}), files[0]);
  EXPECT_TRUE(read_all(files[0]) == before);
  std::filesystem::permissions(files[0], std::filesystem::perms::owner_read);
  EXPECT_TRUE(merged(files) == single({"--kind", "shadowed"})) << "parts may be read-only";
}

TEST_F(Shards, WithACommandOfTheirOwnMakingRunNothingElse) {
  const Arguments files = parts(2, {"--kind", "shadowed"});
  const std::string bytes = read_all(files[0]);
  ASSERT_NE(bytes.find("\"bake\""), std::string::npos);
  std::string changed = bytes;
  changed.replace(changed.find("\"bake\""), 6, "\"view\"");  // its record then fails its checksum
  write_all(files[0], changed);
  expect_no_merge(files, "expected a part that `--shard` made");
}

// What a shell makes of a text, run with the tool's folder in front of the path.
Finished run_shell(const std::string& text, const std::string& folder) {
  write_all(folder + "/job.sh", "export PATH=\"" SHFORGE_BIN_DIR ":$PATH\"\nset -e\n" + text);
  const int status = std::system(("bash '" + folder + "/job.sh' > '" + folder + "/job.out' 2>&1").c_str());
  return {status, read_all(folder + "/job.out"), ""};
}

TEST_F(Shards, AreTheCommandsThatAreTold) {
  const Arguments options = {"--kind", "interreflected", "--plan", "exact", "--without", "analytic,channels"};
  const std::string whole = single(options);
  const std::string named = folder_.file("the file's name");
  const auto told = [&](const char* system) {
    return succeeded(joined({"shards", file_, "--degree", "2", "--directions", "128", "-n", "3", "--for", system, "-o",
                             named},
                            options))
        .out;
  };
  const std::string commands = told("commands");
  EXPECT_EQ(std::count(commands.begin(), commands.end(), '\n'), 4);
  const Finished run = run_shell(commands, folder_.file("."));
  ASSERT_EQ(run.status, 0) << run.out;
  EXPECT_TRUE(read_all(named) == whole);
  // A job array: the script runs once for each number; the command that merges stands in its head.
  std::filesystem::remove(named);
  const std::string slurm = told("slurm");
  EXPECT_NE(slurm.find("#SBATCH --array=1-3\n"), std::string::npos) << slurm;
  for (const char* number : {"1", "2", "3"}) {
    const Finished shard =
        run_shell(std::string("export SLURM_ARRAY_TASK_ID=") + number + "\n" + slurm, folder_.file("."));
    EXPECT_EQ(shard.status, 0) << shard.out;
    EXPECT_NE(shard.out.find("of shard " + std::string(number) + "/3"), std::string::npos) << shard.out;
  }
  const std::size_t wrap = slurm.find("--wrap ") + 7;
  const Finished merge = run_shell("bash -c " + slurm.substr(wrap, slurm.find('\n', wrap) - wrap), folder_.file("."));
  ASSERT_EQ(merge.status, 0) << merge.out;
  EXPECT_TRUE(read_all(named) == whole);
  EXPECT_NE(told("parallel").find("::: $(seq 3) && prt merge"), std::string::npos);
  const std::string opencue = told("opencue");
  EXPECT_NE(opencue.find("range=\"1-3\""), std::string::npos);
  write_all(folder_.file("job.py"), opencue);
  const Finished python = run_shell("python3 -m py_compile '" + folder_.file("job.py") + "'", folder_.file("."));
  EXPECT_EQ(python.status, 0) << python.out;
  // A shard whose machine fails asks for another one, three times.
  for (const char* restarts : {"0", "2", "3"}) {
    const Finished failed = run_shell(
        std::string("set +e\nprt() { return 75; }\nscontrol() { echo \"$@\"; }\nexport SLURM_ARRAY_TASK_ID=2 ") +
            "SLURM_ARRAY_JOB_ID=17 SLURM_RESTART_COUNT=" + restarts + "\n" + slurm,
        folder_.file("."));
    EXPECT_NE(failed.status, 0);
    EXPECT_EQ(failed.out, *restarts == '3' ? "" : "requeue 17_2\n");
  }
  const Finished priced = succeeded(joined(
      {"shards", file_, "--degree", "2", "--directions", "4096", "-n", "3", "--price", "3600", "-o", named}, options));
  EXPECT_EQ(priced.out.find("--price"), std::string::npos);
  double hours = 0.0;
  double cost = 0.0;
  const std::size_t all = priced.err.find("all of them");
  ASSERT_NE(all, std::string::npos) << priced.err;
  ASSERT_EQ(std::sscanf(priced.err.c_str() + all, "all of them and the merge: %lg hours, %lg at", &hours, &cost), 2);
  EXPECT_GT(hours, 0.0);
  EXPECT_NEAR(cost, 3600.0 * hours, 0.01 * cost);
  expect_refused({"shards", file_, "-n", "2", "-o", named, "--price", "-1"}, "--price");
  expect_refused({"shards", file_, "-n", "1", "-o", named}, "--count: Value 1 not in range 2 to");
  expect_refused({"shards", file_, "-n", "2", "-o", named, "--kind", "unshadowed"}, "traces no rays");
}

}  // namespace
}  // namespace sh::prt::test
