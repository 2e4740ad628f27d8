#include "prt/scene/stage.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "prt/kinds/kinds.hpp"
#include "prt/light/light_coefficients.hpp"
#include "prt/scene/json_reader.hpp"
#include "prt/scene/scene_parts.hpp"
#include "prt/transfer/transfer_file.hpp"

namespace sh::prt {
namespace {

/// A key takes missing entries from the object.
Motion::Key read_key(const JsonReader& reader, const Motion::Key& otherwise) {
  reader.allow({"time", "position", "degrees"});
  Motion::Key key = otherwise;
  key.time = reader.at("time").number(0.0, 1.0, "a number from 0 to 1");
  reader.take("position", key.position, &JsonReader::point);
  reader.take("degrees", key.degrees, &JsonReader::degrees, -kMostTurn, kMostTurn);
  return key;
}

Motion read_motion(const JsonReader& object) {
  Motion motion;
  Motion::Key& rest = motion.keys.front();
  object.take("position", rest.position, &JsonReader::point);
  if (const auto rotate = object.find("rotate")) {
    const Turn turn = read_turn(*rotate);
    motion.axis = turn.axis.cast<double>().normalized();
    rest.degrees = static_cast<double>(turn.degrees);
  }
  const auto keys = object.find("move");
  if (!keys) return motion;
  const Motion::Key otherwise = rest;
  motion.keys.clear();
  for (const JsonReader& item : keys->items()) {
    motion.keys.push_back(read_key(item, otherwise));
    if (motion.keys.size() > 1 && !(motion.keys.back().time > motion.keys[motion.keys.size() - 2].time)) {
      item.at("time").expected("a time after that of the key before");
    }
  }
  if (motion.keys.empty()) keys->expected("at least one key");
  return motion;
}

Sphere read_proxy(const JsonReader& reader, const Sphere& otherwise) {
  reader.allow({"center", "radius"});
  Sphere sphere = otherwise;
  reader.take("center", sphere.center, &JsonReader::point);
  reader.take("radius", sphere.radius, &JsonReader::number, 0.0, 1e30, "a number of 0 or more");
  return sphere;
}

/// Transfer files, each read once.
struct Transfers {
  using Files = std::map<std::string, std::shared_ptr<const Transfer>>;
  Files surfaces;
  Files media;
  Files volumes;
};

std::shared_ptr<const Transfer> read_once(const std::string& file, TransferKinds kinds, Transfers::Files& known) {
  auto& transfer = known[file];
  if (!transfer) transfer = std::make_shared<const Transfer>(read_transfer(file, kinds));
  return transfer;
}

StageObject read_object(const JsonReader& reader, const std::string& folder, Transfers& transfers) {
  reader.allow({"transfer", "volume", "position", "rotate", "move", "proxy", "light_at", "light_from"});
  StageObject object;
  object.name = reader.at("transfer").text();
  object.motion = read_motion(reader);
  const auto light_at = reader.find("light_at");
  object.per_vertex = light_at && light_at->one_of({"center", "vertices"}) == "vertices";
  object.file = beside(folder, object.name);
  const TransferKind* const kind = kind_of_file(object.file);
  const bool is_medium = kind != nullptr && kind->in_medium;
  object.transfer = is_medium ? read_once(object.file, medium_kinds(), transfers.media)
                              : read_once(object.file, surface_kinds(), transfers.surfaces);
  if (object.per_vertex && is_medium) light_at->expected("`center` for a medium, which has no vertices");
  if (object.per_vertex && (object.transfer->shape.channels != 1 || object.transfer->kind->stores_matrices())) {
    light_at->expected("`center` for transfer with bounces, which needs one light for the whole object");
  }
  if (const auto from = reader.find("light_from")) {
    object.from_scene = from->one_of({"sky", "scene"}) == "scene";
    if (object.from_scene && object.per_vertex) from->expected("`sky` beside `light_at` vertices");
  }
  if (const auto volume = reader.find("volume")) {
    object.volume_file = beside(folder, volume->text());
    object.volume = read_once(object.volume_file, volume_kinds(), transfers.volumes);
    if (!object.volume->kind->stores_visibility()) {
      volume->expected("the space around an object, of kind N or NI (`prt volume` makes it)");
    }
  }
  object.proxy = is_medium ? Sphere{object.transfer->grid->box.center(), 0.0} : bounding_sphere(object.transfer->mesh);
  reader.take("proxy", object.proxy, read_proxy, object.proxy);
  return object;
}

}  // namespace

Pose Motion::at(double time) const {
  const auto after = std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.time > time; });
  const Key& next = after == keys.end() ? keys.back() : *after;
  const Key& last = after == keys.begin() ? keys.front() : *std::prev(after);
  const double span = next.time - last.time;
  const double part = span > 0.0 ? (time - last.time) / span : 0.0;
  return {rotation_about(axis, last.degrees + part * (next.degrees - last.degrees)),
          last.position + part * (next.position - last.position)};
}

Sphere bounding_sphere(const Mesh& mesh) {
  Sphere sphere;
  if (mesh.positions.empty()) return sphere;
  sphere.center = mesh.frame.world(bounding_box(mesh.positions).center());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    sphere.radius = std::max(sphere.radius, (mesh.point(v) - sphere.center).norm());
  }
  return sphere;
}

Stage stage_of(Transfer transfer) {
  Stage stage;
  stage.name = transfer.scene;
  StageObject& object = stage.objects.emplace_back();
  object.name = transfer.scene;
  object.transfer = std::make_shared<const Transfer>(std::move(transfer));
  return stage;
}

Stage load_stage(const std::string& file, const std::string& transfers_folder) {
  const nlohmann::json document = read_json(file);
  const JsonReader reader(file, document);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  reader.allow({"name", "objects", "lights", "camera"});
  Stage stage;
  stage.name = std::filesystem::path(file).stem().string();
  reader.take("name", stage.name, &JsonReader::text);
  stage.lights = read_lights(reader, folder);
  reader.take("camera", stage.camera, read_camera, Camera());
  const JsonReader objects = reader.at("objects");
  Transfers transfers;
  for (const JsonReader& object : objects.items()) {
    stage.objects.push_back(read_object(object, transfers_folder.empty() ? folder : transfers_folder, transfers));
  }
  for (const auto* files : {&transfers.surfaces, &transfers.media, &transfers.volumes}) {
    for (const auto& [name, transfer] : *files) stage.files.push_back(name);
  }
  for (const LightSpec& light : stage.lights) stage.files.push_back(light.file);
  if (stage.objects.empty()) objects.expected("at least one object");
  if (transfers.surfaces.empty()) objects.expected("an object with surfaces; a medium alone needs no stage");
  return stage;
}

}  // namespace sh::prt
