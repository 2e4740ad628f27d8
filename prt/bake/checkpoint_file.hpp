// A checkpoint on disk: a key that identifies its bake, then one record for each chunk of vertices, appended when the
// chunk is finished. In: bytes of chunks. Out: all complete records, however the process ended. prt/FILES.md states
// every byte. A record that is incomplete or changed fails its checksum and is dropped.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace sh::prt {

class CheckpointFile {
 public:
  /// `key` is a JSON object of everything that the bytes of the chunks depend on. Opens the file if it exists; else the
  /// first append() creates it. `restart` empties an existing checkpoint, whatever its key. Throws std::runtime_error
  /// with one line, and changes nothing, if the file is no checkpoint, has another key (the line names the entry that
  /// differs) or is in use by another process.
  CheckpointFile(std::string path, const std::string& key, bool restart);
  /// Opens an existing file for reading alone, beside other readers. Throws as above, also if there is none.
  static CheckpointFile for_reading(std::string path, const std::string& key);
  /// The same whatever its key.
  static CheckpointFile of_any_bake(std::string path);
  ~CheckpointFile();  // the file stays
  CheckpointFile(CheckpointFile&& other) noexcept;
  CheckpointFile& operator=(CheckpointFile&&) = delete;
  CheckpointFile(const CheckpointFile&) = delete;
  CheckpointFile& operator=(const CheckpointFile&) = delete;

  /// Calls take(index, data) for every complete record, in the order of the file, and cuts off the bytes after the last
  /// one. Call it once, before append().
  void read(const std::function<void(std::uint32_t index, std::string_view data)>& take);
  /// Appends a record. The record survives the end of the process; a crash of the machine may lose the last seconds.
  /// Throws std::runtime_error if writing fails.
  void append(std::uint32_t index, std::string_view data);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool exists() const { return descriptor_ >= 0; }

 private:
  explicit CheckpointFile(std::string path) : path_(std::move(path)), is_read_only_(true) {}
  void open_existing(bool restart);
  [[noreturn]] void refuse_key() const;
  void create();
  void lock();
  void write(std::string_view bytes);  // at end_, which advances; all or nothing
  [[nodiscard]] std::string fetch(std::uint64_t offset, std::uint64_t size) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::string front_;  // prologue and key, as they lie in the file
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t end_ = 0;  // where the next record goes
  bool is_read_only_ = false;
};

}  // namespace sh::prt
