// The file of a checkpoint by itself: what was appended comes back, what is torn or changed is dropped, and what is no
// checkpoint of this bake stays as it is.
#include "prt/bake/checkpoint_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "prt/transfer/checksum.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::prt::test {
namespace {

using Records = std::vector<std::pair<std::uint32_t, std::string>>;

constexpr std::size_t kPrologue = 24;
constexpr std::size_t kHead = 32;
const std::string kKey = R"({"degree":2,"seed":7})";
const Records kRecords = {{5, "first"}, {0, ""}, {7, std::string(40, 'x')}, {1, "last"}};

// The front of a checkpoint with any key, and its checksum.
std::string front_of(const std::string& key, std::uint32_t version = 3) {
  std::string bytes = "shpart\n\x1a";
  const auto size = static_cast<std::uint32_t>(key.size());
  bytes.append(reinterpret_cast<const char*>(&version), sizeof version);
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  const std::string covered = bytes + key;
  const std::uint64_t sum = checksum(covered.data(), covered.size());
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return bytes + key;
}

class CheckpointBytes : public testing::Test {
 protected:
  [[nodiscard]] Records read(bool restart = false) const {
    CheckpointFile file(path_, kKey, restart);
    Records records;
    file.read([&](std::uint32_t index, std::string_view data) { records.emplace_back(index, data); });
    return records;
  }

  void append(const Records& records) const {
    CheckpointFile file(path_, kKey, false);
    file.read([](std::uint32_t, std::string_view) {});
    for (const auto& [index, data] : records) file.append(index, data);
  }

  // What opening says after the name of the file; it has to leave the file as it is.
  [[nodiscard]] std::string refusal(const std::string& bytes, bool restart = false) const {
    write_all(path_, bytes);
    const std::string said = message_of([&] { CheckpointFile(path_, kKey, restart); });
    EXPECT_EQ(read_all(path_), bytes);
    EXPECT_EQ(said.rfind(path_ + ": ", 0), 0U) << said;
    return said.size() > path_.size() + 2 ? said.substr(path_.size() + 2) : said;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.part");
};

TEST_F(CheckpointBytes, HoldTheKeyAndEveryRecordInOrder) {
  {
    CheckpointFile file(path_, kKey, false);
    EXPECT_FALSE(file.exists());
    EXPECT_FALSE(std::filesystem::exists(path_)) << "the first append makes it";
  }
  append({});
  EXPECT_FALSE(std::filesystem::exists(path_));
  append(kRecords);
  EXPECT_EQ(read(), kRecords);
  std::string front = read_all(path_).substr(0, kPrologue + kKey.size());
  EXPECT_EQ(front, front_of(kKey));
  append({{9, "more"}});
  Records all = kRecords;
  all.emplace_back(9, "more");
  EXPECT_EQ(read(), all);
}

TEST_F(CheckpointBytes, AreCutOffBehindTheLastWholeRecord) {
  append(kRecords);
  const std::string whole = read_all(path_);
  std::size_t end = kPrologue + kKey.size();  // of the records that are whole
  Records records;
  for (std::size_t size = end; size <= whole.size(); ++size) {
    write_all(path_, whole.substr(0, size));
    if (records.size() < kRecords.size() && size >= end + kHead + kRecords[records.size()].second.size()) {
      end += kHead + kRecords[records.size()].second.size();
      records.push_back(kRecords[records.size()]);
    }
    ASSERT_EQ(read(), records) << size;
    ASSERT_EQ(std::filesystem::file_size(path_), end) << size;
  }
  EXPECT_EQ(records, kRecords);
  append({{9, "more"}});
  records.emplace_back(9, "more");
  EXPECT_EQ(read(), records);
}

TEST_F(CheckpointBytes, GiveNoRecordThatWasChangedAndAllBeforeIt) {
  append(kRecords);
  const std::string whole = read_all(path_);
  std::size_t start = kPrologue + kKey.size();
  for (std::size_t i = 0; i < kRecords.size(); ++i) {
    const std::size_t end = start + kHead + kRecords[i].second.size();
    for (std::size_t place = start; place < end; ++place) {
      std::string changed = whole;
      changed[place] ^= 0x40;
      write_all(path_, changed);
      Records expected = kRecords;
      expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(i),
                     place < start + kHead ? expected.end() : expected.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      ASSERT_EQ(read(), expected) << "the length of a record is in its head: byte " << place - start << " of " << i;
      ASSERT_EQ(std::filesystem::file_size(path_), place < start + kHead ? start : whole.size());
    }
    start = end;
  }
}

TEST_F(CheckpointBytes, OfAHeadThatPromisesMoreThanThereIsAreDropped) {
  append(kRecords);
  const std::size_t end = std::filesystem::file_size(path_);
  for (const std::uint64_t size : {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0} - 31}) {
    std::string head(kHead - sizeof(std::uint64_t), '\0');
    std::memcpy(&head[8], &size, sizeof size);
    const std::uint64_t sum = checksum(head.data(), head.size());
    head.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    write_all(path_, read_all(path_) + head);
    EXPECT_EQ(read(), kRecords) << size;
    EXPECT_EQ(std::filesystem::file_size(path_), end);
  }
}

TEST_F(CheckpointBytes, OfABakeThatWasKilledAtItsFirstByteBegin) {
  const std::string front = front_of(kKey);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kPrologue, front.size() - 1, front.size()}) {
    write_all(path_, front.substr(0, size));
    EXPECT_EQ(read(), Records()) << size;
    EXPECT_EQ(read_all(path_), front) << size;
    append({{4, "four"}});
    EXPECT_EQ(read(), (Records{{4, "four"}})) << size;
  }
}

TEST_F(CheckpointBytes, AreThrownAwayOnRestartWhateverTheirKey) {
  for (const std::string& bytes :
       {front_of(kKey) + "rest", front_of("{}"), front_of(kKey, 9), front_of("").substr(0, 9)}) {
    write_all(path_, bytes);
    EXPECT_EQ(read(true), Records());
    EXPECT_EQ(read_all(path_), front_of(kKey));
  }
  for (const std::string& bytes : {std::string("notes"), "shpart\nX" + std::string(40, 'x')}) {
    for (const bool restart : {false, true}) {
      EXPECT_EQ(refusal(bytes, restart), "no checkpoint of a bake; give another --checkpoint, or --no-checkpoint");
    }
  }
}

TEST_F(CheckpointBytes, OfAnotherBakeStayAndTheFirstDifferenceIsNamed) {
  const auto another = [&](const std::string& key) {
    const std::string said = refusal(front_of(key) + "records");
    const std::string start = "checkpoint of another bake: ";
    EXPECT_EQ(said.rfind(start, 0), 0U) << said;
    return said.substr(start.size(), said.find(';') - start.size());
  };
  EXPECT_EQ(another(R"({"degree":3,"seed":8})"), "its degree is 3, here it is 2");
  EXPECT_EQ(another(R"({"degree":2,"seed":8})"), "its seed is 8, here it is 7");
  EXPECT_EQ(another(R"({"degree":2})"), R"(its seed is "missing", here it is 7)");
  EXPECT_EQ(another(R"({"degree":2,"seed":7,"sun":1})"), "it holds more than this bake has");
  EXPECT_EQ(another("[2]"), "its key is no object");
}

TEST_F(CheckpointBytes, ThatAreDamagedStayAndSayWhatIsWrong) {
  const std::string other = front_of(R"({"degree":3})");
  EXPECT_EQ(refusal(other.substr(0, 8) + "123"), "damaged checkpoint: too short; --restart throws it away");
  EXPECT_EQ(refusal(other.substr(0, 8) + std::string(kPrologue - 9, '1')),
            "damaged checkpoint: too short; --restart throws it away");
  EXPECT_EQ(refusal(front_of(kKey, 2)), "checkpoint of version 2, expected 3; --restart deletes it");
  EXPECT_EQ(refusal(front_of("", 4)), "checkpoint of version 4, expected 3; --restart deletes it");
  const std::string key_differs = "damaged checkpoint: the checksum of its key differs; --restart throws it away";
  EXPECT_EQ(refusal(other.substr(0, other.size() - 1)), key_differs);
  std::string changed = other;
  changed[kPrologue + 2] ^= 1;
  EXPECT_EQ(refusal(changed), key_differs);
  changed = other;
  changed[15] = '\x7f';  // its key is said to be 2 GiB long
  EXPECT_EQ(refusal(changed), key_differs);
  EXPECT_EQ(refusal(front_of("{")).rfind("damaged checkpoint: its key is not JSON", 0), 0U);
}

TEST_F(CheckpointBytes, AreOpenForOneBakeAtATime) {
  const std::string in_use = path_ + ": in use by another bake; wait for it, or give another --checkpoint";
  {
    CheckpointFile file(path_, kKey, false);
    file.append(1, "one");
    EXPECT_EQ(message_of([&] { CheckpointFile(path_, kKey, false); }), in_use);
    EXPECT_EQ(message_of([&] { CheckpointFile(path_, kKey, true); }), in_use);
  }
  const CheckpointFile file(path_, kKey, false);
  EXPECT_EQ(message_of([&] { CheckpointFile(path_, kKey, false); }), in_use);
}

TEST_F(CheckpointBytes, LieInAFileThatCanBeWritten) {
  EXPECT_EQ(message_of([] { CheckpointFile("/dev/null", kKey, false); }),
            "/dev/null: no checkpoint of a bake; give another --checkpoint, or --no-checkpoint");
  write_all(path_, front_of(kKey));
  EXPECT_EQ(message_of([&] { CheckpointFile(path_ + "/b", kKey, false); }), path_ + "/b: cannot open: Not a directory");
  const std::string nowhere = folder_.file("none/b");
  CheckpointFile file(nowhere, kKey, false);
  EXPECT_EQ(message_of([&] { file.append(0, "x"); }), nowhere + ": cannot write: No such file or directory");
}

// As parts of a bake that are only read.
TEST_F(CheckpointBytes, ThatAreOnlyReadStayAsTheyAre) {
  const auto said = [&](const std::string& path) {
    std::string message = message_of([&] { CheckpointFile::for_reading(path, kKey); });
    EXPECT_TRUE(message.empty() || message.rfind(path + ": ", 0) == 0) << message;
    return message.substr(message.empty() ? 0 : path.size() + 2);
  };
  const auto of = [&](const std::string& bytes) {
    write_all(path_, bytes);
    std::string message = said(path_);
    EXPECT_EQ(read_all(path_), bytes);
    return message;
  };
  const std::string none = "no part of a bake; expected a part that `--shard` made";
  EXPECT_EQ(said(path_), "cannot open: No such file or directory");
  EXPECT_EQ(said(folder_.path().string()), none);
  EXPECT_EQ(of("text that is no part of a bake"), none);
  EXPECT_EQ(of(""), none);
  const std::string front = front_of(kKey);
  EXPECT_EQ(of(front), "");  // no record yet
  for (const std::size_t size : {std::size_t{8}, kPrologue - 1, kPrologue, front.size() - 1}) {
    EXPECT_EQ(of(front.substr(0, size)), "damaged: it ends within its key") << size;
  }
  std::string changed = front;
  changed[kPrologue + 2] ^= 1;
  EXPECT_EQ(of(changed), "damaged: the checksum of its key differs");
  EXPECT_EQ(of(front_of(kKey, 4)), "part of version 4, expected 3; bake it again");
  EXPECT_EQ(of(front_of(R"({"degree":2,"seed":8})")),
            "part of another bake: its seed is 8, here it is 7; expected the parts of one bake");

  write_all(path_, front + "a torn record");
  {
    CheckpointFile one = CheckpointFile::for_reading(path_, kKey);
    CheckpointFile another = CheckpointFile::for_reading(path_, kKey);
    for (CheckpointFile* file : {&one, &another}) {
      file->read([](std::uint32_t, std::string_view) { ADD_FAILURE() << "a record that is not there"; });
    }
  }
  EXPECT_EQ(read_all(path_), front + "a torn record");
  const CheckpointFile writer(path_, kKey, false);
  EXPECT_EQ(said(path_), "in use by another bake; wait for it");
}

TEST_F(CheckpointBytes, ThatVanishWhileTheyAreReadAreNotInvented) {
  append(kRecords);
  CheckpointFile file(path_, kKey, false);
  std::filesystem::resize_file(path_, kPrologue + kKey.size() + 5);
  EXPECT_EQ(message_of([&] { file.read([](std::uint32_t, std::string_view) {}); }),
            path_ + ": cannot read: it became shorter");
}

TEST_F(CheckpointBytes, StayWholeWhereTheDiskIsFull) {
  append(kRecords);
  const std::size_t end = std::filesystem::file_size(path_);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit tight{end + 100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  const std::string said = message_of([&] { append({{9, std::string(200, 'y')}}); });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(said, path_ +
                      ": cannot write: File too large (the finished parts are kept; --no-checkpoint bakes without a "
                      "checkpoint)");
  EXPECT_EQ(std::filesystem::file_size(path_), end);
  EXPECT_EQ(read(), kRecords);
}

}  // namespace
}  // namespace sh::prt::test
