// The transfer file: round trips are exact; damaged files are refused in one line.
#include "prt/transfer/transfer_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "numeric/output/atomic_file.hpp"
#include "prt/transfer/storage.hpp"
#include "prt/transfer/transfer_layout.hpp"
#include "tests/prt/rooms.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

Transfer small_transfer() { return baked(primitive_mesh("plane"), &kShadowed, 2048, 1); }

Transfer stored_transfer(const Storage& storage) {
  Transfer transfer = Transfer::of(kInterreflected, 1);
  transfer.scene = "stored";
  transfer.mesh = primitive_mesh("plane");
  for (std::size_t i = 0; i < transfer.mesh.positions.size() * transfer.shape.length(); ++i) {
    transfer.coefficients.push_back(0.01F * static_cast<float>(i % 4) - 0.02F);
  }
  transfer.shape.storage = storage;
  transfer.plan = {0.01, 0.002, "any", {{"storage", "half", "it is enough", 12, 3, 0.002, "bound"}}};
  return transfer;
}

const std::vector<Storage> kStorages = {{Element::kSingle, false, {}}, {Element::kHalf, false, {}},
                                        {Element::kByte, false, {}},   {Element::kByte, true, {0, 2}},
                                        {Element::kSingle, true, {}},  {Element::kHalf, true, {0, 1, 3}}};

class TransferFile : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal() const {
    return message_of([&] { read_transfer(file_); });
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("a.prt");
};

TEST_F(TransferFile, GivesBackWhatWasWritten) {
  const Transfer written = small_transfer();
  write_transfer(file_, written);
  const Transfer read = read_transfer(file_);
  EXPECT_EQ(read.scene, written.scene);
  EXPECT_TRUE(is_alike(read.shape, written.shape));
  EXPECT_EQ(read.kind, written.kind);
  EXPECT_EQ(read.directions, written.directions);
  EXPECT_EQ(read.instruction_set, written.instruction_set);
  EXPECT_EQ(read.coefficients, written.coefficients);
  EXPECT_EQ(read.mesh.positions, written.mesh.positions);
  EXPECT_EQ(read.mesh.normals, written.mesh.normals);
  EXPECT_EQ(read.mesh.geometric_normals, written.mesh.geometric_normals);
  EXPECT_EQ(read.mesh.albedo, written.mesh.albedo);
  EXPECT_EQ(read.mesh.faces, written.mesh.faces);
  EXPECT_EQ(read.mesh.remap, written.mesh.remap);
  EXPECT_EQ(folder_.entries(), 1U);
}

TEST_F(TransferFile, KeepsLightOfItsOwnInASectionThatIsAbsentOtherwise) {
  Transfer written = small_transfer();
  write_transfer(file_, written);
  const std::string dark = read_all(file_);
  EXPECT_EQ(dark.find("emitted"), std::string::npos);
  EXPECT_TRUE(read_transfer(file_).emitted.empty());
  for (std::size_t v = 0; v < written.mesh.positions.size(); ++v) {
    written.emitted.emplace_back(static_cast<float>(v), 0.5F, 2.0F);
  }
  write_transfer(file_, written);
  EXPECT_EQ(read_transfer(file_).emitted, written.emitted);
  written.emitted.pop_back();
  EXPECT_NE(message_of([&] { write_transfer(file_, written); }), "");
}

TEST_F(TransferFile, KeepsLightOfItsOwnAndMirrorsWholeHoweverCoefficientsAreStored) {
  Transfer written = small_transfer();
  const std::size_t vertices = written.mesh.positions.size();
  written.emitted.assign(vertices, {0.1F, 3.3F, 7.0F});
  written.mesh.mirror.assign(vertices, {0.3F, 0.7F, 1.0F});
  for (const Element element : {Element::kSingle, Element::kHalf, Element::kByte}) {
    written.shape.storage.element = element;
    written.shape.storage.kept = {0, 2};
    write_transfer(file_, written);
    const Transfer read = read_transfer(file_);
    EXPECT_EQ(read.shape.storage.kept, written.shape.storage.kept);
    EXPECT_EQ(read.emitted, written.emitted);
    EXPECT_EQ(read.mesh.mirror, written.mesh.mirror);
  }
}

// The file with its prologue, section table and JSON header changed, and its checksums made good.
using Change = std::function<void(layout::Prologue&, std::vector<layout::Section>&, std::string&)>;
std::string changed(std::string bytes, const Change& change) {
  layout::Prologue prologue;
  std::memcpy(&prologue, bytes.data(), sizeof prologue);
  std::vector<layout::Section> table(prologue.sections);
  const std::size_t size = table.size() * sizeof(layout::Section);
  std::memcpy(table.data(), bytes.data() + sizeof prologue, size);
  std::string header = bytes.substr(sizeof prologue + size, prologue.header_size);
  const std::size_t before = header.size();
  change(prologue, table, header);
  prologue.header_size = header.size();
  prologue.header_checksum = checksum(header.data(), header.size());
  prologue.checksum = layout::front_checksum(prologue, table);
  std::memcpy(bytes.data(), &prologue, sizeof prologue);
  std::memcpy(bytes.data() + sizeof prologue, table.data(), size);
  return bytes.replace(sizeof prologue + size, before, header);
}

TEST_F(TransferFile, IsRefusedWithASectionThatIsUnknownMissingOrOutOfPlace) {
  write_transfer(file_, small_transfer());
  const std::string good = read_all(file_);
  const auto refusal_with = [&](const std::function<void(std::vector<layout::Section>&)>& change) {
    write_all(file_, changed(good, [&](auto&, auto& table, auto&) { change(table); }));
    return refusal();
  };
  EXPECT_EQ(refusal_with([](auto& table) { table[3].name = layout::padded("aroma\n"); }),
            file_ + ": transfer file with a section `aroma`, which is unknown or out of place");
  EXPECT_EQ(refusal_with([](auto& table) { std::swap(table[1], table[2]); }),
            file_ + ": damaged transfer file: section normal is missing");
  EXPECT_EQ(refusal_with([](auto& table) { table[6].name = layout::padded("emitted"); }),
            file_ + ": damaged transfer file: section transfer is missing");
  EXPECT_EQ(refusal_with([](auto& table) { table[3].type = layout::kIndex; }),
            file_ + ": damaged transfer file: section albedo does not fit");
}

// A sparse file of some 30 GiB.
TEST_F(TransferFile, TellsItsHeadWhereSectionsAreLargerThan4GiB) {
  const Transfer small = small_transfer();
  write_transfer(file_, small);
  constexpr std::uint64_t kMany = 400'000'000;
  std::uint64_t end = 0;
  std::uint64_t largest = 0;
  write_all(file_, changed(read_all(file_), [&](layout::Prologue& prologue, auto& table, std::string& header) {
              const std::string count = "\"vertices\": ";
              header.replace(header.find(count), count.size() + 1, count + std::to_string(kMany));
              header.resize((header.size() + 15) / 16 * 16, ' ');
              end = sizeof prologue + table.size() * sizeof(layout::Section) + header.size();
              for (layout::Section& section : table) {
                if (section.rows == small.mesh.positions.size() && section.type == layout::kFloat) section.rows = kMany;
                section.offset = end;
                end += bytes_of(section);
                largest = std::max(largest, bytes_of(section));
              }
              prologue.file_size = end;
            }));
  ASSERT_GT(largest, std::uint64_t{1} << 32U);
  std::filesystem::resize_file(file_, end);
  EXPECT_EQ(read_transfer_head(file_).receivers, kMany);
  std::filesystem::resize_file(file_, end - (std::uint64_t{1} << 32U));  // the same in 32 bits
  EXPECT_THROW(read_transfer_head(file_), std::runtime_error);
}

TEST_F(TransferFile, IsRefusedWhenItsHeaderDoesNotFitItsSections) {
  write_transfer(file_, stored_transfer({Element::kByte, true, {0, 2}}));
  const std::string good = read_all(file_);
  const auto refusal_with = [&](const std::string& from, const std::string& to) {
    write_all(file_, changed(good, [&](auto&, auto&, std::string& h) { h.replace(h.find(from), from.size(), to); }));
    return refusal();
  };
  EXPECT_NE(refusal_with("\"byte\"", "\"half\"").find("does not fit"), std::string::npos);
  EXPECT_NE(refusal_with("\"byte\"", "\"bite\"").find("storage that does not exist"), std::string::npos);
  for (const char* column : {"4", "9"}) {  // there are four
    const std::string last = std::string("      ") + column + "\n    ]";
    EXPECT_NE(refusal_with("      2\n    ]", last).find("storage that does not exist"), std::string::npos) << column;
  }
  EXPECT_NE(refusal_with("\"one_channel\": true", "\"one_channel\":    1").find("wrong type"), std::string::npos);
  EXPECT_NE(refusal_with("\"one_channel\": true,", "\"one_channel\":false,").find("does not fit"), std::string::npos);
}

TEST_F(TransferFile, GivesBackWhatItsStorageKeeps) {
  for (const Storage& storage : kStorages) {
    const Transfer written = stored_transfer(storage);
    write_transfer(file_, written);
    const Transfer read = read_transfer(file_);
    EXPECT_EQ(read.rows().all(), decode(encode(written.coefficients, written.shape), written.shape));
    EXPECT_EQ(read.shape.storage.element, storage.element);
    EXPECT_EQ(read.shape.storage.kept, storage.kept);
    EXPECT_EQ(read.shape.storage.one_channel, storage.one_channel);
    EXPECT_EQ(transfer_header(read), transfer_header(written));
    write_transfer(folder_.file("b"), read);
    EXPECT_EQ(read_all(folder_.file("b")), read_all(file_)) << "writing again changes nothing";
  }
}

Transfer with_every_entry(bool certified) {
  Transfer transfer = stored_transfer({Element::kHalf, false, {0, 2}});
  transfer.directions = 64;
  transfer.sampler = Sampler::kSobol;
  transfer.seed = 5;
  transfer.instruction_set = "some";
  transfer.mesh.frame = {{1e6, -2.0, 3.0}, 0.5};
  transfer.emitted.assign(transfer.mesh.positions.size(), {1.0F, 2.0F, 3.0F});
  transfer.bounces = {"bicgstab", 7, certified, 0.5, 0.25, 2.0, 0.75, 0.125, 3.0, 0.0625, 32};
  transfer.missing = {4096, 0.001};
  transfer.plan.decisions.push_back({"rays", "more", "they cost", 0, -5, 0.0, "exact"});
  return transfer;
}

TEST_F(TransferFile, GivesBackEveryEntryOfItsHeader) {
  for (const bool certified : {true, false}) {
    const Transfer written = with_every_entry(certified);
    write_transfer(file_, written);
    const Transfer read = read_transfer(file_);
    EXPECT_EQ(read.directions, 64U);
    EXPECT_EQ(read.sampler, Sampler::kSobol);
    EXPECT_EQ(read.seed, 5U);
    EXPECT_EQ(read.instruction_set, "some");
    EXPECT_EQ(read.mesh.frame.origin, written.mesh.frame.origin);
    EXPECT_EQ(read.mesh.frame.unit, 0.5);
    EXPECT_EQ(read.bounces.solver, "bicgstab");
    EXPECT_EQ(read.bounces.applications, 7);
    EXPECT_EQ(read.bounces.certified, certified);
    EXPECT_EQ(read.bounces.bound, certified ? 0.5 : std::numeric_limits<double>::infinity());
    EXPECT_EQ(read.bounces.residual, 0.25);
    EXPECT_EQ(read.bounces.largest, 2.0);
    EXPECT_EQ(read.bounces.spectral_bound, 0.75);
    EXPECT_EQ(read.bounces.emitted_bound, certified ? 0.125 : std::numeric_limits<double>::infinity());
    EXPECT_EQ(read.bounces.emitted_largest, 3.0);
    EXPECT_EQ(read.bounces.directions, 32U);
    EXPECT_EQ(read.bounces.between_vertices, 0.0625);
    EXPECT_EQ(read.missing.directions, 4096U);
    EXPECT_EQ(read.missing.tolerance, 0.001);
    EXPECT_EQ(read.plan.budget, 0.01);
    EXPECT_EQ(read.plan.error, 0.002);
    EXPECT_EQ(read.plan.light_turns, "any");
    ASSERT_EQ(read.plan.decisions.size(), 2U);
    EXPECT_EQ(read.plan.decisions[0].bytes_saved, 12);
    EXPECT_EQ(read.plan.decisions[1].name, "rays");
    EXPECT_EQ(read.plan.decisions[1].choice, "more");
    EXPECT_EQ(read.plan.decisions[1].why, "they cost");
    EXPECT_EQ(read.plan.decisions[1].rays_saved, -5);
    EXPECT_EQ(read.plan.decisions[0].error, 0.002);
    EXPECT_EQ(read.plan.decisions[1].basis, "exact");
    EXPECT_EQ(transfer_header(read), transfer_header(written));
  }
}

TEST_F(TransferFile, HoldsTheLeastAndTheLargestDegree) {
  for (const int degree : {0, kMaxDegree}) {
    Transfer transfer = Transfer::of(kShadowed, degree);
    transfer.mesh = primitive_mesh("plane");
    transfer.coefficients.assign(transfer.mesh.positions.size() * transfer.shape.length(), 0.25F);
    write_transfer(file_, transfer);
    const Transfer read = read_transfer(file_);
    EXPECT_EQ(read.shape.degree, degree);
    EXPECT_EQ(read.coefficients, transfer.coefficients);
  }
}

TEST_F(TransferFile, KeepsDecisionsThatCostOrSaveAsMuchAsCanBeCounted) {
  Transfer transfer = stored_transfer({});
  const auto least = std::numeric_limits<std::int64_t>::min(), most = std::numeric_limits<std::int64_t>::max();
  transfer.plan.decisions[0].rays_saved = least;
  transfer.plan.decisions[0].bytes_saved = most;
  write_transfer(file_, transfer);
  const Transfer read = read_transfer(file_);
  EXPECT_EQ(read.plan.decisions[0].rays_saved, least);
  EXPECT_EQ(read.plan.decisions[0].bytes_saved, most);
}

TEST_F(TransferFile, LeavesOutWhatThereIsNot) {
  Transfer transfer = with_every_entry(true);
  transfer.directions = 0;
  transfer.missing = {};
  transfer.mesh.frame = {};
  transfer.emitted.clear();
  transfer.bounces.emitted_largest = transfer.bounces.between_vertices = 0.0;
  transfer.plan.decisions.clear();
  transfer.shape.storage = {};
  const nlohmann::json whole = nlohmann::json::parse(transfer_header(with_every_entry(true)));
  const nlohmann::json header = nlohmann::json::parse(transfer_header(transfer));
  for (const char* entry : {"sampler", "seed", "complete", "asked", "frame", "emitted", "plan", "storage"}) {
    EXPECT_TRUE(whole.contains(entry)) << entry;
    EXPECT_FALSE(header.contains(entry)) << entry;
  }
  for (const char* entry : {"emitted_bound", "emitted_largest", "between_vertices"}) {
    EXPECT_FALSE(header["bounces"].contains(entry)) << entry;
  }
  transfer.missing.directions = 2;
  EXPECT_EQ(nlohmann::json::parse(transfer_header(transfer))["asked"].dump(), R"({"directions":2})");
  transfer.missing = {0, 0.5};
  EXPECT_EQ(nlohmann::json::parse(transfer_header(transfer))["asked"].dump(), R"({"tolerance":0.5})");
  EXPECT_EQ(nlohmann::json::parse(transfer_header(transfer))["complete"], false);
}

TEST_F(TransferFile, IsRefusedWithAFrameThatIsNoPlaceOrNoLength) {
  write_transfer(file_, with_every_entry(true));
  const std::string good = read_all(file_);
  const auto refusal_with = [&](const std::string& from, std::string to) {
    to.resize(from.size(), ' ');
    write_all(file_, changed(good, [&](auto&, auto&, std::string& h) { h.replace(h.find(from), from.size(), to); }));
    return refusal();
  };
  const std::string reason = file_ + ": transfer file whose frame has an origin or a unit that is no length";
  for (const char* unit : {"0.0", "-.5", "-1", "0"}) {
    EXPECT_NE(refusal_with("\"unit\": 0.5", "\"unit\": " + std::string(unit)), "") << unit;
  }
  EXPECT_EQ(refusal_with("\"unit\": 0.5", "\"unit\": 0.0"), reason);
  EXPECT_EQ(refusal_with("\"unit\": 0.5", "\"unit\":1e99"), reason);
  EXPECT_EQ(refusal_with("1000000.0", "1e101"), reason);
  EXPECT_EQ(refusal_with("1000000.0", "-1e101"), reason);
  EXPECT_EQ(refusal_with("1000000.0", "1e100"), "");
  Transfer transfer = with_every_entry(true);
  for (const auto& [limit, beyond] : {std::pair{0.5 * kLeastExtent, 0.0}, std::pair{2.0 * kLargestExtent, HUGE_VAL}}) {
    transfer.mesh.frame.unit = limit;
    write_transfer(file_, transfer);
    EXPECT_EQ(refusal(), "");
    transfer.mesh.frame.unit = std::nextafter(limit, beyond);
    write_transfer(file_, transfer);
    EXPECT_EQ(refusal(), reason);
  }
}

TEST_F(TransferFile, NamesItsConventionsInItsHeader) {
  const nlohmann::json header = nlohmann::json::parse(transfer_header(small_transfer()));
  for (const char* key : {"kind", "degree", "convention", "axes", "units", "colour_space", "holds", "vertices"}) {
    EXPECT_TRUE(header.contains(key)) << key;
  }
  EXPECT_EQ(header["kind"], "DS");
}

TEST_F(TransferFile, IsRefusedInOneLineWithAnyOneByteChangedOrMissing) {
  std::vector<Transfer> transfers = {small_transfer()};
  for (const Storage& storage : kStorages) transfers.push_back(stored_transfer(storage));
  for (const Transfer& transfer : transfers) {
    write_transfer(file_, transfer);
    const std::string good = read_all(file_);
    ASSERT_GT(good.size(), 500U);
    std::fstream stream(file_, std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t i, char value) {
      stream.seekp(static_cast<std::streamoff>(i)).put(value).flush();
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
      for (const int flip : {0x01, 0x80, 0xFF}) {
        put(i, static_cast<char>(good[i] ^ flip));
        const std::string said = refusal();
        ASSERT_EQ(said.find(file_ + ": "), 0U) << "byte " << i << ": " << said;
        ASSERT_EQ(said.find('\n'), std::string::npos) << "byte " << i << ": " << said;
      }
      put(i, good[i]);
    }
    EXPECT_EQ(refusal(), "");
    for (std::size_t size = good.size(); size-- > 0;) {
      std::filesystem::resize_file(file_, size);
      ASSERT_EQ(refusal().find(file_ + ": "), 0U) << size;
    }
    write_all(file_, good + '\0');
    EXPECT_NE(refusal().find("overlong"), std::string::npos) << refusal();
  }
}

TEST_F(TransferFile, IsRefusedWhenMissingOrAFolder) {
  EXPECT_EQ(refusal().find(file_ + ": cannot read"), 0U) << refusal();
  EXPECT_NE(message_of([&] { read_transfer(std::filesystem::path(file_).parent_path().string()); }), "");
}

TEST_F(TransferFile, LeavesTheOldFileWhenTheDiskIsFull) {
  write_all(file_, "old");
  const Transfer transfer = small_transfer();
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit tiny{64, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tiny), 0);
  const std::string said = message_of([&] { write_transfer(file_, transfer); });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(said, file_ + ": cannot write: File too large");
  EXPECT_EQ(read_all(file_), "old");
  EXPECT_EQ(folder_.entries(), 1U);
}

TEST_F(TransferFile, ReportsAFullDevice) {
  EXPECT_EQ(message_of([] { write_transfer("/dev/full", small_transfer()); }),
            "/dev/full: cannot write: No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(TransferFile, IsRefusedWhereItCannotBeWritten) {
  const std::string there = folder_.file("missing/a.prt");
  EXPECT_EQ(message_of([&] { write_transfer(there, small_transfer()); }),
            there + ": cannot write: No such file or directory");
}

TEST_F(TransferFile, AppearsOnlyWhenComplete) {
  {
    output::AtomicFile file(file_);
    file.write("half", 4);
    EXPECT_FALSE(std::filesystem::exists(file_));
  }
  EXPECT_EQ(folder_.entries(), 0U);
}

}  // namespace
}  // namespace sh::prt::test
