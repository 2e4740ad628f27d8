// A plan for people and for programs.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "prt/plan/plan.hpp"

namespace sh::prt {

/// A table, a row a decision with its reason below it.
std::string plan_text(const std::string& scene, const Plan& plan);

nlohmann::ordered_json plan_json(const std::string& scene, const Plan& plan);

}  // namespace sh::prt
