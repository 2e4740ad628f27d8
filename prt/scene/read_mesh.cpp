// Reads one mesh of a scene file, with the scene's changes to its materials.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "prt/mesh/import_mesh.hpp"
#include "prt/mesh/primitives.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

constexpr float kDefaultCrease = 40.0F;  // degrees
constexpr int kMaxSegments = 4096;

Eigen::Vector3f read_scale(const JsonReader& reader) {
  return reader.is("array") ? reader.vector() : Eigen::Vector3f::Constant(reader.finite());
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
  shape.soup = make_primitive(primitive->one_of(primitive_names()), segments ? segments->integer(3, kMaxSegments) : 48);
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

// A mirror has no albedo unless the scene gives one.
std::optional<Reflection> read_reflection(const JsonReader& reader) {
  const auto albedo = reader.find("albedo");
  const auto mirror = reader.find("mirror");
  if (!albedo && !mirror) return std::nullopt;
  Reflection reflection;
  if (albedo) reflection.albedo = albedo->vector_within(0.0F, 1.0F);
  if (mirror) reflection.mirror = mirror->vector_within(0.0F, 1.0F);
  constexpr float kRounding = 1e-6F;
  if (mirror && (reflection.albedo + reflection.mirror).maxCoeff() > 1.0F + kRounding) {
    mirror->expected("a reflectance that is at most 1 together with the albedo");
  }
  return reflection;
}

MaterialChange read_material(const JsonReader& reader) {
  MaterialChange change;
  change.reflection = read_reflection(reader);
  reader.take("emission", change.emission, &JsonReader::vector_within, 0.0F, std::numeric_limits<float>::max());
  reader.take("sides", change.is_two_sided, [](const JsonReader& value) { return value.integer(1, 2) == 2; });
  return change;
}

MaterialChanges read_materials(const JsonReader& mesh) {
  MaterialChanges changes;
  changes.all = read_material(mesh);
  if (const auto materials = mesh.find("materials")) {
    for (const auto& [name, material] : materials->members()) {
      material.allow({"albedo", "emission", "mirror", "sides"});
      changes.by_name[name] = read_material(material);
    }
  }
  return changes;
}

void check_material_names(const JsonReader& mesh, const std::vector<std::string>& known) {
  const auto materials = mesh.find("materials");
  if (!materials) return;
  for (const auto& [name, material] : materials->members()) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      material.expected(known.empty()
                            ? std::string("no `materials`: the mesh has none")
                            : fmt::format("the name of one of the mesh's materials ({})", fmt::join(known, ", ")));
    }
  }
}

}  // namespace

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
  float edge = 0.0F;
  float crease = kDefaultCrease;
  Eigen::Affine3f map = Eigen::Affine3f::Identity();
  std::optional<UpAxis> up;
  bool is_flipped = false;
  reader.take("max_edge", edge, &JsonReader::positive);
  reader.take("crease", crease, &JsonReader::number, 0.0, 180.0, "degrees from 0 to 180");
  reader.take("transform", map, read_transform);
  reader.take("up", up, [](const JsonReader& value) {
    return value.one_of({"y", "z"}) == "y" ? UpAxis::kY : UpAxis::kZ;
  });
  ImportedMesh shape = read_shape(reader, folder, changes);
  check_material_names(reader, shape.materials);
  reader.take("flip", is_flipped, &JsonReader::boolean);
  const auto file = reader.find("file");
  const std::string name = file ? beside(folder, file->text()) : reader.at("primitive").text();
  for (const std::string& line : shape.unread) report_flaw(on_flaw, fmt::format("{}: {}", name, line));
  check(shape.soup, name);
  transform(shape.soup, up.value_or(shape.up) == UpAxis::kY ? map * stand_up() : map);
  if (is_flipped) turn_inside_out(shape.soup);
  return finish_mesh(std::move(shape.soup), shape.file_vertices, crease, edge, name, on_flaw);
}

}  // namespace sh::prt
