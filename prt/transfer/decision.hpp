// What a plan left out of a bake, and what that costs: kept in the transfer file for whoever reads it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace sh::prt {

/// One decision. `error` is relative to the plan's reference radiance (prt/plan/plan.hpp). `basis` says how it is
/// known: exact (no error but rounding), bound (proved, for any vertex), measured (on a probe of vertices, RMS),
/// heuristic.
struct Decision {
  std::string name;
  std::string choice;
  std::string why;
  std::int64_t bytes_saved = 0;
  std::int64_t rays_saved = 0;
  double error = 0.0;
  std::string basis = "exact";
};

/// The decisions a file was baked by; `budget` 0: only what is exact whatever the light.
struct PlanRecord {
  double budget = 0.0;
  double error = 0.0;       // the sum over the decisions
  std::string light_turns;  // that the errors hold for: none, about_z or any; empty without a budget
  std::vector<Decision> decisions;
};

}  // namespace sh::prt
