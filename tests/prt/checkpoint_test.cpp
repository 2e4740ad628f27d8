// Bakes that are stopped and continue give the same bytes as without a stop, with fewer rays. The tests kill real
// processes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "prt/bake/bake.hpp"
#include "prt/rays/gather.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/transfer/transfer_file.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"
#include "tests/prt/tool.hpp"

namespace sh::prt::test {
namespace {

std::uint64_t size_of(const std::string& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error ? 0 : size;
}

// The number of rays in the tool's message `prt: N rays traced`.
std::uint64_t rays_of(const Finished& run) {
  const std::size_t end = run.err.find(" rays traced");
  const std::size_t start = run.err.rfind(' ', end - 1);
  return end == std::string::npos ? 0 : std::stoull(run.err.substr(start + 1, end - start - 1));
}

// A torus over stairs in a scene file, baked as a whole, with all that its checkpoint held.
class StoppedBake : public testing::TestWithParam<const char*> {
 protected:
  // GetParam(): the kind; after it perhaps a slash and more of the torus.
  void SetUp() override {
    const std::string param = GetParam();
    const std::size_t slash = std::min(param.find('/'), param.size());
    write_all(file_, R"({"meshes": [{"primitive": "stairs", "max_edge": 0.07},
                                    {"primitive": "torus", "segments": 36, "transform": {"translate": [0, 0, 0.9]})" +
                         param.substr(std::min(slash + 1, param.size())) +
                         R"(}], "bake": {"degree": 2, "directions": )" + (slash < param.size() ? "256" : "1024") +
                         R"(, "transfer": ")" + param.substr(0, slash) + "\"}}");
    scene_ = load_scene(file_, OnFlaw::kRefuse);
    scene_.plan.mode = PlanMode::kNone;
    whole_ = bake({scene_, with_checkpoint(1)}, &report_);
    ASSERT_GT(report_.rays, 100'000U);
    whole_part_ = read_all(part_);
    std::filesystem::remove(part_);
    write_transfer(out_, whole_);
    whole_bytes_ = read_all(out_);
    std::filesystem::remove(out_);
  }

  [[nodiscard]] BakeSettings with_checkpoint(int threads = 0) const {
    return {.threads = threads, .checkpoint = {part_, false, 0.0}};
  }

  [[nodiscard]] std::vector<std::string> arguments(const std::string& threads) const {
    return {"bake", file_, "-o", out_, "--plan", "none", "--threads", threads, "--checkpoint-seconds", "0"};
  }

  // Bakes until the checkpoint has this length, then ends the process; tries again if the bake was faster.
  [[nodiscard]] Finished stop_at(std::uint64_t bytes, const std::string& threads, int signal) const {
    Finished run;
    for (int attempt = 0; attempt < 50; ++attempt) {
      run = signal_prt(arguments(threads), signal, [&] { return size_of(part_) >= bytes; });
      if (run.status != 0) break;
      std::filesystem::remove(out_);
    }
    return run;
  }

  // Goes on to the end with the same command; returns the part of the rays of the whole that were still traced.
  [[nodiscard]] double go_on(const std::string& threads) const {
    const Finished run = run_prt(arguments(threads));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(read_all(out_) == whole_bytes_);
    EXPECT_FALSE(std::filesystem::exists(part_));
    std::filesystem::remove(out_);
    return static_cast<double>(rays_of(run)) / static_cast<double>(report_.rays);
  }

  // The same in this process, from a checkpoint of these bytes.
  [[nodiscard]] double go_on_from(const std::string& part) const {
    write_all(part_, part);
    BakeReport report;
    const Transfer transfer = bake({scene_, with_checkpoint()}, &report);
    EXPECT_TRUE(transfer.coefficients == whole_.coefficients);
    EXPECT_EQ(size_of(part_), whole_part_.size()) << "what was dropped is there again";
    return static_cast<double>(report.rays) / static_cast<double>(report_.rays);
  }

  // One line with `what`, exit 2 or another, and an unchanged checkpoint.
  void expect_refused(std::vector<std::string> changed, const std::string& what, int status = 2) const {
    const std::string before = read_all(part_);
    std::vector<std::string> all = arguments("1");
    all.insert(all.end(), changed.begin(), changed.end());
    const Finished run = run_prt(all);
    EXPECT_EQ(run.status, status);
    EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
    const bool is_slow = run.err.starts_with("prt: about ");  // then the estimate stands before the refusal
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), is_slow ? 2 : 1) << run.err;
    EXPECT_TRUE(read_all(part_) == before);
    EXPECT_FALSE(std::filesystem::exists(out_));
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("scene.json");
  std::string out_ = folder_.file("out.transfer");
  std::string part_ = out_ + ".part";
  Scene scene_;
  Transfer whole_;
  BakeReport report_;
  std::string whole_part_;
  std::string whole_bytes_;
};

// A record of a checkpoint: the index of its chunk, and the places of its head and its data.
struct Record {
  std::uint32_t index;
  std::size_t head;
  std::size_t data;
  std::uint64_t size;

  [[nodiscard]] std::size_t end() const { return data + size; }
};

constexpr std::size_t kRecordHead = 32;

// Where the first record lies: after the prologue and the key.
std::size_t front_of(const std::string& part) {
  std::uint32_t key = 0;
  std::memcpy(&key, &part.at(12), sizeof key);
  return 24 + key;
}

// The complete records, in the order of the file.
std::vector<Record> records_of(const std::string& part) {
  std::vector<Record> records;
  for (std::size_t head = front_of(part); head + kRecordHead <= part.size();) {
    Record record{0, head, head + kRecordHead, 0};
    std::memcpy(&record.index, &part[head], sizeof record.index);
    std::memcpy(&record.size, &part[head + 8], sizeof record.size);
    if (record.end() > part.size()) break;
    records.push_back(record);
    head = record.end();
  }
  return records;
}

// The checkpoint `whole` without the chunks that `part` holds.
std::string rest_of(const std::string& whole, const std::string& part) {
  std::set<std::uint32_t> held;
  for (const Record& record : records_of(part)) held.insert(record.index);
  std::string rest = whole.substr(0, front_of(whole));
  for (const Record& record : records_of(whole)) {
    if (!held.contains(record.index)) rest.append(whole, record.head, record.end() - record.head);
  }
  return rest;
}

// Going on traces exactly the rays that the checkpoint lacks: it and its rest make up the whole.
class AnyStoppedBake : public StoppedBake {
 protected:
  void expect_no_ray_twice(const std::string& threads) const {
    const std::string held = read_all(part_);
    const double traced = go_on(threads);
    EXPECT_LT(traced, 1.0);
    EXPECT_NEAR(traced + go_on_from(rest_of(whole_part_, held)), 1.0, 1e-12);
    std::filesystem::remove(part_);
  }
};
class StoppedShadowedBake : public StoppedBake {};

TEST_P(AnyStoppedBake, GoesOnAfterAKillAtAnyProgressWithTheSameBytesAndFewerRays) {
  const int step = std::string(GetParam()) == "shadowed" ? 10 : 45;
  for (int percent = 5; percent <= 95; percent += step) {
    const bool odd = percent / step % 2 == 1;
    const Finished killed =
        stop_at(whole_part_.size() * static_cast<std::size_t>(percent) / 100, odd ? "2" : "1", SIGKILL);
    ASSERT_EQ(killed.status, 128 + SIGKILL) << killed.err;
    ASSERT_FALSE(std::filesystem::exists(out_));
    SCOPED_TRACE(percent);
    expect_no_ray_twice(odd ? "1" : "2");
  }
}

TEST_P(AnyStoppedBake, GoesOnAfterControlCAndSaysSo) {
  const Finished stopped = stop_at(whole_part_.size() / 2, "1", SIGINT);
  EXPECT_EQ(stopped.status, 130) << stopped.err;
  EXPECT_NE(stopped.err.find(".part holds "), std::string::npos) << stopped.err;
  EXPECT_NE(stopped.err.find("the same command goes on from there"), std::string::npos) << stopped.err;
  expect_no_ray_twice("2");
}

TEST_P(AnyStoppedBake, TracesATornOrChangedPartAgain) {
  EXPECT_EQ(go_on_from(whole_part_), 0.0);
  for (const std::size_t cut : {1U, 33U, 1000U}) {
    const double traced = go_on_from(whole_part_.substr(0, whole_part_.size() - cut));
    EXPECT_GT(traced, 0.0) << cut;
    EXPECT_LT(traced, 0.1) << cut;
  }
  for (const double place : {0.1, 0.35, 0.7, 0.99}) {
    std::string changed = whole_part_;
    changed[static_cast<std::size_t>(place * static_cast<double>(changed.size()))] ^= 0x10;
    write_all(part_, changed);
    BakeReport report;
    EXPECT_TRUE(bake({scene_, with_checkpoint()}, &report).coefficients == whole_.coefficients) << place;
    EXPECT_GT(report.rays, 0U) << place;
    EXPECT_LT(report.rays, report_.rays) << place;
  }
}

void mend(std::string& part, const Record& record) {
  const std::uint64_t data = checksum(&part.at(record.data), record.size);
  std::memcpy(&part.at(record.head + 16), &data, sizeof data);
  const std::uint64_t head = checksum(&part.at(record.head), 24);
  std::memcpy(&part.at(record.head + 24), &head, sizeof head);
}

TEST_P(AnyStoppedBake, BelievesNoNumberThatRaysCannotGiveWhateverItsChecksum) {
  const Record record = records_of(whole_part_).at(1);
  const TransferKind& kind = *scene_.bake.kind;
  const std::size_t vectors = 32 * kind.traced_shape(2).columns() * sizeof(float);
  const auto expect_traced_again = [&](std::size_t place, auto value) {
    std::string changed = whole_part_;
    std::memcpy(&changed.at(record.data + place), &value, sizeof value);
    mend(changed, record);
    write_all(part_, changed);
    BakeReport report;
    EXPECT_TRUE(bake({scene_, with_checkpoint()}, &report).coefficients == whole_.coefficients)
        << place << ' ' << value;
    EXPECT_GT(report.rays, 0U) << place << ' ' << value;
    EXPECT_LT(report.rays, report_.rays / 5) << place << ' ' << value;
  };
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (const std::size_t place : {std::size_t{0}, vectors - 4}) expect_traced_again(place, bad);
  }
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -0.1F, 9.0F}) {
    for (const std::size_t part : {0U, 4U, 8U})
      expect_traced_again(vectors + part, bad);  // of the first vertex's sight
  }
  if (!kind.has_bounces()) return;
  const std::size_t weight = vectors + 32 * sizeof(Sight) + 8 + 4;  // of the first form factor of the first vertex
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -0.5, 7.0, 1e300})
    expect_traced_again(weight, bad);
}

TEST_P(AnyStoppedBake, HoldsEverythingAgainWhereItStartsAgain) {
  write_all(part_, whole_part_);
  BakeSettings again = with_checkpoint();
  again.checkpoint.restart = true;
  BakeReport report;
  EXPECT_TRUE(bake({scene_, again}, &report).coefficients == whole_.coefficients);
  EXPECT_EQ(report.rays, report_.rays);
  EXPECT_EQ(size_of(part_), whole_part_.size());
  EXPECT_TRUE(bake({scene_, {}}).coefficients == whole_.coefficients) << "without any checkpoint";
}

// The index of the second record in the first record, whose data are unchanged.
TEST_P(AnyStoppedBake, BelievesNoRecordThatNamesAnotherChunk) {
  const std::vector<Record> records = records_of(whole_part_);
  std::string changed = whole_part_;
  changed.replace(records.at(0).head, 4, whole_part_, records.at(1).head, 4);
  ASSERT_NE(changed, whole_part_);
  write_all(part_, changed);
  EXPECT_TRUE(bake({scene_, with_checkpoint()}).coefficients == whole_.coefficients);
}

INSTANTIATE_TEST_SUITE_P(OfKind, AnyStoppedBake,
                         testing::Values("shadowed", "interreflected", "glossy_shadowed",
                                         R"(interreflected/, "mirror": [0.3, 0.5, 0.7])"));

TEST_P(StoppedShadowedBake, GoesOnAfterControlCAmongItsClustersAndSaysSo) {
  std::vector<std::string> clustered = arguments("1");
  clustered.insert(clustered.end(), {"--compress", "4096", "8"});
  const Finished stopped = signal_prt(clustered, SIGINT, [&] { return size_of(part_) >= whole_part_.size(); });
  EXPECT_EQ(stopped.status, 130) << stopped.err;
  const std::string all = std::to_string(records_of(whole_part_).size());
  EXPECT_NE(stopped.err.find(" holds " + all + " of " + all + " parts, and the same command goes on from there"),
            std::string::npos)
      << stopped.err;
  EXPECT_EQ(go_on("2"), 0.0);
}

TEST_P(StoppedShadowedBake, StartsAfreshWhereTheCheckpointWasNotYetMade) {
  for (const std::size_t size : {0U, 7U, 24U, 100U}) {
    EXPECT_EQ(go_on_from(whole_part_.substr(0, size)), 1.0) << size;
  }
}

TEST_P(StoppedShadowedBake, KeepsTheCheckpointOfAnotherBakeAndSaysWhatDiffers) {
  write_all(part_, whole_part_);
  expect_refused({"--degree", "3"}, "out.transfer.part: checkpoint of another bake: its degree is 2, here it is 3");
  expect_refused({"--directions", "512"}, "its directions is 1024, here it is 512");
  expect_refused({"--kind", "interreflected"}, R"(its transfer is "shadowed", here it is "interreflected")");
  expect_refused({"--sampler", "sobol"}, R"(its sampler is "fibonacci", here it is "sobol")");
  expect_refused({"--seed", "9"}, "its seed is 0, here it is 9");
  expect_refused({"--instruction-set", "sse4.2"}, "its instruction_set is ");
  write_all(file_, R"({"meshes": [{"primitive": "stairs"}], "bake": {"degree": 2, "directions": 1024}})");
  expect_refused({}, "its vertices is ");

  const Finished run = run_prt({"bake", file_, "-o", out_, "--restart"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_FALSE(std::filesystem::exists(part_)) << "thrown away on demand";
}

TEST_P(StoppedShadowedBake, RefusesWhatIsNoCheckpointEvenOnRestart) {
  for (const std::string& text : {std::string("notes"), std::string(5000, 'x')}) {
    write_all(part_, text);
    expect_refused({}, "out.transfer.part: no checkpoint of a bake");
    expect_refused({"--restart"}, "no checkpoint of a bake");
  }
  std::string damaged = whole_part_;
  damaged[60] ^= 1;  // in the key
  write_all(part_, damaged);
  expect_refused({}, "damaged checkpoint");
  damaged = whole_part_;
  damaged[8] ^= 2;
  write_all(part_, damaged);
  expect_refused({}, "checkpoint of version 1, expected 3");
  damaged = whole_part_.substr(0, 12);
  const std::string deep(100'000, '[');
  const auto size = static_cast<std::uint32_t>(deep.size());
  damaged.append(reinterpret_cast<const char*>(&size), sizeof size);
  const std::string front = damaged + deep;
  const std::uint64_t sum = checksum(front.data(), front.size());
  damaged.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  write_all(part_, damaged + deep);
  expect_refused({}, "damaged checkpoint: its key is not JSON for this program");
  std::filesystem::remove(part_);
  expect_refused({"--checkpoint", folder_.file("none/x")}, "none/x: cannot write");
  expect_refused({"--checkpoint", folder_.file("")}, "is a folder");
  expect_refused({"--checkpoint", "/dev/null"}, "/dev/null: no checkpoint of a bake");
  expect_refused({"--checkpoint", "x", "--no-checkpoint"}, "--checkpoint");
}

TEST_P(StoppedShadowedBake, RefusesACheckpointThatAnotherProcessWrites) {
  write_all(part_, whole_part_);
  const int descriptor = open(part_.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
  expect_refused({}, "in use by another bake", kRetry);
  close(descriptor);
  EXPECT_EQ(go_on("1"), 0.0);
}

TEST_P(StoppedShadowedBake, GoesOnAfterAFullDisk) {
  const std::string limit = "ulimit -f " + std::to_string(whole_part_.size() / 2 / 512);
  const Finished full = run_prt(arguments("1"), limit);
  EXPECT_EQ(full.status, kRetry);
  EXPECT_NE(full.err.find("out.transfer.part: cannot write: "), std::string::npos) << full.err;
  EXPECT_FALSE(std::filesystem::exists(out_));
  EXPECT_LT(go_on("1"), 0.6);
}

TEST_P(StoppedShadowedBake, LeavesTheCheckpointOfAnotherBakeAloneWhereNoRayIsTraced) {
  write_all(part_, whole_part_);
  EXPECT_EQ(run_prt({"bake", file_, "-o", out_, "--kind", "unshadowed"}).status, 0);
  EXPECT_TRUE(read_all(part_) == whole_part_);
}

TEST_P(StoppedShadowedBake, LeavesNothingWithoutACheckpointNorWhereItIsShort) {
  for (const char* option : {"--no-checkpoint", "--strict"}) {
    EXPECT_EQ(run_prt({"bake", file_, "-o", out_, option}).status, 0);
    EXPECT_EQ(folder_.entries(), 2U);
  }
}

INSTANTIATE_TEST_SUITE_P(OfKind, StoppedShadowedBake, testing::Values("shadowed"));

TEST(InterreflectedBake, GoesOnTheSameWhereFormFactorsDoNotFit) {
  const TemporaryFolder folder;
  const Scene scene = scene_of(primitive_mesh("arch"), &kInterreflected, 256, 1);
  const Transfer whole = bake(scene);
  const BakeSettings settings{.bounce_memory = 1000, .checkpoint = {folder.file("part"), false, 0.0}};
  BakeReport first;
  EXPECT_TRUE(bake({scene, settings}, &first).coefficients == whole.coefficients);
  BakeReport second;
  EXPECT_TRUE(bake({scene, settings}, &second).coefficients == whole.coefficients);
  EXPECT_LT(second.rays, first.rays);
  EXPECT_GT(second.rays, 0U) << "for the bounces";
}

}  // namespace
}  // namespace sh::prt::test
