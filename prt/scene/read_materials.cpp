// Reads a scene's changes to the materials of a mesh.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "prt/scene/scene_parts.hpp"

namespace sh::prt {
namespace {

// A mirror has no albedo unless the scene gives one.
std::optional<Reflection> read_reflection(const JsonReader& reader) {
  const auto albedo = reader.find("albedo");
  const auto mirror = reader.find("mirror");
  if (!albedo && !mirror) return std::nullopt;
  Reflection reflection;
  if (albedo) reflection.albedo = albedo->vector(0.0F, 1.0F);
  if (mirror) {
    reflection.mirror = mirror->vector(0.0F, 1.0F);
    constexpr float kRounding = 1e-6F;
    if ((reflection.albedo + reflection.mirror).maxCoeff() > 1.0F + kRounding) {
      mirror->expected("a reflectance that is at most 1 together with the albedo");
    }
  }
  return reflection;
}

MaterialChange read_material(const JsonReader& reader) {
  MaterialChange change;
  change.reflection = read_reflection(reader);
  reader.take("emission", change.emission,
              [](const JsonReader& value) { return value.vector(0.0F, std::numeric_limits<float>::max()); });
  reader.take("sides", change.is_two_sided, [](const JsonReader& value) { return value.integer(1, 2) == 2; });
  return change;
}

}  // namespace

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

}  // namespace sh::prt
