// Errors of the machine, not of the input.
#pragma once
#include <cerrno>
#include <stdexcept>
#include <string>

namespace sh::output {

/// A disk is full, a device fails, another process holds the file: the same command may succeed later or elsewhere.
struct MachineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MachineError if `error`, an errno, is one of the machine, else std::runtime_error.
[[noreturn]] inline void fail_by(int error, const std::string& line) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:  // a limit of the process
    case EIO:
    case ENOMEM:
    case ENFILE:
    case EMFILE:
    case ESTALE:
      throw MachineError(line);
    default:
      throw std::runtime_error(line);
  }
}

}  // namespace sh::output
