#include "prt/scene/scene.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "prt/mesh/weld.hpp"
#include "prt/rays/directions.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {

std::string beside(const std::string& folder, const std::string& file) {
  return (std::filesystem::path(folder) / file).lexically_normal().string();
}

Turn read_turn(const JsonReader& reader) {
  reader.allow({"axis", "degrees"});
  Turn turn;
  if (const auto axis = reader.find("axis")) {
    turn.axis = axis->vector();
    if (!(turn.axis.stableNorm() > 0.0F)) axis->expected("an axis that is not zero");
    turn.axis.stableNormalize();
  }
  turn.degrees = reader.at("degrees").finite();
  return turn;
}

Ground read_ground(const JsonReader& reader, const Mesh& mesh) {
  reader.allow({"height", "size", "max_edge", "albedo"});
  Ground ground = default_ground(mesh);
  reader.take("height", ground.height, &JsonReader::finite);
  reader.take("size", ground.size, &JsonReader::positive);
  reader.take("max_edge", ground.max_edge, &JsonReader::positive);
  reader.take("albedo", ground.albedo, &JsonReader::vector_within, 0.0F, 1.0F);
  return ground;
}

std::vector<LightSpec> read_lights(const JsonReader& reader, const std::string& folder) {
  if (!reader.find("lights")) return {LightSpec()};  // the CIE overcast sky
  std::vector<LightSpec> lights;
  for (const JsonReader& light : reader.items("lights")) lights.push_back(read_light(light, folder));
  return lights;
}

Camera read_camera(const JsonReader& reader, const Camera& otherwise) {
  reader.allow({"position", "target", "up", "field_of_view"});
  Camera camera = otherwise;
  reader.take("position", camera.position, &JsonReader::vector);
  reader.take("target", camera.target, &JsonReader::vector);
  reader.take("up", camera.up, &JsonReader::vector);
  reader.take("field_of_view", camera.vertical_field_of_view, &JsonReader::number, 1.0, 170.0, "degrees from 1 to 170");
  const Eigen::Vector3f view = camera.target - camera.position;
  if (!(view.norm() > 0.0F) || !(view.normalized().cross(camera.up.normalized()).norm() > 1e-4F)) {
    reader.expected("a target away from the position and an `up` that is not along the view");
  }
  return camera;
}

BakeOptions read_bake_options(const JsonReader& reader) {
  reader.allow({"degree", "directions", "sampler", "seed", "transfer", "tolerance"});
  BakeOptions options;
  reader.take("degree", options.degree, &JsonReader::integer, 0, kMaxDegree);
  reader.take("directions", options.directions, &JsonReader::integer, 1, kMaxDirections);
  reader.take_word("sampler", options.sampler, kSamplerNames);
  reader.take("seed", options.seed, &JsonReader::integer, 0, kMaxSeed);
  reader.take("tolerance", options.bounces.tolerance, &JsonReader::number, 1e-9, 1.0, "a number from 1e-9 to 1");
  reader.take("transfer", options.kind, [](const JsonReader& value) {
    return find_kind(&TransferKind::word, value.one_of(kind_names(&TransferKind::word)));
  });
  return options;
}

PlanOptions read_plan_options(const JsonReader& reader) {
  reader.allow({"error", "light_turns", "without"});
  PlanOptions options;
  options.mode = PlanMode::kLossy;
  reader.take("error", options.error, &JsonReader::number, 1e-9, 1.0, "a number from 1e-9 to 1");
  reader.take_word("light_turns", options.turns, kLightTurnsNames);
  for (const JsonReader& name : reader.items("without")) {
    options.without.push_back(name.one_of({kDecisionNames.begin(), kDecisionNames.end()}));
  }
  return options;
}

Scene load_scene(const std::string& scene, OnFlaw on_flaw) {
  if (scene == "demo" || scene == "disc") {
    Scene made = scene == "demo" ? make_embedded_scene() : make_disc_scene();
    made.plan.mode = PlanMode::kExact;
    return made;
  }
  const nlohmann::json document = read_json(scene);
  const JsonReader reader(scene, document);
  const std::string folder = std::filesystem::path(scene).parent_path().string();
  reader.allow({"name", "meshes", "ground", "lights", "camera", "bake", "plan"});
  Scene result;
  result.plan.mode = PlanMode::kExact;
  result.name = std::filesystem::path(scene).stem().string();
  reader.take("name", result.name, &JsonReader::text);
  const JsonReader meshes = reader.at("meshes");
  if (meshes.items().empty()) meshes.expected("at least one mesh");
  // The short parts come first, so that a typing error in them is found before large meshes are loaded.
  result.lights = read_lights(reader, folder);
  reader.take("bake", result.bake, read_bake_options);
  reader.take("plan", result.plan, read_plan_options);
  for (const JsonReader& mesh : meshes.items()) append(result.mesh, read_mesh(mesh, folder, on_flaw));
  result.camera = default_camera(result.mesh, PictureSize());
  reader.take("camera", result.camera, read_camera, result.camera);
  if (const auto ground = reader.find("ground")) add_ground(result.mesh, read_ground(*ground, result.mesh));
  return result;
}

}  // namespace sh::prt
