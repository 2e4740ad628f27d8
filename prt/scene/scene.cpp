#include "prt/scene/scene.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "prt/mesh/weld.hpp"
#include "prt/scene/camera.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/scene/made_scenes.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {

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
  const auto name = reader.find("name");
  result.name = name ? name->text() : std::filesystem::path(scene).stem().string();
  const JsonReader meshes = reader.at("meshes");
  if (meshes.items().empty()) meshes.expected("at least one mesh");
  // The short parts come first, so that a typing error in them is found before large meshes are loaded.
  const auto lights = reader.find("lights");
  for (const JsonReader& light : lights ? lights->items() : std::vector<JsonReader>()) {
    result.lights.push_back(read_light(light, folder));
  }
  if (!lights) {
    result.lights.emplace_back();  // the CIE overcast sky
  }
  reader.take("bake", result.bake, read_bake_options);
  reader.take("plan", result.plan, read_plan_options);
  for (const JsonReader& mesh : meshes.items()) append(result.mesh, read_mesh(mesh, folder, on_flaw));
  const auto camera = reader.find("camera");
  result.camera = default_camera(result.mesh, PictureSize());
  if (camera) result.camera = read_camera(*camera, result.camera);
  if (const auto ground = reader.find("ground")) add_ground(result.mesh, read_ground(*ground, result.mesh));
  return result;
}

}  // namespace sh::prt
