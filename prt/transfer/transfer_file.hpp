// The transfer file: mesh and transfer vectors with checksums. prt/README.md states every byte.
#pragma once
#include <string>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Writes all or nothing (see AtomicFile). Throws std::runtime_error, `path: cannot write: reason`.
void write_transfer(const std::string& path, const Transfer& transfer);

/// Reads and checks everything; throws std::runtime_error with one line for a file that is missing, truncated, followed
/// by further bytes, changed anywhere, or of a later version. Never allocates more than the file is long.
/// `kinds`: those it may be of.
Transfer read_transfer(const std::string& path, TransferKinds kinds = transfer_kinds());

/// The file's JSON header: conventions, units, kind, counts, what the vectors hold. Readable by a program.
std::string transfer_header(const Transfer& transfer);

}  // namespace sh::prt
