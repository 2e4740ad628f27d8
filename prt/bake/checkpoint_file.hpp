// A checkpoint on disk: a key that names its bake, then records, one a chunk of vertices, appended as
// they finish. In: bytes of chunks. Out: those that are whole, after any end of the process. prt/README.md states every
// byte. A record that a killed process left half written, or that was changed, fails its checksum and is dropped.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace sh::prt {

class CheckpointFile {
 public:
  /// `key` is a JSON object of everything that decides the bytes of the chunks. Opens the file where there is one, else
  /// makes it with the first append(); `restart` empties one of any key. Throws std::runtime_error with one line, and
  /// changes nothing, where the file is no checkpoint, has another key (the line says which entry differs) or is in use
  /// by another process.
  CheckpointFile(std::string path, const std::string& key, bool restart);
  ~CheckpointFile();  // the file stays
  CheckpointFile(const CheckpointFile&) = delete;
  CheckpointFile& operator=(const CheckpointFile&) = delete;

  /// Calls take(index, data) for every record that is whole, in the order of the file, and cuts off what follows the
  /// last one. Call it once, before append().
  void read(const std::function<void(std::uint32_t index, std::string_view data)>& take);
  /// Appends a record; survives the end of the process, not that of the machine (then the last seconds may be lost).
  /// Throws std::runtime_error where it cannot be written.
  void append(std::uint32_t index, std::string_view data);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool exists() const { return descriptor_ >= 0; }

 private:
  void open_existing(bool restart);
  [[noreturn]] void refuse_key() const;
  void create();
  void lock();
  void write(std::string_view bytes);  // at end_, which it moves; all or nothing
  [[nodiscard]] std::string fetch(std::uint64_t offset, std::uint64_t size) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::string front_;  // prologue and key, as they lie in the file
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t end_ = 0;  // where the next record goes
};

}  // namespace sh::prt
