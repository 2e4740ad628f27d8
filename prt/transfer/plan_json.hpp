// Plans and storage as JSON, for a transfer file's header and for the tool.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "prt/transfer/decision.hpp"
#include "prt/transfer/storage.hpp"

namespace sh::prt {

nlohmann::ordered_json to_json(const Storage& storage);
/// Nothing where it names an unknown element or indices that do not rise or are too large for the shape.
/// Throws nlohmann::json::exception for entries that are missing or of the wrong type.
std::optional<Storage> storage_from(const nlohmann::json& json, const RowShape& shape);

nlohmann::ordered_json to_json(const PlanRecord& plan);
/// Throws nlohmann::json::exception for entries that are missing or of the wrong type.
PlanRecord plan_from(const nlohmann::json& json);

}  // namespace sh::prt
