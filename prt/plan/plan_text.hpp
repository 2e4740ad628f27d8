// A plan as text and as JSON.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prt/bake/job.hpp"

namespace sh::prt {

/// A table with one row for each decision and its reason below it. Precondition: the job has a plan.
std::string plan_text(const BakeJob& job);

nlohmann::ordered_json plan_json(const BakeJob& job);

}  // namespace sh::prt
