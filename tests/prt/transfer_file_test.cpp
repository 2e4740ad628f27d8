// The transfer file: round trips are exact; damaged files are refused in one line.
#include "prt/transfer/transfer_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

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

// The file with its section table and its JSON header changed, and its checksums made good.
std::string changed(std::string bytes, const std::function<void(std::vector<layout::Section>&, std::string&)>& change) {
  layout::Prologue prologue;
  std::memcpy(&prologue, bytes.data(), sizeof prologue);
  std::vector<layout::Section> table(prologue.sections);
  const std::size_t size = table.size() * sizeof(layout::Section);
  std::memcpy(table.data(), bytes.data() + sizeof prologue, size);
  std::string header = bytes.substr(sizeof prologue + size, prologue.header_size);
  change(table, header);
  prologue.header_checksum = checksum(header.data(), header.size());
  prologue.checksum = layout::front_checksum(prologue, table);
  std::memcpy(bytes.data(), &prologue, sizeof prologue);
  std::memcpy(bytes.data() + sizeof prologue, table.data(), size);
  return bytes.replace(sizeof prologue + size, header.size(), header);
}

TEST_F(TransferFile, IsRefusedWithASectionThatIsUnknownMissingOrOutOfPlace) {
  write_transfer(file_, small_transfer());
  const std::string good = read_all(file_);
  const auto refusal_with = [&](const std::function<void(std::vector<layout::Section>&)>& change) {
    write_all(file_, changed(good, [&](auto& table, auto&) { change(table); }));
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

TEST_F(TransferFile, IsRefusedWhenItsHeaderDoesNotFitItsSections) {
  write_transfer(file_, stored_transfer({Element::kByte, true, {0, 2}}));
  const std::string good = read_all(file_);
  const auto refusal_with = [&](const std::string& from, const std::string& to) {
    write_all(file_, changed(good, [&](auto&, std::string& h) { h.replace(h.find(from), from.size(), to); }));
    return refusal();
  };
  EXPECT_NE(refusal_with("\"byte\"", "\"half\"").find("does not fit"), std::string::npos);
  EXPECT_NE(refusal_with("\"byte\"", "\"bite\"").find("storage that does not exist"), std::string::npos);
  EXPECT_NE(refusal_with("      2\n    ]", "      9\n    ]").find("storage that does not exist"), std::string::npos);
  EXPECT_NE(refusal_with("\"one_channel\": true", "\"one_channel\":    1").find("wrong type"), std::string::npos);
  EXPECT_NE(refusal_with("\"one_channel\": true,", "\"one_channel\":false,").find("does not fit"), std::string::npos);
}

TEST_F(TransferFile, GivesBackWhatItsStorageKeeps) {
  for (const Storage& storage : kStorages) {
    const Transfer written = stored_transfer(storage);
    write_transfer(file_, written);
    const Transfer read = read_transfer(file_);
    EXPECT_EQ(read.coefficients, decode(encode(written.coefficients, written.shape), written.shape));
    EXPECT_EQ(read.shape.storage.element, storage.element);
    EXPECT_EQ(read.shape.storage.kept, storage.kept);
    EXPECT_EQ(read.shape.storage.one_channel, storage.one_channel);
    EXPECT_EQ(transfer_header(read), transfer_header(written));
    write_transfer(folder_.file("b"), read);
    EXPECT_EQ(read_all(folder_.file("b")), read_all(file_)) << "writing again changes nothing";
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
