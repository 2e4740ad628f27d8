// Readers of text that people write: scenes, stages, their parts, tables of numbers.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "numeric/identify/identify.hpp"
#include "numeric/identify/rotation_check.hpp"
#include "numeric/output/parse_json.hpp"
#include "prt/bake/bake.hpp"
#include "prt/light/light.hpp"
#include "prt/mesh/mesh_checksum.hpp"
#include "prt/plan/plan_file.hpp"
#include "prt/scene/scene.hpp"
#include "prt/scene/scene_parts.hpp"
#include "prt/scene/stage.hpp"
#include "tests/fuzz/entry.hpp"
#include "tests/prt/meshes.hpp"
#include "tests/prt/temporary_folder.hpp"

namespace sh::fuzz {
namespace {

using namespace sh::prt;
using Json = nlohmann::json;

constexpr std::size_t kMostCells = 600;  // that get an answer

// Whether the counts of a grid are no numbers, or few in all.
bool has_few(const Json& counts) {
  double product = 1.0;
  for (const Json& count : counts) product *= count.is_number() ? count.get<double>() : 1.0;
  return !(product > 4096.0);
}

// Whether a scene has few vertices and voxels: sizes are asked for, and fine meshes only take time.
bool is_small(const Json& json) {
  if (json.is_structured()) {
    for (const auto& [key, value] : json.items()) {
      const double number = value.is_number() ? value.get<double>() : 1.0;
      if (key == "max_edge" && number < 0.2) return false;
      if (key == "segments" && number > 40) return false;
      if ((key == "scale" || key == "size") && !(std::abs(number) < 20)) return false;
      if (key == "scale" && value.is_array()) return false;
      if (key == "counts" && value.is_array() && value.size() == 3 && !has_few(value)) return false;
      if (!is_small(value)) return false;
    }
  }
  return true;
}

void read_scene(const std::string& file) {
  const Json json = read_json(file);
  if (json.dump().size() > 4000 || !is_small(json)) return;
  const Scene scene = load_scene(file, OnFlaw::kMend);
  require(scene.medium.has_value() != !scene.mesh.faces.empty(), "a scene has faces or a medium");
  for (const Eigen::Vector3f& position : scene.mesh.positions) require(position.allFinite(), "positions are finite");
  for (const Eigen::Vector3f& normal : scene.mesh.normals) {
    require(std::abs(normal.norm() - 1.0F) < 1e-3F, "normals have length 1");
  }
}

void read_stage(const std::string& file) {
  const Stage stage = load_stage(file, std::string(SHFORGE_SOURCE_DIR) + "/tests/data/transfer_v1");
  require(!stage.objects.empty(), "a stage has an object");
  for (const StageObject& object : stage.objects) {
    for (const double time : {0.0, 0.3, 1.0}) {
      require(object.motion.at(time).rotation.allFinite(), "poses are finite");
    }
  }
}

void light(const JsonReader& reader) {
  const LightSpec spec = read_light(reader, "/");
  if (spec.type == LightType::kEnvironment) return;
  const LightCoefficients coefficients = project(load_lights({spec}, OnFlaw::kMend), 2);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  require(std::all_of(coefficients.values.begin(), coefficients.values.end(), is_finite), "coefficients are finite");
}

// Each part under the key that it has in a scene.
void read_parts(const std::string& file) {
  const Json json = read_json(file);
  const JsonReader reader(file, json);
  reader.allow({"bake", "plan", "camera", "lights"});
  if (const auto bake = reader.find("bake")) read_bake_options(*bake);
  if (const auto plan = reader.find("plan")) read_plan_options(*plan);
  if (const auto camera = reader.find("camera")) read_camera(*camera, Camera());
  for (const JsonReader& item : reader.items("lights")) light(item);
}

// A plan for another mesh, or with a wrong checksum, is refused before anything else is read.
void follow_plan(const std::string& file) {
  Json json = read_json(file);
  Scene scene;
  scene.mesh = prt::test::primitive_mesh("plane");
  if (json.is_object() && json.contains("mesh") && json.contains("checksum")) {
    json["mesh"] = checksums_of(scene.mesh).whole;
    json["checksum"] = plan_checksum(json);
    prt::test::write_all(file, json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  BakeJob job(std::move(scene), {.threads = 1});
  job.plan = read_plan(file, job.scene);
  const BakeOptions& options = job.scene.bake;
  if (options.degree > 3 || options.directions > 64 || options.kind->indirect != nullptr) return;
  try {
    const Transfer transfer = bake(std::move(job));
    require(transfer.receivers() == 4, "a bake follows the plan");
  } catch (const std::invalid_argument& error) {  // options that do not fit together
    require_one_line(error.what());
  }
}

template <class Check>
void check_table(const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    require_one_line(error.what());
  }
}

void read_table(const std::string& file) {
  const auto table = numeric::identify::read_table(file);
  require(!table.rows.empty(), "a table has a row");
  check_table([&] {
    for (const auto& way : numeric::identify::read_samples(table, true)) {
      require(!way.columns.empty() && way.columns.front().size() == table.rows.size(), "every row has values");
    }
  });
  check_table([&] {
    require(!numeric::identify::read_rotation_cases(table).cases.empty(), "a table of rotations has a rotation");
  });
}

void identify(const std::string& file) {
  const auto table = numeric::identify::read_table(file);
  if (table.rows.size() * table.rows.front().cells.size() > kMostCells) return;
  check_table([&] {
    const auto result = numeric::identify::identify(numeric::identify::read_samples(table, false));
    require(!format_text(result, false).empty(), "an answer has a text");
    output::parse_json<Json>(format_json(result));
  });
  check_table([&] {
    const auto result = numeric::identify::check_rotations(numeric::identify::read_rotation_cases(table), 0);
    output::parse_json<Json>(format_json(result));
  });
}

}  // namespace

void run_scene(std::string_view bytes) { run_reader(read_scene, bytes); }
void run_stage(std::string_view bytes) { run_reader(read_stage, bytes); }
void run_parts(std::string_view bytes) { run_reader(read_parts, bytes); }
void run_plan(std::string_view bytes) { run_reader(follow_plan, bytes); }
void run_table(std::string_view bytes) { run_reader(read_table, bytes); }
void run_identify(std::string_view bytes) { run_reader(identify, bytes); }

}  // namespace sh::fuzz
