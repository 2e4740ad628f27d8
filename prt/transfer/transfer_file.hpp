// The transfer file: mesh and transfer vectors with checksums. prt/FILES.md states every byte.
#pragma once
#include <string>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Writes all or nothing (see AtomicFile). Throws std::runtime_error, `path: cannot write: reason`.
void write_transfer(const std::string& path, const Transfer& transfer);

/// Reads and checks everything. Throws std::runtime_error with one line for a file that is missing, truncated, followed
/// by further bytes, changed anywhere, or of a later version. Checks all sizes against the file's size before it
/// allocates memory. `kinds` are the accepted kinds.
Transfer read_transfer(const std::string& path, TransferKinds kinds = surface_kinds());

/// What a file tells without its sections: the header as it stands there, and a transfer with its kind, shapes and plan, but
/// without numbers, vertices and faces.
struct TransferHead {
  std::string header;
  Transfer transfer;
  std::size_t receivers = 0;
};

/// Reads the head of a file of any size in a moment. Checks the file's size, the head, and that the sections fit the file and
/// each other, but not what they hold. Throws like read_transfer().
TransferHead read_transfer_head(const std::string& path, TransferKinds kinds = file_kinds());

/// Whether a file can be read and begins as a transfer file does.
bool is_transfer_file(const std::string& path);

/// The kind of a transfer file whose header can be read; null for any other file.
const TransferKind* kind_of_file(const std::string& path);

/// The JSON header of the file for programs: conventions, units, kind, counts, and the meaning of the vectors.
std::string transfer_header(const Transfer& transfer);

}  // namespace sh::prt
