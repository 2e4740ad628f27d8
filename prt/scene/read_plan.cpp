// The key `plan` of a scene: prt/scene/plan_options.hpp.
#include <algorithm>

#include "prt/scene/scene_parts.hpp"

namespace sh::prt {

PlanOptions read_plan_options(const JsonReader& reader) {
  reader.allow({"error", "light_turns", "without"});
  PlanOptions options;
  options.mode = PlanMode::kLossy;
  if (const auto error = reader.find("error")) {
    options.error = error->number(1e-9, 1.0, "a number from 1e-9 to 1");
  }
  if (const auto turns = reader.find("light_turns")) {
    options.turns = turns_called(turns->one_of({"none", "about_z", "any"}));
  }
  if (const auto without = reader.find("without")) {
    for (const JsonReader& name : without->items()) {
      options.without.push_back(
          name.one_of({"analytic", "bounces", "channels", "bands", "symmetry", "storage", "directions"}));
    }
  }
  return options;
}

}  // namespace sh::prt
