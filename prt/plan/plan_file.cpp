#include "prt/plan/plan_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "numeric/output/atomic_file.hpp"
#include "numeric/output/parse_json.hpp"
#include "prt/arrays.hpp"
#include "prt/light/light.hpp"
#include "prt/mesh/keep_vertices.hpp"
#include "prt/mesh/mesh_checksum.hpp"
#include "prt/scene/scene_parts.hpp"
#include "prt/transfer/checksum.hpp"
#include "prt/transfer/transfer_json.hpp"
#include "prt/whole_number.hpp"

namespace sh::prt {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr const char* kVersionKey = "shforge_plan";
constexpr const char* kChecksumKey = "checksum";
constexpr double kSameLight = 1e-6;  // of its largest number: machines round differently

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: {}; expected a file that `prt plan -o` made", file, why));
}

std::vector<double> light_of(const Scene& scene) {
  return project(load_lights(scene.lights, OnFlaw::kMend), kMaxDegree).values;
}

bool is_same_light(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  const double largest = as_array(b).abs().maxCoeff();
  return ((as_array(a) - as_array(b)).abs() <= kSameLight * largest).all();
}

// As `bake` of a scene.
Json to_json(const BakeOptions& bake) {
  Json json = {{"degree", bake.degree},      {"directions", bake.directions}, {"sampler", name_of(bake.sampler)},
               {"seed", bake.seed},          {"transfer", bake.kind->word},   {"tolerance", bake.bounces.tolerance},
               {"fit_lobes", bake.fit_lobes}};
  if (bake.bounces.directions > 0) json["bounce_directions"] = bake.bounces.directions;
  if (bake.kind->stores_visibility()) json["keep"] = to_json(bake.keep.within(bake.degree), *bake.kind);
  if (bake.compress_by_plan) {
    json["compress"] = "auto";
  } else if (bake.compress.clusters > 0) {
    json["compress"] = {{"clusters", bake.compress.clusters}, {"vectors", bake.compress.vectors}};
  }
  return json;
}

// The runs of marked vertices: [first, behind the last).
Json to_runs(const std::vector<std::uint8_t>& marks) {
  Json runs = Json::array();
  for (auto first = std::find(marks.begin(), marks.end(), 1); first != marks.end();) {
    const auto last = std::find(first, marks.end(), 0);
    runs.push_back({first - marks.begin(), last - marks.begin()});
    first = std::find(last, marks.end(), 1);
  }
  return runs;
}

template <class Whole>
Whole whole_from(const nlohmann::json& json, Whole least = 0) {
  return whole_number<Whole>(json, "a plan with", least);
}

std::vector<std::uint8_t> from_runs(const nlohmann::json& runs, std::size_t count) {
  std::vector<std::uint8_t> marks(count, 0);
  for (const nlohmann::json& run : runs) {
    const auto first = whole_from<std::size_t>(run.at(0));
    const auto last = whole_from<std::size_t>(run.at(1));
    if (first > last || last > count) throw std::invalid_argument("vertices that the mesh does not have");
    std::fill(marks.begin() + static_cast<std::ptrdiff_t>(first), marks.begin() + static_cast<std::ptrdiff_t>(last), 1);
  }
  return marks;
}

LightCoefficients light_from(const nlohmann::json& json, int least) {
  LightCoefficients light{least, json.get<std::vector<double>>()};
  while (light.degree < kMaxDegree && light.values.size() > 3 * light.bands_squared()) ++light.degree;
  if (light.values.size() != 3 * light.bands_squared()) throw std::invalid_argument("a light of no degree");
  return light;
}

ClusterCounts counts_from(const nlohmann::json& json) {
  const ClusterCounts counts{whole_from<std::uint32_t>(json.at(0)), whole_from<std::uint32_t>(json.at(1))};
  if (counts.clusters < 1 || counts.clusters > kMostClusters || counts.vectors > kMostVectors) {
    throw std::invalid_argument("counts of no clusters");
  }
  return counts;
}

// What a bake takes for granted of a plan.
void check(const Plan& plan, const BakeOptions& bake) {
  const bool has_decision = std::any_of(plan.record.decisions.begin(), plan.record.decisions.end(),
                                        [](const Decision& decision) { return decision.name == kClustersDecision; });
  if (!plan.clusters.empty() && !(has_decision && plan.reference > 0.0)) {
    throw std::invalid_argument("clusters without a decision");
  }
  if (plan.storage.element == Element::kByte && plan.largest.size() != bake.kind->shape(bake.degree).count()) {
    throw std::invalid_argument("bytes of another count of numbers");
  }
}

Plan plan_from(const std::string& file, const nlohmann::json& json, Mesh& mesh, BakeOptions& bake) {
  bake = read_bake_options(JsonReader(file, json.at("bake")));
  Plan plan;
  plan.record = plan_record_from(json);
  if (json.contains("receivers")) {
    plan.receivers = from_runs(json["receivers"], mesh.positions.size());
    keep_vertices(mesh, plan.receivers);
  }
  if (json.contains("open")) plan.open = from_runs(json["open"], mesh.positions.size());
  plan.storage = storage_from(json.at("storage"), bake.kind->shape(bake.degree).columns());
  plan.largest = json.at("largest").get<std::vector<float>>();
  for (const nlohmann::json& counts : json.at("clusters")) plan.clusters.push_back(counts_from(counts));
  for (const nlohmann::json& light : json.at("lights")) plan.lights.push_back(light_from(light, bake.degree));
  if (json.contains("known_by")) plan.known_by = json["known_by"].get<std::string>();
  plan.reference = json.at("reference_radiance").get<double>();
  plan.beyond = json.at("beyond_asked_degree").get<double>();
  const auto cost_of = [&](const char* which) {
    return PlanCost{whole_from<std::int64_t>(json.at("bytes").at(which)),
                    whole_from<std::int64_t>(json.at("rays").at(which))};
  };
  plan.asked = cost_of("asked");
  plan.planned = cost_of("planned");
  check(plan, bake);
  return plan;
}

}  // namespace

std::string plan_checksum(nlohmann::json plan) {
  plan.erase(kChecksumKey);
  const std::string text = plan.dump();
  return checksum_text(checksum(text.data(), text.size()));
}

void write_plan(const std::string& file, const Plan& plan, const Scene& scene, const std::string& mesh) {
  Json json = {{kVersionKey, kVersion}, {"mesh", mesh}};
  json.update(Json::parse(plan_json(plan, scene)));
  json["bake"] = to_json(scene.bake);
  if (!plan.known_by.empty()) json["known_by"] = plan.known_by;
  if (!plan.receivers.empty()) json["receivers"] = to_runs(plan.receivers);
  if (!plan.open.empty()) json["open"] = to_runs(plan.open);
  json["largest"] = plan.largest;
  json["clusters"] = Json::array();
  for (const ClusterCounts& counts : plan.clusters) json["clusters"].push_back({counts.clusters, counts.vectors});
  json["lights"] = Json::array();
  for (const LightCoefficients& light : plan.lights) json["lights"].push_back(light.values);
  if (plan.record.budget > 0.0) json["light"] = light_of(scene);
  json[kChecksumKey] = plan_checksum(nlohmann::json::parse(json.dump()));
  output::write_file(file, json.dump(1) + "\n");
}

Plan read_plan(const std::string& file, Scene& scene) {
  const nlohmann::json json = read_json(file);
  if (!json.contains(kVersionKey)) refuse(file, "no plan");
  if (json[kVersionKey] != kVersion) {
    refuse(file, fmt::format("a plan of version {}, not {}", json[kVersionKey].dump(), kVersion));
  }
  if (!json.contains(kChecksumKey) || json[kChecksumKey] != plan_checksum(json)) refuse(file, "damaged or edited");
  Plan plan;
  BakeOptions bake;
  try {
    if (json.at("mesh") != checksums_of(scene.mesh).whole) {
      throw std::runtime_error(fmt::format(
          "{}: a plan for another mesh than that of {}; expected one of `prt plan` for this scene", file, scene.name));
    }
    plan = plan_from(file, json, scene.mesh, bake);
  } catch (const nlohmann::json::exception&) {
    refuse(file, "damaged");
  } catch (const std::invalid_argument& error) {
    refuse(file, fmt::format("damaged ({})", error.what()));
  }
  const bool is_lossy = plan.record.budget > 0.0;
  if (is_lossy && !is_same_light(json.value("light", std::vector<double>()), light_of(scene))) {
    throw std::runtime_error(fmt::format(
        "{}: its errors hold for other lights than those of {}; expected a plan for these lights", file, scene.name));
  }
  scene.bake = bake;
  scene.plan.mode = is_lossy ? PlanMode::kLossy : PlanMode::kExact;
  return plan;
}

}  // namespace sh::prt
