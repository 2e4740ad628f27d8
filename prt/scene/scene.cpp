#include "prt/scene/scene.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "prt/basis.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/rays/directions.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

constexpr double kFarthestGround = 1e6;  // extents of the meshes; single precision separates no triangles beyond

}  // namespace

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
  turn.degrees = static_cast<float>(reader.at("degrees").degrees(-kMostTurn, kMostTurn));
  return turn;
}

Ground read_ground(const JsonReader& reader, const Mesh& mesh) {
  reader.allow({"height", "size", "max_edge", "albedo"});
  Ground ground = default_ground(mesh);
  // Lengths of the world in the frame of the mesh.
  const auto limit = static_cast<double>(bounding_box(mesh.positions).sizes().norm()) * kFarthestGround;
  const std::string farthest =
      fmt::format("at most {:.4g}, a million times the extent of the meshes", limit * mesh.frame.unit);
  const auto length = [&](const JsonReader& value) { return static_cast<double>(value.positive()) / mesh.frame.unit; };
  reader.take("height", ground.height, [&](const JsonReader& value) {
    const double height = (value.real() - mesh.frame.origin.z()) / mesh.frame.unit;
    if (!(std::abs(height) <= limit)) value.expected("a distance from the meshes of " + farthest);
    return height;
  });
  reader.take("size", ground.size, [&](const JsonReader& value) {
    if (!(length(value) <= limit)) value.expected("a length of " + farthest);
    return length(value);
  });
  reader.take("max_edge", ground.max_edge, length);
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
  reader.take("position", camera.position, &JsonReader::point);
  reader.take("target", camera.target, &JsonReader::point);
  reader.take("up", camera.up, &JsonReader::point);
  reader.take("field_of_view", camera.vertical_field_of_view, &JsonReader::number, 1.0, 170.0, "degrees from 1 to 170");
  const Eigen::Vector3d view = camera.target - camera.position;
  if (!(view.norm() > 0.0) || !(view.normalized().cross(camera.up.normalized()).norm() > 1e-4)) {
    reader.expected("a target away from the position and an `up` that is not along the view");
  }
  return camera;
}

namespace {

KeptBands read_kept_bands(const JsonReader& reader) {
  reader.allow({"visibility", "result", "light"});
  KeptBands kept;
  reader.take("visibility", kept.visibility, &JsonReader::integer, 0, 2 * kHighestProduct);
  reader.take("result", kept.result, &JsonReader::integer, 0, kHighestProduct);
  reader.take("light", kept.light, &JsonReader::integer, 0, kHighestProduct);
  return kept;
}

}  // namespace

BakeOptions read_bake_options(const JsonReader& reader) {
  reader.allow({"degree", "directions", "sampler", "seed", "transfer", "tolerance", "bounce_directions", "keep",
                "compress", "fit_lobes"});
  BakeOptions options;
  reader.take("degree", options.degree, &JsonReader::integer, 0, kMaxDegree);
  reader.take("directions", options.directions, &JsonReader::integer, 1, kMaxDirections);
  reader.take_word("sampler", options.sampler, kSamplerNames);
  reader.take("seed", options.seed, &JsonReader::integer, 0, kMaxSeed);
  reader.take("tolerance", options.bounces.tolerance, &JsonReader::number, 1e-9, 1.0, "a number from 1e-9 to 1");
  reader.take("bounce_directions", options.bounces.directions, &JsonReader::integer, 1, kMaxDirections);
  reader.take("transfer", options.kind, [](const JsonReader& value) {
    return find_kind(&TransferKind::word, value.one_of(kind_names(&TransferKind::word)));
  });
  reader.take("fit_lobes", options.fit_lobes, &JsonReader::boolean);
  reader.take("keep", options.keep, read_kept_bands);
  reader.take("compress", options.compress, [&](const JsonReader& value) {
    options.compress_by_plan = value.is("string");
    if (options.compress_by_plan) {
      static_cast<void>(value.one_of({"auto"}));
      return ClusterCounts();
    }
    value.allow({"clusters", "vectors"});
    return ClusterCounts{static_cast<std::uint32_t>(value.at("clusters").integer(1, kMostClusters)),
                         static_cast<std::uint32_t>(value.at("vectors").integer(0, kMostVectors))};
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

namespace {

// The scene of a mesh file alone.
nlohmann::json around_mesh(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return {{"meshes", nlohmann::json::array({{{"file", name}}})}, {"ground", nlohmann::json::object()}};
}

std::vector<std::string> files_of(const std::string& scene, const std::string& folder, const JsonReader& meshes,
                                  const std::vector<LightSpec>& lights) {
  std::vector<std::string> files{scene};
  for (const JsonReader& mesh : meshes.items()) {
    if (const auto file = mesh.find("file")) files.push_back(beside(folder, file->text()));
    for (const JsonReader& material : material_readers(mesh)) {
      for (const char* key : {"brdf", "normal_map"}) {
        if (const auto file = material.find(key)) files.push_back(beside(folder, file->text()));
      }
    }
  }
  for (const LightSpec& light : lights) {
    if (!light.file.empty()) files.push_back(light.file);
  }
  return files;
}

BakeOptions read_medium_bake(const JsonReader& reader) {
  reader.allow({"degree", "directions", "tolerance"});
  BakeOptions options = read_bake_options(reader);
  if (!reader.find("directions")) options.directions = kMediumDirections;
  return options;
}

// A medium stands alone: no light goes between it and meshes.
Scene load_medium(const std::string& scene, const JsonReader& reader, const std::string& folder) {
  reader.allow({"name", "medium", "lights", "camera", "bake"});
  Scene result;
  result.name = std::filesystem::path(scene).stem().string();
  reader.take("name", result.name, &JsonReader::text);
  result.lights = read_lights(reader, folder);
  result.bake.directions = kMediumDirections;
  if (const auto bake = reader.find("bake")) result.bake = read_medium_bake(*bake);
  result.medium = read_medium(reader.at("medium"), folder);
  result.camera = default_camera(result.medium->extinction.support(), PictureSize());
  reader.take("camera", result.camera, read_camera, result.camera);
  result.files = {scene};
  if (!result.medium->file.empty()) result.files.push_back(result.medium->file);
  for (const LightSpec& light : result.lights) {
    if (!light.file.empty()) result.files.push_back(light.file);
  }
  return result;
}

}  // namespace

Scene load_scene(const std::string& scene, OnFlaw on_flaw) {
  if (scene == "demo" || scene == "disc") {
    Scene made = scene == "demo" ? make_embedded_scene() : make_disc_scene();
    made.plan.mode = PlanMode::kExact;
    return made;
  }
  const nlohmann::json document = has_mesh_name(scene) ? around_mesh(scene) : read_json(scene);
  const JsonReader reader(scene, document);
  const std::string folder = std::filesystem::path(scene).parent_path().string();
  Scene result;
  if (reader.find("medium")) return load_medium(scene, reader, folder);
  reader.allow({"name", "meshes", "medium", "ground", "lights", "camera", "bake", "plan"});
  result.plan.mode = PlanMode::kExact;
  result.name = std::filesystem::path(scene).stem().string();
  reader.take("name", result.name, &JsonReader::text);
  const JsonReader meshes = reader.at("meshes");
  if (meshes.items().empty()) meshes.expected("at least one mesh");
  // The short parts come first, so that a typing error in them is found before large meshes are loaded.
  result.lights = read_lights(reader, folder);
  reader.take("bake", result.bake, read_bake_options);
  reader.take("plan", result.plan, read_plan_options);
  std::vector<MeshPart> parts;
  Eigen::AlignedBox3d box;
  Shapes shapes(meshes);
  for (const JsonReader& mesh : meshes.items()) {
    parts.push_back(read_mesh(mesh, folder, on_flaw, shapes));
    for (Finish& finish : parts.back().soup.finishes) {
      if (finish.translucence) finish.translucence->body = static_cast<std::uint32_t>(parts.size());
    }
    if (result.normal_map_entry.empty()) result.normal_map_entry = parts.back().normal_map_entry;
    box.extend(bounding_box(parts.back().soup.positions));
  }
  result.mesh.frame = frame_around(box, scene);
  for (MeshPart& part : parts) append(result.mesh, finish_mesh(std::move(part), result.mesh.frame, on_flaw));
  result.camera = default_camera(result.mesh, PictureSize());
  reader.take("camera", result.camera, read_camera, result.camera);
  result.files = files_of(scene, folder, meshes, result.lights);
  if (const auto ground = reader.find("ground")) add_ground(result.mesh, read_ground(*ground, result.mesh));
  return result;
}

}  // namespace sh::prt
