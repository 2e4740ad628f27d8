// Several processes that solve the bounces of a bake together: the bits of one process, whatever their number; an error of
// any of them ends all with one line.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <barrier>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "prt/bake/bounces.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

// Threads in place of processes.
class Threads {
 public:
  explicit Threads(std::size_t count) : count_(count), meeting_(static_cast<std::ptrdiff_t>(count)) {}
  template <class Run>
  void run(const Run& run) {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < count_; ++i) {
      threads.emplace_back([&, i] { run(ranks(i)); });
    }
    for (std::thread& thread : threads) thread.join();
  }

 private:
  [[nodiscard]] Ranks ranks(std::size_t index) {
    return {index, count_, [this, index](double* values, std::size_t size, std::size_t root) {
              if (index == root) told_ = values;
              meeting_.arrive_and_wait();
              if (index != root) std::copy_n(told_, size, values);
              meeting_.arrive_and_wait();
            }};
  }
  std::size_t count_;
  std::barrier<> meeting_;
  const double* told_ = nullptr;
};

// Rows that differ in length and weight, with the sum `sum`.
FormFactorRow row_of(std::size_t vertex, std::size_t vertices, double sum) {
  FormFactorRow row;
  const std::size_t count = 1 + vertex % 7;
  for (std::size_t i = 0; i < count; ++i) {
    row.push_back(
        {static_cast<std::uint32_t>((31 * vertex + 17 * i * i + 1) % vertices), sum / static_cast<double>(count)});
  }
  return row;
}

struct Solved {
  BounceReport report;
  std::vector<double> values;
};

struct System {
  std::size_t vertices;
  float blue = 0.9F;      // albedo
  bool is_chain = false;  // each vertex sees its neighbors only, so that light travels slowly
};

FormFactorRow row_of_chain(std::size_t vertex, std::size_t vertices) {
  const auto before = static_cast<std::uint32_t>(vertex == 0 ? 1 : vertex - 1);
  const auto after = static_cast<std::uint32_t>(vertex + 1 == vertices ? vertex - 1 : vertex + 1);
  return {{before, 0.5}, {after, 0.5}};
}

Solved solve(const System& system, const BounceOptions& options, const Ranks& ranks,
             BounceCheckpoint* checkpoint = nullptr) {
  FormFactors factors(system.vertices);
  factors.share_among(ranks);
  for (std::size_t v = 0; v < system.vertices; ++v) {
    factors.keep(v, system.is_chain ? row_of_chain(v, system.vertices) : row_of(v, system.vertices, 0.75));
    EXPECT_EQ(factors.is_kept(v), ranks.owns(v));
  }
  const BounceLayout layout{4};
  Panel x(system.vertices, layout.columns());
  for (std::size_t v = 0; v < system.vertices; ++v) {
    for (std::size_t i = 0; i < x.columns; ++i) x.row(v)[i] = static_cast<double>((v * 13 + i * 7) % 11) - 3.0;
  }
  const std::vector<Eigen::Vector3f> albedo(system.vertices, {0.5F, 0.25F, system.blue});
  Solved solved;
  solved.report = solve_bounces(factors, albedo, layout, x, options, checkpoint);
  solved.values = x.values;
  return solved;
}

TEST(Ranks, OwnEveryVertexOnceAndShareThemEvenly) {
  for (const std::size_t count : {1U, 2U, 3U, 7U}) {
    std::vector<std::size_t> owned(count);
    for (std::size_t v = 0; v < 7 * 3 * 2 * Ranks::kRowsAtOnce; ++v) ++owned[Ranks{0, count, {}}.owner(v)];
    for (const std::size_t own : owned) EXPECT_EQ(own, owned[0]) << count;
  }
}

TEST(Ranks, KeepTheirOwnRowsOneAfterTheOther) {
  for (const std::size_t count : {1U, 2U, 3U, 7U}) {
    for (const std::size_t vertices : {0U, 1U, 255U, 256U, 257U, 511U, 512U, 1500U, 5000U}) {
      Panel whole(vertices, 8);
      for (std::size_t i = 0; i < whole.values.size(); ++i) whole.values[i] = static_cast<double>(i);
      std::vector<std::size_t> owned(count);
      Threads(count).run([&](const Ranks& ranks) {
        for (std::size_t v = 0; v < vertices; ++v) {
          if (!ranks.owns(v)) continue;
          EXPECT_EQ(ranks.place(v), owned[ranks.index]++) << v << " of " << count;
        }
        EXPECT_EQ(ranks.owned(vertices), owned[ranks.index]) << vertices << " of " << count;
        OwnRows own(ranks, whole);
        for (std::size_t v = 0; v < vertices; ++v) {
          if (ranks.owns(v)) own.row(v)[3] = -1.0;
        }
        Panel gathered(vertices, 8);
        own.gather(gathered);
        for (std::size_t i = 0; i < gathered.values.size(); ++i) {
          ASSERT_EQ(gathered.values[i], i % 8 == 3 ? -1.0 : static_cast<double>(i)) << i << " of " << count;
        }
      });
      EXPECT_EQ(std::accumulate(owned.begin(), owned.end(), std::size_t{0}), vertices);
    }
  }
}

TEST(Ranks, GiveTheBitsOfOneProcess) {
  for (const BounceSolver solver : {BounceSolver::kSeries, BounceSolver::kKrylov}) {
    for (const std::size_t vertices : {1U, 255U, 257U, 1500U}) {  // also fewer than the processes have rows for
      const Solved alone = solve({vertices}, {.solver = solver}, {});
      EXPECT_TRUE(alone.report.certified);
      for (const std::size_t count : {2U, 3U, 5U}) {
        std::vector<Solved> all(count);
        Threads(count).run(
            [&](const Ranks& ranks) { all[ranks.index] = solve({vertices}, {.solver = solver}, ranks); });
        for (const Solved& solved : all) {
          EXPECT_TRUE(solved.values == alone.values) << vertices << " of " << count;
          EXPECT_EQ(solved.report.bound, alone.report.bound);
          EXPECT_EQ(solved.report.applications, alone.report.applications);
        }
      }
    }
  }
}

void expect_same(const Solved& a, const Solved& b, const std::string& what) {
  EXPECT_TRUE(a.values == b.values) << what;
  EXPECT_EQ(a.report.applications, b.report.applications) << what;
  EXPECT_EQ(a.report.bound, b.report.bound) << what;
  EXPECT_EQ(a.report.solver, b.report.solver) << what;
}

class Stopped : public testing::TestWithParam<BounceSolver> {
 protected:
  // Stops after some applications, then goes on with other processes.
  Solved in_two_runs(int applications, std::size_t before, std::size_t after) {
    Solved solved;
    for (const bool is_last : {false, true}) {
      BounceOptions options = options_;
      if (!is_last) options.most_applications = applications;
      Threads(is_last ? after : before).run([&](const Ranks& ranks) {
        BounceCheckpoint checkpoint({.path = file_, .seconds = 0.0}, "{}", ranks);
        Solved own = solve(system_, options, ranks, &checkpoint);
        if (ranks.is_first()) solved = std::move(own);
      });
    }
    return solved;
  }

  // Two blocks of rows. The series sums quickly; of the others Krylov's cycles have an end, and the automatic solver leaves
  // the series.
  const System system_{5000, GetParam() == BounceSolver::kSeries ? 0.9F : 0.9995F, true};
  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.bounces");
  BounceOptions options_{.tolerance = 1e-6, .solver = GetParam()};
};

TEST_P(Stopped, SolversGoOnWithTheBitsOfOneThatIsNeverStopped) {
  const Solved whole = solve(system_, options_, {});
  EXPECT_TRUE(whole.report.certified);
  EXPECT_GT(whole.report.applications, 80);
  for (const int applications : {1, 2, 8, 9, 10, 60, 70, 80}) {
    expect_same(in_two_runs(applications, 1, 1), whole, std::to_string(applications));
    std::filesystem::remove(file_);
  }
  expect_same(in_two_runs(9, 2, 3), whole, "several processes, then others");
  EXPECT_TRUE(std::filesystem::exists(file_)) << "who uses the result removes it";
  EXPECT_FALSE(std::filesystem::exists(file_ + ".new"));
}

TEST_P(Stopped, SolversBeginAgainWithoutACompleteState) {
  const Solved whole = solve(system_, options_, {});
  static_cast<void>(in_two_runs(79, 1, 1));
  const std::string good = read_all(file_);
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, std::size_t{60}, good.size() / 2, good.size() - 1}) {
    write_all(file_, good.substr(0, size));
    const Ranks one;
    BounceCheckpoint checkpoint({.path = file_, .seconds = 1e6}, "{}", one);
    expect_same(solve(system_, options_, {}, &checkpoint), whole, std::to_string(size));
  }
  std::string changed = good;
  changed[good.size() / 3] ^= 1;
  write_all(file_, changed);
  const Ranks one;
  BounceCheckpoint checkpoint({.path = file_, .seconds = 1e6}, "{}", one);
  expect_same(solve(system_, options_, {}, &checkpoint), whole, "a changed byte");
}

INSTANTIATE_TEST_SUITE_P(Bounces, Stopped,
                         testing::Values(BounceSolver::kSeries, BounceSolver::kKrylov, BounceSolver::kAutomatic));

TEST(BounceCheckpoint, IsOfOneSystemAndDeletesNoFileOfTheUser) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.bounces");
  Panel x(3, 8);
  x.values.back() = 7.0;
  const Panel r(3, 8);
  const auto keep = [&](const BounceCheckpointSettings& settings, const std::string& key) {
    const Ranks one;
    BounceCheckpoint(settings, key, one).keep({.applications = 5}, OwnRows(one, x), r);
  };
  const auto loaded = [&](const BounceCheckpointSettings& settings, const std::string& key) {
    const Ranks one;
    OwnRows kept_x(one, 3, 8);
    Panel kept_r(3, 8);
    const auto state = BounceCheckpoint(settings, key, one).load(kept_x, kept_r);
    EXPECT_EQ(kept_x.row(2)[7], state ? 7.0 : 0.0);
    return state ? static_cast<int>(state->applications) : -1;
  };
  keep({.path = file, .seconds = 0.0}, R"({"tolerance":1})");
  EXPECT_EQ(loaded({.path = file}, R"({"tolerance":1})"), 5);
  EXPECT_EQ(loaded({.path = file}, R"({"tolerance":1})"), 5);
  EXPECT_EQ(loaded({.path = file}, R"({"tolerance":2})"), -1);
  EXPECT_EQ(loaded({.path = file}, R"({"tolerance":1})"), -1) << "the other one has deleted it";
  keep({.path = file, .seconds = 0.0}, "{}");
  EXPECT_EQ(loaded({.path = file, .restart = true}, "{}"), -1);
  write_all(file, "notes");
  EXPECT_NE(message_of([&] { loaded({.path = file}, "{}"); }), "");
  EXPECT_EQ(read_all(file), "notes");
  EXPECT_EQ(loaded({}, "{}"), -1);
  keep({.path = folder.file("late"), .seconds = 1e6}, "{}");
  EXPECT_FALSE(std::filesystem::exists(folder.file("late"))) << "it is not time";
}

// Also as root, and with more processes than cores; the number of processes follows.
const std::string kMpirun =
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --quiet --oversubscribe --mca btl self,vader "
    "-np ";

class MpiMerge : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system((kMpirun + "2 true >/dev/null 2>&1").c_str()) != 0) {
      GTEST_SKIP() << "mpirun is not installed, or may start no processes here";
    }
#ifndef SHFORGE_MPI
    GTEST_SKIP() << "built without MPI";
#endif
  }
  // Stairs under a torus, open to the sky, of this albedo, in two parts; more than four blocks of vertices.
  void trace(const std::string& kind, const std::string& albedo, const Arguments& more = {}) {
    write_all(scene_, R"({"meshes": [{"primitive": "stairs", "max_edge": 0.12, "albedo": )" + albedo +
                          R"(}, {"primitive": "torus", "segments": 16, "transform": {"translate": [0, 0, 0.9]}}]})");
    for (const char* shard : {"1/2", "2/2"}) {
      std::filesystem::remove(part(shard[0]));
      succeeded(joined(bake(kind, part(shard[0])), joined({"--shard", shard}, more)));
    }
  }
  [[nodiscard]] Arguments bake(const std::string& kind, const std::string& output) const {
    return {"bake", scene_, "--degree", "2", "--directions", "128", "--kind", kind, "-o", output};
  }
  [[nodiscard]] std::string part(char number) const { return folder_.file(std::string("part") + number); }
  // Runs `prt merge` of the parts as so many processes; standard error goes to err_. Returns the exit code.
  [[nodiscard]] int merge(int processes, const std::string& parts = {}) const {
    const std::string line = kMpirun + std::to_string(processes) + " " SHFORGE_BIN_DIR "/prt merge " +
                             (parts.empty() ? part('1') + " " + part('2') : parts) + " -o " + out_ + " 2>" + err_;
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  // Lines of the tool itself; mpirun says more.
  [[nodiscard]] std::vector<std::string> errors() const {
    std::vector<std::string> found;
    std::istringstream lines(read_all(err_));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("prt: ")) found.push_back(line);
    }
    return found;
  }
  TemporaryFolder folder_;
  const std::string scene_ = folder_.file("scene.json");
  const std::string out_ = folder_.file("merged");
  const std::string err_ = folder_.file("err");
};

TEST_F(MpiMerge, GivesTheBytesOfTheSingleBake) {
  for (const char* kind : {"interreflected", "shadowed", "glossy_interreflected"}) {
    trace(kind, "[0.5, 0.7, 0.99]");
    succeeded(bake(kind, folder_.file("single")));
    for (const int processes : {1, 2, 3}) {
      EXPECT_EQ(merge(processes), 0) << read_all(err_);
      EXPECT_TRUE(read_all(out_) == read_all(folder_.file("single"))) << kind << " " << processes;
      std::filesystem::remove(out_);
    }
  }
}

TEST_F(MpiMerge, TracesRowsAgainThatItsMemoryCannotHold) {
  trace("interreflected", "[0.5, 0.5, 0.5]", {"--bounce-memory", "0"});
  succeeded(joined(bake("interreflected", folder_.file("single")), {"--bounce-memory", "0"}));
  EXPECT_EQ(merge(3), 0) << read_all(err_);
  EXPECT_TRUE(read_all(out_) == read_all(folder_.file("single")));
}

TEST_F(MpiMerge, SolvesEveryChannelOfColoredMirrors) {
  trace("interreflected", R"([0.5, 0.5, 0.5], "mirror": [0.2, 0.3, 0.4])");
  succeeded(bake("interreflected", folder_.file("single")));
  EXPECT_EQ(merge(3), 0) << read_all(err_);
  EXPECT_TRUE(read_all(out_) == read_all(folder_.file("single")));
}

TEST_F(MpiMerge, SpeaksWithOneVoice) {
  trace("interreflected", R"([0.5, 0.5, 0.5], "flip": true)");  // with warnings: it is dark inside
  const auto lines = [&](int processes) {
    EXPECT_EQ(merge(processes), 0);
    const std::string said = read_all(err_);
    EXPECT_NE(said.find("warning: "), std::string::npos);
    return std::count(said.begin(), said.end(), '\n');
  };
  const auto alone = lines(1);
  EXPECT_GT(alone, 1);
  EXPECT_EQ(lines(3), alone) << read_all(err_);
}

TEST_F(MpiMerge, EndsWithOneLineIfAPartIsMissing) {
  trace("interreflected", "[0.5, 0.5, 0.5]");
  EXPECT_EQ(merge(3, part('1')), 2);
  EXPECT_EQ(errors().size(), 1U) << read_all(err_);
  EXPECT_NE(read_all(err_).find("missing, those of shard 2/2"), std::string::npos) << read_all(err_);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

// The processes of `prt` whose command line names the file.
std::vector<pid_t> processes_with(const std::string& file) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const pid_t number = std::atoi(entry.path().filename().c_str());
    std::error_code gone;
    const auto program = number > 0 ? std::filesystem::read_symlink(entry.path() / "exe", gone) : "";
    if (gone || program.filename() != "prt") continue;
    if (read_all((entry.path() / "cmdline").string()).find(file) != std::string::npos) found.push_back(number);
  }
  return found;
}

// mpirun ends the others, nothing is written, and the same command does it then.
TEST_F(MpiMerge, OfWhichOneProcessIsKilledLeavesNothingAndRunsAgain) {
  trace("interreflected", "[0.5, 0.5, 0.9999]");
  std::vector<pid_t> seen;
  std::thread killer([&] {
    for (int i = 0; i < 3000 && seen.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      seen = processes_with(part('1'));
    }
    if (!seen.empty()) kill(seen.back(), SIGKILL);
  });
  const int status = merge(3);
  killer.join();
  ASSERT_FALSE(seen.empty());
  EXPECT_NE(status, 0);
  EXPECT_FALSE(std::filesystem::exists(out_));
  EXPECT_TRUE(processes_with(part('1')).empty());
  EXPECT_EQ(merge(3), 0) << read_all(err_);
  EXPECT_TRUE(std::filesystem::exists(out_));
}

#ifndef SHFORGE_MPI
TEST(Ranks, OfABuildWithoutMpiAreRefused) {
  expect_refused({"merge", "a", "-o", "b"}, "merge: started by MPI, which this build does not have",
                 "export OMPI_COMM_WORLD_SIZE=2");
}
#endif

}  // namespace
}  // namespace sh::prt::test
