#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "prt/plan/plan.hpp"
#include "prt/transfer/transfer_json.hpp"

namespace sh::prt {

namespace {

std::string in_millions(std::int64_t count, const char* unit) {
  return count == 0 ? "-" : fmt::format("{:.2f} M{}", static_cast<double>(count) * 1e-6, unit);
}

double part(std::int64_t of, std::int64_t whole) {
  return whole == 0 ? 100.0 : 100.0 * static_cast<double>(of) / static_cast<double>(whole);
}

}  // namespace

std::string plan_text(const Plan& plan, const Scene& scene) {
  const PlanRecord& record = plan.record;
  std::string text =
      record.budget > 0.0
          ? fmt::format(
                "{}: limit {:.3g} of {:.3g} W m^-2 sr^-1 (the largest exit radiance unshadowed), RMS over vertices; "
                "lights turned: {}\n",
                scene.name, record.budget, plan.reference, record.light_turns)
          : fmt::format("{}: only decisions that change no number under any light\n", scene.name);
  text +=
      fmt::format("{:<11}{:<38}{:>11}{:>13}{:>9}  {}\n", "decision", "choice", "saves", "rays", "error", "known by");
  for (const Decision& decision : record.decisions) {
    text += fmt::format("{:<11}{:<38}{:>11}{:>13}{:>9.2g}  {}\n{:<11}{}\n", decision.name, decision.choice,
                        in_millions(decision.bytes_saved, "B"), in_millions(decision.rays_saved, ""), decision.error,
                        decision.basis, "", decision.why);
  }
  text += fmt::format("in all: {:.2f} of {:.2f} MB of transfer ({:.0f} %), {:.1f} of {:.1f} million rays ({:.0f} %)",
                      static_cast<double>(plan.planned.bytes) * 1e-6, static_cast<double>(plan.asked.bytes) * 1e-6,
                      part(plan.planned.bytes, plan.asked.bytes), static_cast<double>(plan.planned.rays) * 1e-6,
                      static_cast<double>(plan.asked.rays) * 1e-6, part(plan.planned.rays, plan.asked.rays));
  if (record.budget > 0.0 && plan.known_by.empty()) text += fmt::format(", error at most {:.2g}", record.error);
  if (!plan.known_by.empty()) text += fmt::format("\nerror {:.2g} ({})", record.error, plan.known_by);
  text += "\n";
  if (plan.beyond > 0.0) {
    text += fmt::format(
        "beside it: what the asked degree leaves out of the lights (bands to 10) would change at most {:.2g}\n",
        plan.beyond);
  }
  return text;
}

std::string plan_json(const Plan& plan, const Scene& scene) {
  const BakeOptions& bake = scene.bake;
  nlohmann::ordered_json json = to_json(plan.record);
  json["scene"] = scene.name;
  json["error_known_by"] = !plan.known_by.empty() ? plan.known_by : plan.record.error > 0.0 ? "bound" : "exact";
  json["reference_radiance"] = plan.reference;
  json["beyond_asked_degree"] = plan.beyond;
  json["bytes"] = {{"asked", plan.asked.bytes}, {"planned", plan.planned.bytes}};
  json["rays"] = {{"asked", plan.asked.rays}, {"planned", plan.planned.rays}};
  json["bake"] = {{"degree", bake.degree},
                  {"directions", bake.directions},
                  {"transfer", bake.kind->word},
                  {"tolerance", bake.bounces.tolerance},
                  {"open_vertices", std::count(plan.open.begin(), plan.open.end(), std::uint8_t{1})}};
  if (bake.kind->stores_visibility()) json["bake"]["keep"] = to_json(bake.keep.within(bake.degree), *bake.kind);
  json["storage"] = to_json(plan.storage);
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);  // a file's name may be no UTF-8
}

}  // namespace sh::prt
