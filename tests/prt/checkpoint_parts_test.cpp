// A checkpoint by itself, without rays: which results come back, which it does not believe, when it writes, and what its
// key depends on; parts of shards, and what is no complete set of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <utility>

#include "prt/bake/checkpoint.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

constexpr std::size_t kVertices = 2 * kVerticesPerChunk + 6;
constexpr std::size_t kCount = 4;  // coefficients of a vertex
constexpr double kNever = 1e9;     // seconds
const std::string kKey = R"({"degree":1})";

struct Results {
  Results() { transfer.coefficients.assign(kVertices * kCount, 0.0F); }
  Transfer transfer = Transfer::of(kShadowed, 1);
  FormFactors factors{kVertices};
  ShadowResult result{transfer, std::vector<Sight>(kVertices), &factors};
};

/// The row of a vertex; the fewest and the most that a row may hold are among them.
FormFactorRow row_of(std::size_t vertex) {
  const auto v = static_cast<std::uint32_t>(vertex);
  if (v % 5 == 1) return {};
  if (v % 5 == 2) return {{v, 0.5}, {kVertices - 1, 1.5}};
  if (v % 5 == 3) return {{0, -1e-6}};
  return {{v, 0.25}, {0, 1.0 / (3.0 + v)}, {kVertices - 1, 0.0}};
}

bool is_kept(std::size_t vertex) { return vertex % 5 != 0; }

/// Results of which no two vertices have the same, with the least and the largest sights.
void fill(Results& made) {
  for (std::size_t i = 0; i < made.transfer.coefficients.size(); ++i) {
    made.transfer.coefficients[i] = static_cast<float>(i) - 7.5F;
  }
  for (std::size_t v = 0; v < kVertices; ++v) {
    const float part = static_cast<float>(v) / kVertices;
    made.result.sight[v] = {2.0F - part, part, 1.0F - part};
    if (is_kept(v)) made.factors.keep(v, row_of(v));
  }
  made.result.sight[kVerticesPerChunk] = {2.0F, 1.0F, 1.0F};
  made.result.sight[kVerticesPerChunk + 1] = {0.0F, 0.0F, 0.0F};
}

void expect_same_row(const FormFactorRow& a, const FormFactorRow& b) {
  ASSERT_EQ(a.size(), b.size());
  if (a.empty()) return;  // null pointers
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(FormFactor)), 0);
}

void expect_vertex(const Results& found, const Results& made, std::size_t v) {
  EXPECT_TRUE(std::equal(made.transfer.row(v), made.transfer.row(v) + kCount, found.transfer.row(v))) << v;
  EXPECT_EQ(found.result.sight[v].visible, made.result.sight[v].visible) << v;
  EXPECT_EQ(found.result.sight[v].buried, made.result.sight[v].buried) << v;
  EXPECT_EQ(found.result.sight[v].covered, made.result.sight[v].covered) << v;
  EXPECT_EQ(found.factors.is_kept(v), made.factors.is_kept(v)) << v;
  expect_same_row(found.factors.row(v), made.factors.row(v));
}

class CheckpointParts : public testing::Test {
 protected:
  void SetUp() override { fill(made_); }

  [[nodiscard]] CheckpointSettings settings(double seconds = 0.0) const { return {path_, false, seconds}; }

  void write(const std::vector<std::size_t>& chunks) {
    Checkpoint checkpoint(settings(), kKey, made_.result);
    for (const std::size_t chunk : chunks) checkpoint.finished(chunk);
  }

  using Records = std::vector<std::pair<std::uint32_t, std::string>>;

  [[nodiscard]] Records records() const {
    Records all;
    CheckpointFile(path_, kKey, false).read([&](std::uint32_t index, std::string_view data) {
      all.emplace_back(index, data);
    });
    return all;
  }

  /// Reads a file of these records; returns what it says.
  [[nodiscard]] std::string read(Results& found, const Records& all) {
    std::filesystem::remove(path_);
    {
      CheckpointFile file(path_, kKey, false);
      for (const auto& [index, data] : all) file.append(index, data);
    }
    testing::internal::CaptureStderr();
    const Checkpoint checkpoint(settings(), kKey, found.result);
    for (std::size_t chunk = 0; chunk < chunk_count(kVertices); ++chunk) has_[chunk] = checkpoint.has(chunk);
    return testing::internal::GetCapturedStderr();
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.part");
  Results made_;
  std::array<bool, chunk_count(kVertices)> has_ = {};
};

TEST_F(CheckpointParts, GiveBackEveryResultOfTheirVerticesAndNoOther) {
  write({2, 1});
  Results found;
  EXPECT_EQ(read(found, records()), "prt: going on from " + path_ + ": 2 of 3 parts\n");
  EXPECT_EQ(has_, (std::array{false, true, true}));
  const Results none;
  for (std::size_t v = 0; v < kVertices; ++v)
    expect_vertex(found, v < kVerticesPerChunk ? none : std::as_const(made_), v);
  EXPECT_EQ(read(found, {}), "");
}

TEST_F(CheckpointParts, WithoutFormFactorsAreTheRestOfThem) {
  made_.result.factors = nullptr;
  write({0, 2});
  Results found;
  found.result.factors = nullptr;
  static_cast<void>(read(found, records()));
  EXPECT_EQ(has_, (std::array{true, false, true}));
  EXPECT_TRUE(std::equal(found.transfer.row(0), found.transfer.row(kVerticesPerChunk), made_.transfer.row(0)));
  Results with_factors;
  static_cast<void>(read(with_factors, records()));
  EXPECT_EQ(has_, (std::array{false, false, false})) << "their rows are missing";
}

TEST_F(CheckpointParts, GiveAProcessTheRowsOfItsOwnVertices) {
  static_assert(kVertices <= Ranks::kRowsAtOnce);  // all belong to rank 0
  write({0, 1, 2});
  const Records all = records();
  Results first;
  first.factors.share_among({0, 2});
  static_cast<void>(read(first, all));
  EXPECT_EQ(has_, (std::array{true, true, true}));
  for (std::size_t v = 0; v < kVertices; ++v) expect_vertex(first, made_, v);
  Results second;
  second.factors.share_among({1, 2});
  static_cast<void>(read(second, all));
  EXPECT_EQ(has_, (std::array{true, true, true}));
  for (std::size_t v = 0; v < kVertices; ++v) EXPECT_FALSE(second.factors.is_kept(v)) << v;
  EXPECT_EQ(second.transfer.coefficients, made_.transfer.coefficients);
  for (const std::size_t missing : {std::size_t{1}, sizeof(FormFactor)}) {  // bytes of the last row
    Records cut = all;
    for (auto& [index, data] : cut) data.resize(data.size() - missing);
    Results none;
    none.factors.share_among({1, 2});
    static_cast<void>(read(none, cut));
    EXPECT_EQ(has_, (std::array{false, false, false})) << missing;
  }
}

TEST_F(CheckpointParts, ThatNoRaysCanGiveAreNotBelieved) {
  write({1});
  const Records good = records();
  const std::size_t sights = kVerticesPerChunk * kCount * sizeof(float);
  const std::size_t head =
      sights + kVerticesPerChunk * sizeof(Sight);  // of the row of vertex 32, which has two entries
  const std::size_t entries = head + 8;
  const auto expect_dropped = [&](const std::string& data, const std::string& what) {
    Results found;
    EXPECT_EQ(read(found, {{1, data}}), "") << what;
    EXPECT_FALSE(has_[1]) << what;
    const Results none;
    for (std::size_t v = 0; v < kVertices; ++v) expect_vertex(found, none, v);
    EXPECT_NE(read(found, {{1, data}, good[0]}), "") << what << ": another record of the same chunk counts";
    EXPECT_TRUE(has_[1]) << what;
  };
  const auto expect_dropped_with = [&](std::size_t place, auto value) {
    std::string data = good[0].second;
    std::memcpy(&data.at(place), &value, sizeof value);
    expect_dropped(data, "byte " + std::to_string(place) + ": " + std::to_string(value));
  };
  expect_dropped(good[0].second + '\0', "too long");
  for (const std::size_t size : {std::size_t{0}, sights, head, entries, good[0].second.size() - 1}) {
    expect_dropped(good[0].second.substr(0, size), "cut to " + std::to_string(size));
  }
  for (const float bad : {-0.01F, 2.01F, std::numeric_limits<float>::quiet_NaN()}) {
    for (const std::size_t part : {0U, 4U, 8U}) expect_dropped_with(sights + part, bad);
    expect_dropped_with(head - sizeof(Sight), bad);  // of the last vertex
  }
  expect_dropped_with(sights + 4, 1.01F);
  expect_dropped_with(sights + 8, 1.01F);
  expect_dropped_with(head, std::uint32_t{2});
  for (const std::uint32_t length : {0U, 1U, 3U, ~0U}) expect_dropped_with(head + 4, length);
  for (const auto vertex : {static_cast<std::uint32_t>(kVertices), ~0U}) expect_dropped_with(entries, vertex);
  for (const double weight : {-1e-5, 0.6, std::numeric_limits<double>::quiet_NaN()}) {
    expect_dropped_with(entries + 4, weight);
  }
}

TEST_F(CheckpointParts, CountOnceAndOnlyWhereTheirChunkIs) {
  write({0});
  Records all = records();
  Results found;
  EXPECT_EQ(read(found, {all[0], all[0]}), "prt: going on from " + path_ + ": 1 of 3 parts\n");
  EXPECT_EQ(read(found, {{3, all[0].second}, {~0U, all[0].second}}), "");
  EXPECT_EQ(has_, (std::array{false, false, false}));
}

TEST_F(CheckpointParts, AreWrittenWhenItIsTimeOrTheBakeIsInterrupted) {
  {
    Checkpoint checkpoint(settings(kNever), kKey, made_.result);
    checkpoint.finished(0);
    EXPECT_FALSE(std::filesystem::exists(path_)) << "not yet";
    EXPECT_EQ(checkpoint.interrupted(),
              "interrupted; " + path_ + " holds 1 of 3 parts, and the same command goes on from there");
  }
  EXPECT_EQ(records().size(), 1U);
}

TEST_F(CheckpointParts, OfAShortBakeAreNotWrittenUnlessItWentOn) {
  {
    Checkpoint checkpoint(settings(kNever), kKey, made_.result);
    EXPECT_EQ(checkpoint.interrupted(), "interrupted; nothing was written");
    checkpoint.finished(0);
    checkpoint.complete();
    EXPECT_EQ(checkpoint.interrupted(), "interrupted; nothing was written") << "the results have changed since";
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  write({0});
  {
    Checkpoint checkpoint(settings(kNever), kKey, made_.result);
    checkpoint.finished(2);
    checkpoint.complete();
    EXPECT_EQ(checkpoint.interrupted(),
              "interrupted; " + path_ + " holds 2 of 3 parts, and the same command goes on from there");
  }
  EXPECT_EQ(records().size(), 2U);
  {
    Checkpoint checkpoint(settings(), kKey, made_.result);
    checkpoint.finished(1);
    EXPECT_EQ(checkpoint.interrupted(),
              "interrupted; " + path_ + " holds 3 of 3 parts, and the same command goes on from there");
  }
  EXPECT_EQ(records().size(), 3U);
}

TEST_F(CheckpointParts, WithoutAPathAreNowhere) {
  Checkpoint checkpoint({"", false, 0.0}, kKey, made_.result);
  checkpoint.finished(0);
  checkpoint.complete();
  EXPECT_EQ(checkpoint.interrupted(), "interrupted; nothing was written");
  EXPECT_EQ(folder_.entries(), 0U);
}

class CheckpointShards : public CheckpointParts {
 protected:
  [[nodiscard]] std::string part(std::uint32_t number) const { return folder_.file("part " + std::to_string(number)); }

  /// The file of shard `number` of `count`, with these chunks.
  std::string make(std::uint32_t number, std::uint32_t count, const std::vector<std::size_t>& chunks) {
    Checkpoint checkpoint(shard(number, count, kNever), kKey, made_.result);
    for (const std::size_t chunk : chunks) checkpoint.finished(chunk);
    checkpoint.complete();
    return part(number);
  }

  [[nodiscard]] CheckpointSettings shard(std::uint32_t number, std::uint32_t count, double seconds = 0.0) const {
    return {part(number), false, seconds, {number - 1, count}, kCommand};
  }

  /// Merges the files; what it refuses with, or nothing.
  std::string refusal(const std::vector<std::string>& files, Results& found, const std::string& key = kKey) {
    return message_of([&] {
      CheckpointSettings settings;
      settings.parts = files;
      const Checkpoint merged(settings, key, found.result);
      for (std::size_t chunk = 0; chunk < chunk_count(kVertices); ++chunk) EXPECT_TRUE(merged.has(chunk));
    });
  }
  std::string refusal(const std::vector<std::string>& files, const std::string& key = kKey) {
    Results found;
    return refusal(files, found, key);
  }

  static constexpr std::uint32_t kRecord = 0xFFFFFFFFU;
  const std::vector<std::string> kCommand = {"bake", "a b.json", "it's", "", "--degree", "1"};
  const std::string kRun = "run `prt bake 'a b.json' 'it'\\''s' '' --degree 1 --shard ";
};

TEST_F(CheckpointShards, WantTheirOwnChunksAndSayWhatTheyAre) {
  path_ = part(2);
  {
    Checkpoint checkpoint(shard(2, 3), kKey, made_.result);
    EXPECT_FALSE(checkpoint.wants(0));
    EXPECT_TRUE(checkpoint.wants(1));
    EXPECT_FALSE(checkpoint.wants(2));
  }
  ASSERT_EQ(records().size(), 1U) << "a shard names itself before its first chunk";
  make(2, 3, {1});
  const Records all = records();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].first, kRecord);
  EXPECT_EQ(all[0].second, R"({"shard":2,"shards":3,"command":["bake","a b.json","it's","","--degree","1"]})");
  EXPECT_EQ(all[1].first, 1U);
  const ShardRecord record = shard_of_part(path_);
  EXPECT_EQ(record.shard.index, 1U);
  EXPECT_EQ(record.shard.count, 3U);
  EXPECT_EQ(record.command, kCommand);
  const Checkpoint again(shard(2, 3), kKey, made_.result);
  EXPECT_TRUE(again.has(1));
  EXPECT_FALSE(again.wants(1));
}

TEST_F(CheckpointShards, LieInFilesOfTheirOwn) {
  make(2, 3, {1});
  const auto refused = [&](std::uint32_t number, std::uint32_t count) {
    CheckpointSettings other = shard(number, count);
    other.path = part(2);
    return message_of([&] { const Checkpoint checkpoint(other, kKey, made_.result); });
  };
  EXPECT_EQ(refused(1, 3), part(2) + ": holds shard 2/3; expected another output for shard 1/3, or --restart");
  EXPECT_EQ(refused(2, 4), part(2) + ": holds shard 2/3; expected another output for shard 2/4, or --restart");
  EXPECT_EQ(refused(2, 3), "");
}

TEST_F(CheckpointShards, MakeAWholeInAnyOrder) {
  Results found;
  EXPECT_EQ(refusal({make(2, 2, {1}), make(1, 2, {2, 0})}, found), "");
  for (std::size_t v = 0; v < kVertices; ++v) expect_vertex(found, made_, v);
  // More shards than chunks: the fourth has none, and need not be there.
  std::filesystem::remove(part(1));
  std::filesystem::remove(part(2));
  const std::vector<std::string> four = {make(1, 4, {0}), make(2, 4, {1}), make(3, 4, {2}), make(4, 4, {})};
  EXPECT_EQ(refusal(four), "");
  EXPECT_EQ(refusal({four[2], four[1], four[0]}), "");
}

TEST_F(CheckpointShards, ThatAreMissingAreNamedWithTheirCommand) {
  const std::string first = make(1, 3, {0});
  const std::string second = make(2, 3, {});  // stopped before its chunk
  const std::string third = make(3, 3, {2});
  const std::string expected = " expected complete parts of all shards: " + kRun;
  EXPECT_EQ(refusal({first}),
            "2 of 3 chunks of vertices are missing, those of the shards 2/3, 3/3;" + expected + "2/3 -o FILE`");
  EXPECT_EQ(refusal({first, third}),
            "1 of 3 chunks of vertices are missing, those of shard 2/3;" + expected + "2/3 -o FILE`");
  EXPECT_EQ(refusal({first, second, third}),
            "1 of 3 chunks of vertices are missing, those of shard 2/3;" + expected + "2/3 -o '" + second + "'`");
}

TEST_F(CheckpointShards, OfDifferentOrNoBakesAreRefused) {
  const std::string first = make(1, 2, {0, 2});
  const std::string copy = folder_.file("copy");
  std::filesystem::copy_file(first, copy);
  EXPECT_EQ(refusal({first, copy}), copy + ": shard 1 of 2, as " + first + " is; expected each once");
  EXPECT_EQ(refusal({make(3, 3, {2}), first}),
            first + ": shard 1 of 2, but " + part(3) + " is one of 3; expected the parts of one bake");
  EXPECT_EQ(refusal({first}, R"({"degree":2})"),
            first + ": part of another bake: its degree is 1, here it is 2; expected the parts of one bake");
  write({0});  // the checkpoint of a bake that is not shared
  const std::string none = ": no part of a bake; expected a part that `--shard` made";
  EXPECT_EQ(refusal({path_}), path_ + none);
  EXPECT_EQ(message_of([&] { static_cast<void>(shard_of_part(path_)); }), path_ + none);
}

TEST_F(CheckpointShards, BelieveNoRecordThatNamesNoShard) {
  const auto said = [&](const std::string& record) {
    std::filesystem::remove(path_);
    CheckpointFile(path_, kKey, false).append(kRecord, record);
    return message_of([&] { static_cast<void>(shard_of_part(path_)); });
  };
  for (const char* record :
       {R"({"shard": 0, "shards": 2, "command": []})", R"({"shard": 3, "shards": 2, "command": []})",
        R"({"shard": 1, "shards": 1, "command": []})", R"({"shard": 1, "shards": 65537, "command": []})",
        R"({"shard": 1, "shards": 2})", R"({"shard": "1", "shards": 2, "command": []})", R"([])", ""}) {
    EXPECT_EQ(said(record), path_ + ": damaged: the record of its shard cannot be read") << record;
  }
  EXPECT_EQ(said(R"({"shard": 65536, "shards": 65536, "command": []})"), "");
  EXPECT_EQ(said(R"({"shard": 1, "shards": 2, "command": []})"), "");
}

TEST(ShellLine, QuotesWhatAShellWouldSplitOrReplace) {
  EXPECT_EQ(shell_line({}), "");
  EXPECT_EQ(shell_line({"a/b_c.d,e:f=g+h@i%j-k", "0"}), "a/b_c.d,e:f=g+h@i%j-k 0");
  EXPECT_EQ(shell_line({"", "a b", "'", "$x", "*", "~"}), "'' 'a b' ''\\''' '$x' '*' '~'");
}

TEST(BakeKey, ChangesWithAllThatRaysDependOnAndWithNothingElse) {
  Scene scene = scene_of(primitive_mesh("box"), &kInterreflected);
  scene.mesh.mirror.assign(scene.mesh.positions.size(), {0.1F, 0.2F, 0.3F});
  std::vector<std::uint8_t> open(scene.mesh.positions.size(), 0);
  open[0] = 1;
  const std::string key = bake_key(scene, "avx2", open);
  using Change = std::function<void(Scene&, std::vector<std::uint8_t>&)>;
  const auto changed = [&](const Change& change) {
    Scene other = scene;
    std::vector<std::uint8_t> other_open = open;
    change(other, other_open);
    return bake_key(other, "avx2", other_open) != key;
  };
  const std::vector<Change> all = {
      [](Scene& s, auto&) { s.mesh.positions.back().z() += 1e-6F; },
      [](Scene& s, auto&) { s.mesh.normals.back() *= -1.0F; },
      [](Scene& s, auto&) { s.mesh.geometric_normals.back() *= -1.0F; },
      [](Scene& s, auto&) { s.mesh.mirror.back().z() = 0.4F; },
      [](Scene& s, auto&) { std::swap(s.mesh.faces.back()[1], s.mesh.faces.back()[2]); },
      [](Scene& s, auto&) { s.mesh.atlases.reach = {0.5F}; },
      [](Scene&, auto& o) { o.back() = 1; },
      [](Scene&, auto& o) { std::swap(o.front(), o.back()); },
      [](Scene& s, auto&) { s.bake.degree = 3; },
      [](Scene& s, auto&) { s.bake.directions = 1025; },
      [](Scene& s, auto&) { s.bake.bounces.directions = 1023; },
      [](Scene& s, auto&) { s.bake.sampler = Sampler::kSobol; },
      [](Scene& s, auto&) { s.bake.seed = 1; },
      [](Scene& s, auto&) { s.bake.kind = &kShadowed; },
  };
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(changed(all[i])) << i;
  EXPECT_NE(bake_key(scene, "sse4.2", open), key);
  EXPECT_NE(bake_key(scene, "avx2", open, "points"), key);
  EXPECT_FALSE(changed([](Scene& s, auto&) {
    paint(s.mesh, {0.9F, 0.1F, 0.1F});
    shine(s.mesh, {1.0F, 1.0F, 1.0F});
    s.mesh.specular.assign(s.mesh.positions.size(), {0.1F, 0.1F, 0.1F});
    s.mesh.exponent.assign(s.mesh.positions.size(), 7.0F);
    s.bake.bounces.tolerance = 0.1;
    s.bake.bounces.directions = 1024;
    s.name = "another";
  }));
}

}  // namespace
}  // namespace sh::prt::test
