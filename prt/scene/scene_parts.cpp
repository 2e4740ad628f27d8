#include "prt/scene/scene_parts.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "prt/mesh/import_mesh.hpp"
#include "prt/mesh/primitives.hpp"
#include "prt/mesh/sides.hpp"
#include "prt/mesh/tessellate.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/rays/directions.hpp"

namespace sh::prt {

namespace {

constexpr float kDefaultCrease = 40.0F;  // degrees
constexpr int kMaxSegments = 4096;

Eigen::Vector3f read_scale(const JsonReader& reader) {
  return reader.is_array() ? reader.vector() : Eigen::Vector3f::Constant(reader.finite());
}

// Scaled first, then turned, then moved.
Eigen::Affine3f read_transform(const JsonReader& reader) {
  reader.allow({"translate", "rotate", "scale"});
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  if (const auto translate = reader.find("translate")) map.translate(translate->vector());
  if (const auto rotate = reader.find("rotate")) {
    const Turn turn = read_turn(*rotate);
    map.rotate(Eigen::AngleAxisf(turn.degrees * std::numbers::pi_v<float> / 180.0F, turn.axis));
  }
  if (const auto scale = reader.find("scale")) {
    const Eigen::Vector3f factors = read_scale(*scale);
    if (!(factors.cwiseAbs().minCoeff() > 0.0F)) scale->expected("factors that are not zero");
    map.scale(factors);
  }
  return map;
}

// (x, y, z) with y up becomes (x, -z, y).
Eigen::Affine3f stand_up() {
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  map.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return map;
}

ImportedMesh read_shape(const JsonReader& reader, const std::string& folder, const MaterialChanges& changes) {
  const auto file = reader.find("file");
  const auto primitive = reader.find("primitive");
  if (file.has_value() == primitive.has_value()) reader.expected("either `file` or `primitive`");
  if (file) return import_mesh(beside(folder, file->text()), changes);
  const auto segments = reader.find("segments");
  ImportedMesh shape;
  shape.soup =
      make_primitive(primitive->one_of({"arch", "box", "cone", "cylinder", "plane", "sphere", "stairs", "torus"}),
                     segments ? segments->integer(3, kMaxSegments) : 48);
  shape.file_vertices = shape.soup.positions.size();
  const MaterialChange& change = changes.all;
  if (change.reflection) {
    shape.soup.albedo.assign(shape.soup.positions.size(), change.reflection->albedo);
    shape.soup.finishes[0].mirror = change.reflection->mirror;
  }
  shape.soup.finishes[0].emission = change.emission.value_or(Eigen::Vector3f::Zero());
  shape.soup.finishes[0].is_two_sided = change.is_two_sided.value_or(false);
  return shape;
}

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
  turn.degrees = reader.at("degrees").finite();
  return turn;
}

Mesh finish_mesh(Soup soup, std::size_t file_vertices, float crease_degrees, float max_edge, const std::string& name,
                 OnFlaw on_flaw) {
  check(soup, name);
  const std::size_t all = soup.faces.size();
  if (const std::size_t dropped = drop_faces_without_area(soup); dropped > 0) {
    if (soup.faces.empty()) throw std::runtime_error(fmt::format("{}: none of the {} faces has an area", name, all));
    report_flaw(on_flaw, fmt::format("{}: {} of {} faces have no area (dropped)", name, dropped, all));
  }
  if (const std::size_t made = complete_normals(soup, crease_degrees); made > 0) {
    report_flaw(on_flaw, fmt::format("{}: {} vertex normals are zero or not finite (made from the faces)", name, made));
  }
  if (const std::size_t turned = turn_faces_to_normals(soup); turned > 0) {
    report_flaw(on_flaw, fmt::format("{}: {} of {} faces are wound against their normals (turned)", name, turned,
                                     soup.faces.size()));
  }
  Mesh mesh = weld(soup, file_vertices);
  std::vector<std::uint32_t> origins(mesh.faces.size());
  std::iota(origins.begin(), origins.end(), 0U);
  if (max_edge > 0.0F) {
    origins = tessellate(
        mesh, [&](const Eigen::Vector3f&) { return max_edge; }, name);
  }
  std::vector<std::uint8_t> is_two_sided;
  for (const std::uint32_t face : origins) {
    is_two_sided.push_back(soup.finishes[soup.finish_of(face)].is_two_sided ? 1 : 0);
  }
  if (std::count(is_two_sided.begin(), is_two_sided.end(), 1) > 0) add_backs(mesh, is_two_sided);
  return mesh;
}

Mesh read_mesh(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw) {
  reader.allow({"file", "primitive", "segments", "transform", "up", "albedo", "mirror", "emission", "sides",
                "materials", "max_edge", "crease", "flip"});
  const MaterialChanges changes = read_materials(reader);
  const auto up = reader.find("up");
  const auto max_edge = reader.find("max_edge");
  const auto crease = reader.find("crease");
  const float edge = max_edge ? max_edge->positive() : 0.0F;
  const float crease_degrees =
      crease ? static_cast<float>(crease->number(0.0, 180.0, "degrees from 0 to 180")) : kDefaultCrease;
  const auto placing = reader.find("transform");
  const Eigen::Affine3f map = placing ? read_transform(*placing) : Eigen::Affine3f::Identity();
  const UpAxis wanted = up && up->one_of({"y", "z"}) == "y" ? UpAxis::kY : UpAxis::kZ;
  ImportedMesh shape = read_shape(reader, folder, changes);
  check_material_names(reader, shape.materials);
  const auto flip = reader.find("flip");
  const bool is_flipped = flip && flip->boolean();
  const auto file = reader.find("file");
  const std::string name = file ? beside(folder, file->text()) : reader.find("primitive")->text();
  check(shape.soup, name);
  transform(shape.soup, (up ? wanted : shape.up) == UpAxis::kY ? map * stand_up() : map);
  if (is_flipped) turn_inside_out(shape.soup);
  return finish_mesh(std::move(shape.soup), shape.file_vertices, crease_degrees, edge, name, on_flaw);
}

Ground read_ground(const JsonReader& reader, const Mesh& mesh) {
  reader.allow({"height", "size", "max_edge", "albedo"});
  Ground ground = default_ground(mesh);
  reader.take("height", ground.height, &JsonReader::finite);
  reader.take("size", ground.size, &JsonReader::positive);
  reader.take("max_edge", ground.max_edge, &JsonReader::positive);
  reader.take("albedo", ground.albedo, [](const JsonReader& value) { return value.vector(0.0F, 1.0F); });
  return ground;
}

Camera read_camera(const JsonReader& reader, const Camera& otherwise) {
  reader.allow({"position", "target", "up", "field_of_view"});
  Camera camera = otherwise;
  reader.take("position", camera.position, [](const JsonReader& value) { return value.vector(); });
  reader.take("target", camera.target, [](const JsonReader& value) { return value.vector(); });
  reader.take("up", camera.up, [](const JsonReader& value) { return value.vector(); });
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
  reader.take("sampler", options.sampler, [](const JsonReader& value) {
    return *sampler_called(value.one_of({kSamplerNames.begin(), kSamplerNames.end()}));
  });
  reader.take("seed", options.seed, &JsonReader::integer, 0, kMaxSeed);
  reader.take("tolerance", options.bounces.tolerance, &JsonReader::number, 1e-9, 1.0, "a number from 1e-9 to 1");
  reader.take("transfer", options.kind,
              [](const JsonReader& value) { return kind_called(value.one_of(kind_words())); });
  return options;
}

PlanOptions read_plan_options(const JsonReader& reader) {
  reader.allow({"error", "light_turns", "without"});
  PlanOptions options;
  options.mode = PlanMode::kLossy;
  reader.take("error", options.error, &JsonReader::number, 1e-9, 1.0, "a number from 1e-9 to 1");
  reader.take("light_turns", options.turns, [](const JsonReader& value) {
    return *turns_called(value.one_of({kLightTurnsNames.begin(), kLightTurnsNames.end()}));
  });
  if (const auto without = reader.find("without")) {
    for (const JsonReader& name : without->items()) {
      options.without.push_back(name.one_of({kDecisionNames.begin(), kDecisionNames.end()}));
    }
  }
  return options;
}

}  // namespace sh::prt
