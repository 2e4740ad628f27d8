// The operator new of the tool `prt`: large arrays lie on large pages of memory, where the system has them, which saves
// faults of pages; or in files of a folder, where the user names one, for work that is larger than memory.
#pragma once
#include <new>
#include <string>

namespace sh::prt {

/// The disk has no room for an array; what() says so in one line.
class ScratchFull : public std::bad_alloc {
 public:
  explicit ScratchFull(const std::string& line) noexcept;
  [[nodiscard]] const char* what() const noexcept override { return static_cast<const char*>(line_); }

 private:
  char line_[512]{};
};

/// From now on, an array of 16 MiB or more that operator new makes is a file in `folder`, mapped into memory, without a name
/// and gone with the process. The system keeps in memory what is in use, so that a command needs room on the disk in place
/// of memory. Not so: what libraries take by malloc, such as the tree of the ray tracer. Where the disk is full, operator
/// new throws ScratchFull. Once in a process. Throws std::runtime_error, one line, for a folder that cannot be written.
void use_scratch(const std::string& folder);

}  // namespace sh::prt
