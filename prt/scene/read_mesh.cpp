// Reads one mesh of a scene file, with the scene's changes to its materials.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "prt/material/measured.hpp"
#include "prt/material/microfacet.hpp"
#include "prt/mesh/import_mesh.hpp"
#include "prt/mesh/primitives.hpp"
#include "prt/mesh/varied_materials.hpp"
#include "prt/mesh/weld.hpp"
#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

constexpr float kDefaultCrease = 40.0F;  // degrees
constexpr int kMaxSegments = 4096;
constexpr float kDefaultIor = 1.3F;

Eigen::Vector3d read_scale(const JsonReader& reader) {
  return reader.is("array") ? reader.point() : Eigen::Vector3d::Constant(reader.real());
}

// Scaled first, then turned, then moved.
Eigen::Affine3d read_transform(const JsonReader& reader) {
  reader.allow({"translate", "rotate", "scale"});
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  if (const auto translate = reader.find("translate")) map.translate(translate->point());
  if (const auto rotate = reader.find("rotate")) {
    const Turn turn = read_turn(*rotate);
    map.rotate(Eigen::AngleAxisd(static_cast<double>(turn.degrees) * std::numbers::pi / 180.0,
                                 turn.axis.cast<double>().normalized()));
  }
  if (const auto scale = reader.find("scale")) {
    const Eigen::Vector3d factors = read_scale(*scale);
    if (!(factors.cwiseAbs().minCoeff() > 0.0)) scale->expected("factors that are not zero");
    map.scale(factors);
  }
  return map;
}

// (x, y, z) with y up becomes (x, -z, y).
Eigen::Affine3d stand_up() {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
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
  shape.soup.chart = shape.soup.texture;
  shape.soup.nodes = {MeshNode{primitive->text(), {}}};
  shape.file_vertices = shape.soup.positions.size();
  const MaterialChange& change = changes.all;
  if (change.reflection) {
    shape.soup.albedo.assign(shape.soup.positions.size(), change.reflection->albedo);
    shape.soup.finishes[0].mirror = change.reflection->mirror;
  }
  shape.soup.finishes[0].gloss = change.gloss.value_or(Gloss());
  shape.soup.finishes[0].normal_map = change.normal_map;
  shape.soup.finishes[0].emission = change.emission.value_or(Eigen::Vector3f::Zero());
  shape.soup.finishes[0].translucence = change.translucence;
  shape.soup.finishes[0].is_two_sided = change.is_two_sided.value_or(false);
  return shape;
}

// A mirror and a body that lets light through have no albedo unless the scene gives one.
std::optional<Reflection> read_reflection(const JsonReader& reader) {
  const auto albedo = reader.find("albedo");
  const auto mirror = reader.find("mirror");
  if (!albedo && !mirror && !reader.find("translucent") && !reader.find("subsurface")) return std::nullopt;
  Reflection reflection;
  if (albedo) reflection.albedo = albedo->vector_within(0.0F, 1.0F);
  if (mirror) reflection.mirror = mirror->vector_within(0.0F, 1.0F);
  constexpr float kRounding = 1e-6F;
  if (mirror && (reflection.albedo + reflection.mirror).maxCoeff() > 1.0F + kRounding) {
    mirror->expected("a reflectance that is at most 1 together with the albedo");
  }
  return reflection;
}

std::optional<Gloss> read_gloss(const JsonReader& reader) {
  const auto specular = reader.find("specular");
  const auto exponent = reader.find("exponent");
  if (!specular && !exponent) return std::nullopt;
  if (!specular || !exponent) reader.expected("`specular` and `exponent` together");
  Gloss gloss;
  gloss.specular = specular->vector_within(0.0F, 1.0F);
  gloss.exponent = static_cast<float>(exponent->number(0.0, kMaxExponent, "an exponent from 0 to 1e6"));
  return gloss;
}

void require_alone(const JsonReader& reader, const std::string& name, const std::vector<std::string>& others) {
  for (const std::string& other : others) {
    if (reader.find(other)) reader.expected(fmt::format("`{}` or `{}`, not both", name, other));
  }
}

Gloss gloss_of(Reflectance brdf) {
  Gloss gloss;
  gloss.brdf = std::make_shared<Reflectance>(std::move(brdf));
  return gloss;
}

// The surface model of glTF over the albedo, or a file of a measured BRDF, which brings its own.
void read_brdf(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw, MaterialChange& change) {
  const auto roughness = reader.find("roughness");
  const auto metallic = reader.find("metallic");
  const auto measured = reader.find("brdf");
  if (metallic && !roughness) reader.expected("`roughness` beside `metallic`");
  if (roughness) {
    require_alone(reader, "roughness", {"specular", "brdf", "mirror"});
    const auto part = [](const JsonReader& value) {
      return static_cast<float>(value.number(0.0, 1.0, "a number from 0 to 1"));
    };
    change.gloss = gloss_of(microfacet_reflectance(part(*roughness), metallic ? part(*metallic) : 0.0F));
  }
  if (measured) {
    require_alone(reader, "brdf", {"albedo", "mirror", "specular"});
    MeasuredReflectance read = read_measured_reflectance(beside(folder, measured->text()));
    for (const std::string& flaw : read.flaws) report_flaw(on_flaw, fmt::format("{}: {}", read.reflectance.name, flaw));
    change.reflection = Reflection{.albedo = read.albedo};
    change.gloss = gloss_of(std::move(read.reflectance));
  }
}

// Rates of light in a body by color, 1 / unit.
Eigen::Vector3f read_rates(const JsonReader& reader, bool positive) {
  Eigen::Vector3f rates = reader.vector_within(0.0F, std::numeric_limits<float>::max());
  if (positive && !(rates.minCoeff() > 0.0F)) reader.expected("three positive numbers");
  return rates;
}

std::optional<Translucence> read_translucence(const JsonReader& reader) {
  const auto straight = reader.find("translucent");
  const auto scatters = reader.find("subsurface");
  if (!straight && !scatters) return std::nullopt;
  if (straight && scatters) reader.expected("`translucent` or `subsurface`, not both");
  Translucence material;
  if (straight) {
    straight->allow({"transmission", "extinction"});
    material.transmission = straight->at("transmission").vector_within(0.0F, 1.0F);
    material.extinction = read_rates(straight->at("extinction"), false);
    return material;
  }
  scatters->allow({"absorption", "scattering", "ior"});
  material.absorption = read_rates(scatters->at("absorption"), false);
  material.scattering = read_rates(scatters->at("scattering"), true);
  material.ior = kDefaultIor;
  scatters->take("ior", material.ior, &JsonReader::number, static_cast<double>(kLeastIor),
                 static_cast<double>(kLargestIor), "an index of refraction from 1 to 3");
  return material;
}

MaterialChange read_material(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw) {
  MaterialChange change;
  change.reflection = read_reflection(reader);
  change.gloss = read_gloss(reader);
  read_brdf(reader, folder, on_flaw, change);
  if (const auto map = reader.find("normal_map")) {
    change.normal_map = std::make_shared<NormalMap>(read_normal_map(beside(folder, map->text()), on_flaw));
  }
  reader.take("emission", change.emission, &JsonReader::vector_within, 0.0F, std::numeric_limits<float>::max());
  change.translucence = read_translucence(reader);
  if (const auto sides = reader.find("sides"); change.translucence && sides && sides->integer(1, 2) == 2) {
    sides->expected("one side of a body that lets light through");
  }
  reader.take("sides", change.is_two_sided, [](const JsonReader& value) { return value.integer(1, 2) == 2; });
  return change;
}

MaterialChanges read_materials(const JsonReader& mesh, const std::string& folder, OnFlaw on_flaw) {
  MaterialChanges changes;
  changes.all = read_material(mesh, folder, on_flaw);
  if (const auto materials = mesh.find("materials")) {
    for (const auto& [name, material] : materials->members()) {
      material.allow({"albedo", "brdf", "emission", "exponent", "metallic", "mirror", "normal_map", "roughness",
                      "sides", "specular", "subsurface", "translucent"});
      changes.by_name[name] = read_material(material, folder, on_flaw);
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

// The albedo may be that of the file, so that only the finished mesh tells.
void check_reflectance(const JsonReader& reader, const Soup& soup) {
  constexpr float kRounding = 1e-6F;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Finish& finish = soup.finishes[soup.finish_of(f)];
    for (const std::uint32_t v : soup.faces[f]) {
      const Eigen::Vector3f sum = soup.albedo[v] + finish.mirror + finish.gloss.specular;
      if (!finish.gloss.specular.isZero(0.0F) && sum.maxCoeff() > 1.0F + kRounding) {
        reader.expected(fmt::format(
            "reflectances of at most 1 together: with its albedo and mirror, `specular` makes {:.4g}", sum.maxCoeff()));
      }
    }
  }
}

double largest(const std::vector<Eigen::Vector3d>& positions) {
  const Eigen::AlignedBox3d box = bounding_box(positions);
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

double mean_edge(const Soup& soup) {
  double sum = 0.0;
  for (const Face& face : soup.faces) {
    for (std::size_t k = 0; k < 3; ++k) sum += (soup.positions[face[(k + 1) % 3]] - soup.positions[face[k]]).norm();
  }
  return sum / (3.0 * static_cast<double>(soup.faces.size()));
}

// Single precision carries a shape if it rounds positions by less than kFine of a mean edge; by a whole one, nothing is
// left of the shape.
void report_rounding(const Soup& soup, const Frame& frame, const std::string& name, OnFlaw on_flaw) {
  constexpr double kFine = 1e-3;
  const double in_file = soup.rounding / frame.unit;
  const double in_scene = kSingleRounding * largest(soup.positions);
  const double edges = (in_file + in_scene) / mean_edge(soup);
  if (!(edges > kFine)) return;
  const std::string flaw =
      fmt::format("{}: single precision rounds its positions by up to {:.2g}, {:.2g} of its mean edge; expected {}",
                  name, (in_file + in_scene) * frame.unit, edges,
                  in_file > in_scene ? "a file with its origin near the mesh (`translate` moves it)"
                                     : "meshes nearer to each other, or a bake of each");
  if (edges > 1.0) throw std::runtime_error(flaw);
  report_flaw(on_flaw, flaw);
}

}  // namespace

std::vector<JsonReader> material_readers(const JsonReader& mesh) {
  std::vector<JsonReader> readers = {mesh};
  if (const auto materials = mesh.find("materials")) {
    for (const auto& [name, material] : materials->members()) readers.push_back(material);
  }
  return readers;
}

Mesh finish_mesh(MeshPart part, const Frame& frame, OnFlaw on_flaw) {
  Soup& soup = part.soup;
  const std::string& name = part.name;
  for (Eigen::Vector3d& p : soup.positions) p = frame.local(p).cast<float>().cast<double>();
  const std::size_t all = soup.faces.size();
  if (const std::size_t dropped = drop_faces_without_area(soup); dropped > 0) {
    if (soup.faces.empty()) throw std::runtime_error(fmt::format("{}: none of the {} faces has an area", name, all));
    report_flaw(on_flaw, fmt::format("{}: {} of {} faces have no area (dropped)", name, dropped, all));
  }
  report_rounding(soup, frame, name, on_flaw);
  if (const std::size_t made = complete_normals(soup, part.crease_degrees); made > 0) {
    report_flaw(on_flaw, fmt::format("{}: {} vertex normals are zero or not finite (made from the faces)", name, made));
  }
  if (const std::size_t turned = turn_faces_to_normals(soup); turned > 0) {
    report_flaw(on_flaw, fmt::format("{}: {} of {} faces are wound against their normals (turned)", name, turned,
                                     soup.faces.size()));
  }
  Mesh mesh = weld(soup, part.file_vertices);
  mesh.frame = frame;
  std::vector<std::uint32_t> origins(mesh.faces.size());
  std::iota(origins.begin(), origins.end(), 0U);
  if (part.max_edge > 0.0) {
    const auto limit = static_cast<float>(part.max_edge / frame.unit);
    origins = tessellate(
        mesh, [&](const Eigen::Vector3f&) { return limit; }, name);
  }
  std::vector<std::uint8_t> is_two_sided;
  for (const std::uint32_t face : origins) {
    is_two_sided.push_back(soup.finishes[soup.finish_of(face)].is_two_sided ? 1 : 0);
  }
  const std::size_t fronts = mesh.faces.size();
  if (std::count(is_two_sided.begin(), is_two_sided.end(), 1) > 0) {
    add_backs(mesh, is_two_sided);
    for (std::size_t f = 0; f < fronts; ++f) {
      if (is_two_sided[f] != 0) origins.push_back(std::uint32_t{origins[f]});
    }
  }
  mesh.nodes = soup.nodes;
  for (std::uint32_t f = 0; f < origins.size() && !mesh.nodes.empty(); ++f) {
    take_face(mesh.nodes[soup.node_of(origins[f])], f);
  }
  std::vector<std::uint32_t> texels;
  if (part.texels > 0) texels = add_atlas(mesh, fronts, part.texels, name);
  vary_materials(soup, origins, texels, mesh);
  return mesh;
}

Shapes::Shapes(const JsonReader& meshes) {
  for (const JsonReader& entry : meshes.items()) ++shapes_[key(entry)].entries;
}

std::string Shapes::key(const JsonReader& reader) {
  nlohmann::json entry = reader.json();
  for (const char* placed : {"transform", "up", "max_edge", "crease", "flip", "texels"}) {
    if (entry.is_object()) entry.erase(placed);
  }
  return entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

ImportedMesh Shapes::take(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw) {
  Shape& shape = shapes_[key(reader)];
  if (!shape.read) shape.read = read_shape(reader, folder, read_materials(reader, folder, on_flaw));
  if (--shape.entries > 0) return *shape.read;
  return std::move(*shape.read);
}

MeshPart read_mesh(const JsonReader& reader, const std::string& folder, OnFlaw on_flaw, Shapes& shapes) {
  reader.allow({"file",     "primitive", "segments", "transform", "up",         "albedo",     "mirror", "specular",
                "exponent", "roughness", "metallic", "brdf",      "normal_map", "emission",   "sides",  "materials",
                "max_edge", "crease",    "flip",     "texels",    "subsurface", "translucent"});
  MeshPart part;
  part.crease_degrees = kDefaultCrease;
  for (const JsonReader& material : material_readers(reader)) {
    if (const auto map = material.find("normal_map"); map && part.normal_map_entry.empty()) {
      part.normal_map_entry = map->place();
    }
  }
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  std::optional<UpAxis> up;
  bool is_flipped = false;
  reader.take("max_edge", part.max_edge, &JsonReader::positive);
  reader.take("crease", part.crease_degrees, &JsonReader::number, 0.0, 180.0, "degrees from 0 to 180");
  reader.take("transform", map, read_transform);
  reader.take("up", up, [](const JsonReader& value) {
    return value.one_of({"y", "z"}) == "y" ? UpAxis::kY : UpAxis::kZ;
  });
  ImportedMesh shape = shapes.take(reader, folder, on_flaw);
  check_material_names(reader, shape.materials);
  reader.take("flip", is_flipped, &JsonReader::boolean);
  reader.take("texels", part.texels, &JsonReader::integer, 1, kMostTexelsAlong);
  const auto file = reader.find("file");
  part.name = file ? beside(folder, file->text()) : reader.at("primitive").text();
  for (const std::string& line : shape.unread) report_flaw(on_flaw, fmt::format("{}: {}", part.name, line));
  check(shape.soup, part.name);
  check_reflectance(reader, shape.soup);
  transform(shape.soup, up.value_or(shape.up) == UpAxis::kY ? map * stand_up() : map);
  if (is_flipped) turn_inside_out(shape.soup);
  part.soup = std::move(shape.soup);
  if (part.texels == 0) part.soup.chart.clear();
  part.file_vertices = shape.file_vertices;
  return part;
}

}  // namespace sh::prt
