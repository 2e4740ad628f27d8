// A plan for people and for programs.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prt/bake/job.hpp"

namespace sh::prt {

/// A table, a row a decision with its reason below it; of a job that is planned.
std::string plan_text(const BakeJob& job);

nlohmann::ordered_json plan_json(const BakeJob& job);

}  // namespace sh::prt
