#include "prt/bake/checkpoint_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "numeric/output/machine_error.hpp"
#include "numeric/output/parse_json.hpp"
#include "prt/transfer/checksum.hpp"

namespace sh::prt {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "checkpoints are little-endian and read as they lie");

constexpr std::array<char, 8> kMagic = {'s', 'h', 'p', 'a', 'r', 't', '\n', '\x1a'};
constexpr std::uint32_t kVersion = 3;  // of the format and of the contents of the chunks

/// The first bytes of the file, followed by the key as JSON text; `checksum` covers the bytes before it and the key.
struct Prologue {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t key_size = 0;
  std::uint64_t checksum = 0;
};

/// The head of a record, before its data; `checksum` covers the bytes before it.
struct RecordHead {
  std::uint32_t index = 0;
  std::uint32_t reserved = 0;
  std::uint64_t size = 0;
  std::uint64_t data_checksum = 0;
  std::uint64_t checksum = 0;
};
static_assert(sizeof(Prologue) == 24 && sizeof(RecordHead) == 32);

std::uint64_t checksum_of(const Prologue& prologue, std::string_view key) {
  std::string bytes(reinterpret_cast<const char*>(&prologue), offsetof(Prologue, checksum));
  bytes += key;
  return checksum(bytes.data(), bytes.size());
}

std::uint64_t checksum_of(const RecordHead& head) { return checksum(&head, offsetof(RecordHead, checksum)); }

std::string front_of(const std::string& key) {
  Prologue prologue;
  prologue.key_size = static_cast<std::uint32_t>(key.size());
  prologue.checksum = checksum_of(prologue, key);
  return std::string(reinterpret_cast<const char*>(&prologue), sizeof prologue) + key;
}

// The first entry that differs, as text for messages.
std::string difference(const Json& found, const Json& wanted) {
  if (!found.is_object()) return "its key is no object";
  for (const auto& [name, value] : wanted.items()) {
    const Json other = found.value(name, Json("missing"));
    if (other != value) return fmt::format("its {} is {}, here it is {}", name, other.dump(), value.dump());
  }
  return "it holds more than this bake has";
}

}  // namespace

CheckpointFile::CheckpointFile(std::string path, const std::string& key, bool restart)
    : path_(std::move(path)), front_(front_of(key)) {
  descriptor_ = open(path_.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ >= 0) {
    try {
      open_existing(restart);
    } catch (...) {
      close(descriptor_);
      throw;
    }
  } else if (errno != ENOENT) {
    fail(fmt::format("cannot open: {}", std::strerror(errno)));
  }
}

CheckpointFile::CheckpointFile(CheckpointFile&& other) noexcept
    : path_(std::move(other.path_)),
      front_(std::move(other.front_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      end_(other.end_),
      is_read_only_(other.is_read_only_) {}

CheckpointFile CheckpointFile::of_any_bake(std::string path) {
  constexpr const char* kNone = "no part of a bake; expected a part that `--shard` made";
  CheckpointFile file(std::move(path));
  file.descriptor_ = open(file.path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file.descriptor_ < 0) file.fail(fmt::format("cannot open: {}", std::strerror(errno)));
  struct stat status = {};
  fstat(file.descriptor_, &status);
  if (!S_ISREG(status.st_mode)) file.fail(kNone);
  if (flock(file.descriptor_, LOCK_SH | LOCK_NB) != 0) {
    throw output::MachineError(file.path_ + ": in use by another bake; wait for it");
  }
  file.size_ = static_cast<std::uint64_t>(status.st_size);
  Prologue prologue;
  const std::string start = file.fetch(0, std::min<std::uint64_t>(file.size_, sizeof prologue));
  if (!start.starts_with(std::string_view(kMagic.data(), kMagic.size()))) file.fail(kNone);
  std::memcpy(&prologue, start.data(), start.size());
  file.end_ = sizeof prologue + prologue.key_size;
  if (file.end_ > file.size_) file.fail("damaged: it ends within its key");
  file.front_ = file.fetch(0, file.end_);
  if (prologue.version == kVersion && checksum_of(prologue, file.front_.substr(sizeof prologue)) != prologue.checksum) {
    file.fail("damaged: the checksum of its key differs");
  }
  return file;
}

CheckpointFile CheckpointFile::for_reading(std::string path, const std::string& key) {
  CheckpointFile file = of_any_bake(std::move(path));
  const std::string wanted = front_of(key);
  if (std::exchange(file.front_, wanted) != wanted) file.refuse_key();
  return file;
}

CheckpointFile::~CheckpointFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void CheckpointFile::open_existing(bool restart) {
  struct stat status = {};
  fstat(descriptor_, &status);
  if (!S_ISREG(status.st_mode)) fail("no checkpoint of a bake; give another --checkpoint, or --no-checkpoint");
  lock();
  size_ = static_cast<std::uint64_t>(status.st_size);
  const std::string start = fetch(0, std::min<std::uint64_t>(size_, front_.size()));
  const std::string_view magic(kMagic.data(), kMagic.size());
  if (start == front_ && !restart) {
    end_ = front_.size();
  } else if (front_.starts_with(start) || (restart && start.starts_with(magic))) {  // empty, killed while it was made
    size_ = 0;
    if (ftruncate(descriptor_, 0) != 0) fail(fmt::format("cannot write: {}", std::strerror(errno)));
    write(front_);
  } else if (!start.starts_with(magic)) {
    fail("no checkpoint of a bake; give another --checkpoint, or --no-checkpoint");
  } else {
    refuse_key();
  }
}

// Throws an error that names the difference.
void CheckpointFile::refuse_key() const {
  Prologue prologue;
  if (size_ < sizeof prologue) fail("damaged checkpoint: too short; --restart throws it away");
  std::memcpy(&prologue, fetch(0, sizeof prologue).data(), sizeof prologue);
  if (prologue.version != kVersion) {
    fail(is_read_only_
             ? fmt::format("part of version {}, expected {}; bake it again", prologue.version, kVersion)
             : fmt::format("checkpoint of version {}, expected {}; --restart deletes it", prologue.version, kVersion));
  }
  const std::string key = fetch(sizeof prologue, std::min<std::uint64_t>(size_ - sizeof prologue, prologue.key_size));
  if (checksum_of(prologue, key) != prologue.checksum) {
    fail("damaged checkpoint: the checksum of its key differs; --restart throws it away");
  }
  std::string what;
  try {
    what = difference(output::parse_json<Json>(key), Json::parse(front_.substr(sizeof prologue)));
  } catch (const std::runtime_error& error) {
    fail(fmt::format("damaged checkpoint: its key is {}; --restart throws it away", error.what()));
  }
  if (is_read_only_) fail(fmt::format("part of another bake: {}; expected the parts of one bake", what));
  fail(
      fmt::format("checkpoint of another bake: {}; finish that one, give another --checkpoint, or delete it with "
                  "--restart",
                  what));
}

void CheckpointFile::create() {
  descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(fmt::format("cannot write: {}", std::strerror(errno)));
  lock();
  write(front_);
}

void CheckpointFile::lock() {
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    throw output::MachineError(path_ + ": in use by another bake; wait for it, or give another --checkpoint");
  }
}

void CheckpointFile::read(const std::function<void(std::uint32_t, std::string_view)>& take) {
  while (end_ + sizeof(RecordHead) <= size_) {
    RecordHead head;
    std::memcpy(&head, fetch(end_, sizeof head).data(), sizeof head);
    if (checksum_of(head) != head.checksum || head.size > size_ - end_ - sizeof head) break;
    const std::string data = fetch(end_ + sizeof head, head.size);
    end_ += sizeof head + head.size;
    if (checksum(data.data(), data.size()) == head.data_checksum) take(head.index, data);
  }
  if (end_ < size_ && !is_read_only_ && ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) {
    fail(fmt::format("cannot write: {}", std::strerror(errno)));
  }
}

void CheckpointFile::append(std::uint32_t index, std::string_view data) {
  if (!exists()) create();
  RecordHead head;
  head.index = index;
  head.size = data.size();
  head.data_checksum = checksum(data.data(), data.size());
  head.checksum = checksum_of(head);
  std::string record(reinterpret_cast<const char*>(&head), sizeof head);
  record += data;
  write(record);
}

void CheckpointFile::write(std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(end_ + done));
    if (count < 0 && errno != EINTR) {
      const int error = errno;
      [[maybe_unused]] const int ignored =
          ftruncate(descriptor_, static_cast<off_t>(end_));  // a torn record does no harm
      output::fail_by(error,
                      fmt::format("{}: cannot write: {} (the finished parts are kept; --no-checkpoint bakes without a "
                                  "checkpoint)",
                                  path_, std::strerror(error)));
    }
    done += std::max<ssize_t>(count, 0);
  }
  end_ += bytes.size();
}

std::string CheckpointFile::fetch(std::uint64_t offset, std::uint64_t size) const {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = pread(descriptor_, bytes.data() + done, size - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno != EINTR) fail(fmt::format("cannot read: {}", std::strerror(errno)));
    if (count == 0) fail("cannot read: it became shorter");
    done += std::max<ssize_t>(count, 0);
  }
  return bytes;
}

void CheckpointFile::fail(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}: {}", path_, what));
}

}  // namespace sh::prt
