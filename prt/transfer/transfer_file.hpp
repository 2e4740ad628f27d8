// The transfer file: mesh and transfer vectors with checksums, and its JSON parts. prt/README.md states every byte.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// Writes all or nothing (see AtomicFile). Throws std::runtime_error, `path: cannot write: reason`.
void write_transfer(const std::string& path, const Transfer& transfer);

/// Reads and checks everything. Throws std::runtime_error with one line for a file that is missing, truncated, followed
/// by further bytes, changed anywhere, or of a later version. Checks all sizes against the file's size before it
/// allocates memory. `kinds` are the accepted kinds.
Transfer read_transfer(const std::string& path, TransferKinds kinds = transfer_kinds());

/// The JSON header of the file for programs: conventions, units, kind, counts, and the meaning of the vectors.
std::string transfer_header(const Transfer& transfer);

nlohmann::ordered_json to_json(const Storage& storage);
nlohmann::ordered_json to_json(const PlanRecord& plan);

/// Reads the output of transfer_header() into all of `transfer` except its mesh and numbers. `version` is the version
/// of the file. Throws std::invalid_argument, one line without the file's name, for an inconsistent header, and
/// nlohmann::json::exception for entries that are missing or of the wrong type.
void take_header(const nlohmann::json& header, std::uint32_t version, TransferKinds kinds, Transfer& transfer);

}  // namespace sh::prt
