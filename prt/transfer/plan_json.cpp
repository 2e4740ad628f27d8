#include "prt/transfer/plan_json.hpp"

#include <algorithm>
#include <functional>
#include <string>

namespace sh::prt {

namespace {

nlohmann::ordered_json to_json(const Decision& decision) {
  return {{"name", decision.name},
          {"choice", decision.choice},
          {"why", decision.why},
          {"bytes_saved", decision.bytes_saved},
          {"rays_saved", decision.rays_saved},
          {"error", decision.error},
          {"basis", decision.basis}};
}

Decision decision_from(const nlohmann::json& json) {
  return {json.at("name").get<std::string>(),        json.at("choice").get<std::string>(),
          json.at("why").get<std::string>(),         json.at("bytes_saved").get<std::int64_t>(),
          json.at("rays_saved").get<std::int64_t>(), json.at("error").get<double>(),
          json.at("basis").get<std::string>()};
}

}  // namespace

nlohmann::ordered_json to_json(const Storage& storage) {
  return {{"element", kElementNames[static_cast<std::size_t>(storage.element)]},
          {"one_channel", storage.one_channel},
          {"kept", storage.kept}};
}

std::optional<Storage> storage_from(const nlohmann::json& json, const RowShape& shape) {
  const auto name = json.at("element").get<std::string>();
  const auto* known = std::find(kElementNames.begin(), kElementNames.end(), name);
  Storage storage;
  storage.one_channel = json.at("one_channel").get<bool>();
  storage.kept = json.at("kept").get<std::vector<std::uint32_t>>();
  const bool rises = std::is_sorted(storage.kept.begin(), storage.kept.end(), std::less_equal<>());
  if (known == kElementNames.end() || !rises || (!storage.kept.empty() && storage.kept.back() >= shape.count)) {
    return std::nullopt;
  }
  storage.element = static_cast<Element>(known - kElementNames.begin());
  return storage;
}

nlohmann::ordered_json to_json(const PlanRecord& plan) {
  nlohmann::ordered_json decisions = nlohmann::ordered_json::array();
  for (const Decision& decision : plan.decisions) {
    decisions.push_back(to_json(decision));
  }
  return {{"budget", plan.budget}, {"error", plan.error}, {"light_turns", plan.light_turns}, {"decisions", decisions}};
}

PlanRecord plan_from(const nlohmann::json& json) {
  PlanRecord plan;
  plan.budget = json.at("budget").get<double>();
  plan.error = json.at("error").get<double>();
  plan.light_turns = json.at("light_turns").get<std::string>();
  for (const nlohmann::json& decision : json.at("decisions")) {
    plan.decisions.push_back(decision_from(decision));
  }
  return plan;
}

}  // namespace sh::prt
