// Plans, storage and the header of a transfer file as JSON. No public header includes this one.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "prt/transfer/kept_bands.hpp"
#include "prt/transfer/transfer.hpp"

namespace sh::prt {

nlohmann::ordered_json to_json(const Storage& storage);
nlohmann::ordered_json to_json(const PlanRecord& plan);
/// As `keep` of a scene.
nlohmann::ordered_json to_json(const KeptBands& kept, const TransferKind& kind);

/// What to_json() made. Throw like take_header(). `columns`: of a row.
PlanRecord plan_record_from(const nlohmann::json& json);
Storage storage_from(const nlohmann::json& json, std::size_t columns);

/// Reads the output of transfer_header() into all of `transfer` except its mesh and numbers. `version` is the version
/// of the file. Throws std::invalid_argument, one line without the file's name, for an inconsistent header, and
/// nlohmann::json::exception for entries that are missing or of the wrong type.
void take_header(const nlohmann::json& header, std::uint32_t version, TransferKinds kinds, Transfer& transfer);

}  // namespace sh::prt
